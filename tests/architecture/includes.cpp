#include "tests/architecture/includes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <sstream>

namespace {

using std::string_view;

/// The layers, from the bottom up; a file may include files of its own layer and those below. A layer is a
/// file, a folder with all its contents, or, with a star, only the files in a folder. The longest match wins.
constexpr std::array<string_view, 35> layers{
    "models/*",
    "models/io/",
    "models/json/",
    "models/mesh/",
    "models/scene/",
    "models/fields/",
    "models/gltf/",
    "models/scene_file/",
    "renderer/picture.h",
    "renderer/threads.h",
    "renderer/simd/",
    "renderer/lighting/",
    "renderer/geometry/",
    "renderer/visibility/",
    "renderer/surface/",
    "renderer/strokes/",
    "renderer/shade/",
    "renderer/transport/",
    "renderer/stages.h",
    "renderer/explain/",
    "renderer/simd/isa/",
    "renderer/*",
    "renderer/image/",
    "renderer/reflectance/",
    "renderer/debug_views/",
    "renderer/answers/",
    "programs/",
    "shader/",
    "diagnose/search/",
    "diagnose/",
    "lessons/",
    "ui/widgets/",
    "ui/",
    "ui/features/",
    "app/",
};

std::optional<std::size_t> layer_of(string_view path) {
    std::optional<std::size_t> found;
    std::size_t longest = 0;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const bool star = layers[i].ends_with('*');
        const string_view start = star ? layers[i].substr(0, layers[i].size() - 1) : layers[i];
        if (!path.starts_with(start) || start.size() <= longest) continue;
        if (star && path.find('/', start.size()) != path.npos) continue;
        found = i;
        longest = start.size();
    }
    return found;
}

bool begins_with_one_of(string_view name, std::initializer_list<string_view> prefixes) {
    return std::any_of(prefixes.begin(), prefixes.end(), [&](string_view p) { return name.starts_with(p); });
}

bool is_gl_or_window(string_view name) {
    return begins_with_one_of(
        name, {"GL/", "GLES", "EGL/", "KHR/", "GLFW/", "epoxy/", "glad/", "X11/", "imgui_impl"});
}

/// Why `path` may not include `name`; empty if it may.
std::string complaint(string_view path, string_view name, bool quoted) {
    const auto from = layer_of(path), to = layer_of(name);
    if (!from) return "is included by a file that is not in any layer";
    if (quoted && !to) return "is not in any layer";
    if (to && *to > *from)
        return "points up from " + std::string(layers[*from]) + " to " + std::string(layers[*to]);
    const bool is_offscreen = path.starts_with("shader/") && name.starts_with("epoxy/");
    if (!path.starts_with("app/") && !is_offscreen && is_gl_or_window(name))
        return "uses GL, GLFW or a window below app";
    if (!path.starts_with("app/") && !path.starts_with("ui/") && name.starts_with("imgui"))
        return "uses ImGui below ui";
    if (name.starts_with("OpenMesh/") && path != "models/mesh/resolution/resolution.cpp")
        return "uses OpenMesh outside models/mesh/resolution";
    // Each of these headers takes seconds to compile.
    if (name == "nlohmann/json.hpp" && path != "models/json/json.h")
        return "only models/json/json.h may include; include that header instead";
    if (name.starts_with("CLI/") && path != "app/options.cpp")
        return "only app/options.cpp may include; include app/options.h instead";
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
    std::map<std::string, std::string> reached{{from, ""}};  // each file, and the file that includes it
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
