// Reads the container (.glb or JSON text), its JSON and its buffers.

#include "models/gltf/gltf_document.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <map>
#include <optional>

#include "models/gltf/gltf.h"
#include "models/io/file.h"
#include "models/mesh/formats/mesh_reader.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t glb_magic = 0x46546C67, json_chunk = 0x4E4F534A, bin_chunk = 0x004E4942;

[[noreturn]] void fail(const std::string& what, const std::string& expected) {
    throw ProblemFound({"", "", what, expected});
}

/// The two chunks of a .glb. The length in the header may disagree with the file's length, because each chunk
/// states its own.
struct Chunks {
    std::string_view json, bin;
    bool has_bin = false;
};
Chunks chunks_of(std::string_view bytes, std::vector<std::string>& warnings) {
    constexpr std::size_t header = 12, chunk_header = 8;
    const auto number = [&](std::size_t at) { return little_endian(bytes.data() + at, 4); };
    if (bytes.size() < header + chunk_header) fail("the file ends in its header", "a complete .glb file");
    if (number(4) != 2) fail(fmt::format("the container has version {}", number(4)), "2");
    const std::uint64_t length = bytes.size();
    if (number(8) != length)
        warnings.push_back(fmt::format("the length in the header, {} bytes, is ignored: the file has {}",
                                       number(8), length));
    Chunks chunks;
    std::size_t at = header;
    for (int i = 0; i < 2 && at + chunk_header <= length; ++i) {
        const std::uint64_t size = number(at), type = number(at + 4);
        at += chunk_header;
        if (size > length - at)
            fail(fmt::format("chunk {} claims {} bytes, but {} are left", i, size, length - at),
                 "a complete chunk");
        const std::string_view chunk = bytes.substr(at, size);
        if (i == 0 && type != json_chunk) fail("the first chunk is not JSON", "a chunk of the type JSON");
        if (i == 0) chunks.json = chunk;
        if (i == 1 && type == bin_chunk) {
            chunks.bin = chunk;
            chunks.has_bin = true;
        }
        at += size + (4 - size % 4) % 4;
    }
    return chunks;
}

int base64_digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+' || c == '-') return 62;
    return c == '/' || c == '_' ? 63 : -1;
}
std::string from_base64(const Node& node, std::string_view text) {
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    while (text.ends_with('=')) text.remove_suffix(1);
    for (const char c : text) {
        const int digit = base64_digit(c);
        if (digit < 0)
            node.fail("the data URI contains a character that is not base64", "letters, digits, + and /");
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xFF);
    }
    return bytes;
}

/// "a%20b" -> "a b".
std::string unescaped_uri(const Node& node, const std::string& uri) {
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned byte = 0;
        const char* const after = uri.data() + i + 3;
        if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(after - 2, after, byte, 16).ptr == after) {
            path += static_cast<char>(byte);
            i += 2;
        } else {
            path += uri[i];
        }
    }
    // A downloaded file must not read files elsewhere on this machine.
    const fs::path file(path);
    const bool leads_away = file.is_absolute() || std::any_of(file.begin(), file.end(),
                                                              [](const fs::path& p) { return p == ".."; });
    if (leads_away || path.find('\0') != std::string::npos || lower_extension(path) != ".bin")
        node.fail(in_quotes(uri) + " is not a buffer that may be opened",
                  "a .bin file in the same folder or below it, or a data URI");
    return path;
}

std::string bytes_of_data_uri(const Node& node) {
    const std::string& uri = text(node);
    const std::size_t comma = uri.find(',');
    if (comma == std::string::npos || !std::string_view(uri).substr(0, comma).ends_with(";base64"))
        node.fail("the data URI has no \";base64,\"", "data:application/octet-stream;base64,...");
    return from_base64(node, std::string_view(uri).substr(comma + 1));
}

std::string bytes_of_file(const Node& node, const std::string& file, std::size_t max_bytes) {
    Result<std::string> read = read_file(file, max_bytes);
    if (const Problem* problem = problem_of(read))
        node.fail(fmt::format("{}: {}", in_quotes(text(node)), problem->what), problem->expected);
    return std::get<std::string>(std::move(read));
}

