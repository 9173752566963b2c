#include "tests/architecture/includes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <sstream>

namespace {

using std::string_view;

/// From the top of the house to the ground.
constexpr std::array<string_view, 4> floors{"app", "ui", "renderer", "models"};

/// The rooms of the renderer, each before those that may include it: a file; a folder with all in it; or,
/// with a star, the files of a folder itself.
constexpr std::array<string_view, 18> rooms{
    "renderer/picture.h",        "renderer/simd/",       "renderer/lighting/",
    "renderer/geometry/",        "renderer/visibility/", "renderer/surface/",
    "renderer/strokes/",         "renderer/shade/",      "renderer/stages.h",
    "renderer/inspect/explain/", "renderer/kernels/",    "renderer/*",
    "renderer/image/",           "renderer/inspect/",    "renderer/diagnose/search/",
    "renderer/diagnose/",        "renderer/lessons/",    "renderer/programs/",
};

std::optional<std::size_t> room_of(string_view path) {
    std::optional<std::size_t> found;
    std::size_t longest = 0;
    for (std::size_t i = 0; i < rooms.size(); ++i) {
        const bool star = rooms[i].ends_with('*');
        const string_view start = star ? rooms[i].substr(0, rooms[i].size() - 1) : rooms[i];
        if (!path.starts_with(start) || start.size() <= longest) continue;
        if (star && path.find('/', start.size()) != path.npos) continue;
        found = i;
        longest = start.size();
    }
    return found;
}

/// Why one file of the renderer may not include another.
std::string complaint_inside(string_view path, string_view name) {
    const auto from = room_of(path), to = room_of(name);
    if (!from) return "is included by a file in none of the renderer's rooms";
    if (!to) return "is in none of the renderer's rooms";
    if (*to > *from)
        return "is in a later room; expected simd -> lighting -> geometry -> visibility -> surface -> "
               "strokes "
               "-> shade -> inspect -> diagnose -> lessons";
    return {};
}

std::optional<std::size_t> floor_of(string_view path) {
    const string_view folder = path.substr(0, path.find('/'));
    const auto* at = std::find(floors.begin(), floors.end(), folder);
    if (folder.size() == path.size() || at == floors.end()) return std::nullopt;
    return static_cast<std::size_t>(at - floors.begin());
}

bool begins_with_one_of(string_view name, std::initializer_list<string_view> prefixes) {
    return std::any_of(prefixes.begin(), prefixes.end(), [&](string_view p) { return name.starts_with(p); });
}

bool is_gl_or_window(string_view name) {
    return begins_with_one_of(
        name, {"GL/", "GLES", "EGL/", "KHR/", "GLFW/", "epoxy/", "glad/", "X11/", "imgui_impl"});
}

/// Why `path` may not include `name`; empty when it may.
std::string complaint(string_view path, string_view name, bool quoted) {
    const auto from = floor_of(path), to = floor_of(name);
    if (!from) return {};
    if (quoted && !to) return "is not written from the root of the project";
    if (to && *to < *from) return "points up; expected app -> ui -> renderer -> models";
    if (floors[*from] == "renderer" && from == to) {
        if (std::string why = complaint_inside(path, name); !why.empty()) return why;
    }
    if (path.starts_with("ui/widgets/") && name.starts_with("ui/") && !name.starts_with("ui/widgets/"))
        return "is not a widget; expected ui/widgets/ to stand by itself";
    if (*from > 0 && is_gl_or_window(name)) return "brings GL, GLFW or a window below app";
    if (*from > 1 && name.starts_with("imgui")) return "brings ImGui below ui";
    // models/fineness shares its half-edges among its files, and with nobody else.
    const bool in_source = path.starts_with("models/") && path.ends_with(".cpp");
    if (name.starts_with("OpenMesh/") && !in_source && path != "models/fineness/half_edges.h")
        return "brings OpenMesh out of models/*.cpp";
    if (name == "models/fineness/half_edges.h" && !path.starts_with("models/fineness/"))
        return "brings OpenMesh out of models/fineness";
    // Each takes a file that includes it seconds to compile.
    if (name.starts_with("nlohmann/") && !path.starts_with("models/"))
        return "is for models; expected models/json/json_value.h";
    if (name.starts_with("CLI/") && path != "app/options.cpp")
        return "is for app/options.cpp; expected app/options.h";
    return {};
}

}  // namespace

std::vector<std::string> forbidden_includes(string_view path, string_view text) {
    static const std::regex include(R"(^\s*#\s*include\s*(["<])([^">]*)[">].*)");
    std::vector<std::string> found;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::smatch match;
        if (!std::regex_match(line, match, include)) continue;
        const std::string name = match[2];
        const std::string why = complaint(path, name, match[1] == "\"");
        if (why.empty()) continue;
        std::ostringstream text_of_line;
        text_of_line << path << ":" << number << ": includes " << name << ", which " << why;
        found.push_back(text_of_line.str());
    }
    return found;
}

std::vector<std::string> way_of_includes(const std::map<std::string, std::string>& files,
                                         const std::string& from, const std::string& to) {
    static const std::regex include(R"re((?:^|\n)\s*#\s*include\s*"([^"]+)")re");
    std::map<std::string, std::string> reached{{from, ""}};  // and by which file
    std::vector<std::string> next{from};
    while (!next.empty() && !reached.contains(to)) {
        const std::string file = next.back();
        next.pop_back();
        const auto at = files.find(file);
        if (at == files.end()) continue;
        for (std::sregex_iterator i(at->second.begin(), at->second.end(), include), end; i != end; ++i)
            if (reached.emplace((*i)[1], file).second) next.push_back((*i)[1]);
    }
    std::vector<std::string> way;
    if (reached.contains(to))
        for (std::string file = to; !file.empty(); file = reached[file]) way.insert(way.begin(), file);
    return way;
}
