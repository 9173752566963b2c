#include "models/mesh_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <new>

#include "models/file.h"
#include "models/mesh_reader.h"
#include "models/progress.h"

namespace glint {
namespace {

// Of 2^31 vertices at 8 bytes a line: beyond it no index fits.
constexpr std::size_t largest_file = std::size_t{16} << 30;

using Reader = Mesh (*)(std::string_view, const std::string&);
struct Format {
    std::string_view extension;
    Reader read;
};
constexpr std::array<Format, 5> formats{
    {{".obj", read_obj}, {".ply", read_ply}, {".off", read_off}, {".stl", read_stl}, {".om", read_om}}};

/// The reader for a path's extension, in any case; null when there is none.
Reader reader_for(const std::string& path) {
    const std::size_t dot = path.find_last_of("./");
    if (dot == std::string::npos || path[dot] == '/') return nullptr;
    std::string extension = path.substr(dot);
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const auto* found = std::find_if(formats.begin(), formats.end(),
                                     [&](const Format& f) { return f.extension == extension; });
    return found == formats.end() ? nullptr : found->read;
}

Result<Mesh> parse_since(std::chrono::steady_clock::time_point start, std::string_view bytes,
                         const std::string& path) {
    const Reader read = reader_for(path);
    if (read == nullptr)
        return Problem{path, "", "the extension is that of no mesh", ".obj, .ply, .off, .stl or .om", 0};
    if (bytes.empty()) return Problem{path, "", "the file is empty", "a mesh", 0};
    try {
        Mesh mesh = read(bytes, path);
        if (mesh.face_count() == 0) return Problem{path, "", "the mesh has no faces", "at least one", 0};
        finish_mesh(mesh);
        const auto time = std::chrono::steady_clock::now() - start;
        mesh.load_ms = std::chrono::duration<double, std::milli>(time).count();
        return mesh;
    } catch (const Unreadable& unreadable) {
        return unreadable.problem;
    } catch (const LoadCancelled&) {
        return Problem{path, "", cancelled_words, ""};
    } catch (const std::bad_alloc&) {
        return Problem{path, "", "the mesh does not fit in memory", "a smaller one", 0};
    }
}

}  // namespace

bool is_mesh_path(const std::string& path) { return reader_for(path) != nullptr; }

Result<Mesh> read_mesh(const std::string& path) {
    const auto start = std::chrono::steady_clock::now();
    const Result<std::string> bytes = read_file(path, largest_file);
    if (const Problem* problem = problem_of(bytes)) return *problem;
    return parse_since(start, std::get<std::string>(bytes), path);
}

Result<Mesh> parse_mesh(std::string_view bytes, const std::string& path) {
    return parse_since(std::chrono::steady_clock::now(), bytes, path);
}

void close_face(Mesh& mesh, const std::string& file, int line) {
    if (mesh.corner_position.size() > most_corners)
        throw Unreadable{
            {file, "", "the mesh has too many corners", fmt::format("at most {}", most_corners), line}};
    mesh.first_corner.push_back(static_cast<std::uint32_t>(mesh.corner_position.size()));
}

}  // namespace glint