/// Reads the buffers listed at the root. A file named by several buffers is read and stored only once.
class BufferReader {
  public:
    BufferReader(GltfDocument& document, const Chunks& chunks) : document_(document), chunks_(chunks) {}

    void read_all() {
        const Node root(document_.root);
        root.with("buffers", [this](const Node& list) {
            list.each(max_json_values, "buffers", [this](const Node& buffer) { read(buffer); });
        });
        for (const Place& place : places_)
            document_.buffers.push_back(held_at(place).substr(0, place.length));
    }

  private:
    /// Locates a buffer's bytes by index, because `document_.own` may reallocate while it grows.
    struct Place {
        std::optional<std::size_t> own;  // index into `document_.own`; none: in the binary chunk
        std::uint64_t length = 0;
    };

    std::string_view held_at(const Place& place) const {
        return place.own ? std::string_view(document_.own[*place.own]) : chunks_.bin;
    }

    void read(const Node& buffer) {
        require_object(buffer);
        Place place;
        place.length = whole(buffer, "byteLength", 9e15);
        if (!buffer.has("uri") && (!places_.empty() || !chunks_.has_bin))
            buffer.fail("it has no \"uri\" and there is no binary chunk for it", "a URI");
        buffer.with("uri", [&](const Node& uri) { place.own = own_of(uri); });
        const std::size_t held = held_at(place).size();
        if (held < place.length)
            buffer.fail(fmt::format("its data has {} bytes", held),
                        fmt::format("{}, its byteLength", place.length));
        places_.push_back(place);
    }

    std::size_t own_of(const Node& uri) {
        if (text(uri).starts_with("data:")) return keep(bytes_of_data_uri(uri));
        const fs::path file = fs::path(document_.path).parent_path() / unescaped_uri(uri, text(uri));
        std::error_code error;
        const fs::path canonical = fs::weakly_canonical(file, error);
        const auto [known, is_new] = own_of_file_.try_emplace(error ? file.lexically_normal() : canonical);
        if (is_new) known->second = keep(bytes_of_file(uri, file.string(), max_mesh_file_bytes - own_bytes_));
        return known->second;
    }

    std::size_t keep(std::string bytes) {
        own_bytes_ += bytes.size();
        document_.own.push_back(std::move(bytes));
        return document_.own.size() - 1;
    }

    GltfDocument& document_;
    const Chunks& chunks_;
    std::vector<Place> places_;
    std::size_t own_bytes_ = 0;                    // total size of all external files and data URIs
    std::map<fs::path, std::size_t> own_of_file_;  // keyed by path, with links and dots resolved
};

bool is_quantized(const Node& root) {
    bool is_named = false;
    for (const char* list : {"extensionsUsed", "extensionsRequired"})
        root.with(list, [&](const Node& names) {
            names.each(max_json_values, "names", [&](const Node& name) {
                is_named = is_named || text(name) == "KHR_mesh_quantization";
            });
        });
    return is_named;
}

/// Whether an extension affects only data that is not read: images, animations, and the appearance of
/// materials.
bool leaves_shapes(std::string_view name) {
    constexpr std::array<std::string_view, 6> words{"_materials_", "_texture_",   "_techniques_",
                                                    "_image",      "_animation_", "_xmp"};
    return std::any_of(words.begin(), words.end(),
                       [name](std::string_view word) { return name.find(word) != std::string_view::npos; });
}

/// Fails for required extensions that change the shapes and are not supported.
void check_extensions(const Node& root) {
    constexpr std::array<std::string_view, 3> read{"KHR_lights_punctual", "KHR_mesh_quantization",
                                                   "EXT_mesh_gpu_instancing"};
    root.with("extensionsRequired", [&](const Node& list) {
        list.each(1000, "names", [&](const Node& node) {
            const std::string& name = text(node);
            if (!leaves_shapes(name) && std::find(read.begin(), read.end(), name) == read.end())
                node.fail(in_quotes(name) + " is required but not supported",
                          "a file without that extension");
        });
    });
}

void check_version(const Node& root) {
    require_object(root);
    if (!root.has("asset")) root.fail("the key \"asset\" is missing", "{\"asset\": {\"version\": \"2.0\"}}");
    with_object(root, "asset", [](const Node& asset) {
        std::string version;
        read(asset, "version", version);
        if (!version.starts_with("2.")) asset.fail("its version is " + in_quotes(version), "2.0");
        asset.with("minVersion", [](const Node& least) {
            if (text(least) != "2.0" && !text(least).starts_with("1."))
                least.fail("reading it requires version " + in_quotes(text(least)), "2.0");
        });
    });
}

}  // namespace

bool is_gltf_path(const std::string& path) {
    const std::string extension = lower_extension(path);
    return extension == ".gltf" || extension == ".glb";
}

Result<GltfFile> GltfFile::read(const std::string& path) {
    Result<std::string> bytes = read_file(path, max_mesh_file_bytes);
    if (const Problem* problem = problem_of(bytes)) return *problem;
    return parse(std::get<std::string>(std::move(bytes)), path);
}

namespace {

/// Returns the list with that key, or an empty one. Malformed values are reported by the code that reads
/// them.
const Json& list_of(const Json& value, const char* key) {
    static const Json none = Json::array();
    const auto found = value.is_object() ? value.find(key) : value.end();
    return found != value.end() && found->is_array() ? *found : none;
}

std::vector<std::size_t> first_parts_of(const Json& root) {
    std::vector<std::size_t> first{0};
    for (const Json& mesh : list_of(root, "meshes"))
        first.push_back(first.back() + list_of(mesh, "primitives").size());
    return first;
}

/// The key of a primitive's vertices; nullopt if they are malformed.
std::optional<GltfVertexKey> sound_key_of(const GltfDocument& document, const Node& root,
                                          const Node& attributes) {
    try {
        return vertex_key_of(document, root, attributes);
    } catch (const ProblemFound&) {
        return {};
    }
}

/// Finds the vertices that several primitives use. Fails if overlapping accessors refer to many times more
/// vertices than the buffers contain, because reading them would take too long.
std::set<GltfVertexKey> shared_vertices_of(const GltfDocument& document) {
    constexpr std::uint64_t most_times = 64;
    std::uint64_t bytes_there = document.bytes.size(), bytes_named = 0;
    for (const std::string& own : document.own) bytes_there += own.size();
    std::set<GltfVertexKey> named, shared;
    const Node root(document.root);
    for (const Json& mesh : list_of(document.root, "meshes"))
        for (const Json& primitive : list_of(mesh, "primitives")) {
            const auto attributes = primitive.is_object() ? primitive.find("attributes") : primitive.end();
            if (attributes == primitive.end() || !attributes->is_object()) continue;
            const std::optional<GltfVertexKey> key = sound_key_of(document, root, Node(*attributes));
            if (!key) continue;
            if (!named.insert(*key).second)
                shared.insert(*key);
            else
                bytes_named += key->first.bytes() + key->second.bytes();
            if (bytes_named / most_times > bytes_there)
                fail(fmt::format(
                         "its primitives refer to at least {} bytes of vertices, but its buffers have {}",
                         bytes_named, bytes_there),
                     fmt::format("at most {} times as many", most_times));
        }
    return shared;
}

}  // namespace

Result<GltfFile> GltfFile::parse(std::string bytes, const std::string& path) {
    return result_of(path, [&]() -> Result<GltfFile> {
        const auto document = std::make_shared<GltfDocument>();
        document->path = path;
        document->bytes = std::move(bytes);
        const std::string_view all = document->bytes;
        if (all.empty()) return Problem{path, "", "the file is empty", "glTF 2.0"};
        Chunks chunks{all, {}};
        if (all.size() >= 4 && little_endian(all.data(), 4) == glb_magic)
            chunks = chunks_of(all, document->warnings);
        document->root = parsed_json(chunks.json, path);
        const Node root(document->root);
        check_version(root);
        check_extensions(root);
        document->is_quantized = is_quantized(root);
        BufferReader(*document, chunks).read_all();
        document->first_parts = first_parts_of(document->root);
        document->shared_vertices = shared_vertices_of(*document);
        return GltfFile(document);
    });
}

}  // namespace glint
