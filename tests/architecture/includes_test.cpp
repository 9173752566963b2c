#include "tests/architecture/includes.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "tests/places.h"
#include "tests/support/catch.h"

namespace fs = std::filesystem;

TEST_CASE("includes only point down, and GL, GLFW, ImGui and OpenMesh stay in their folders",
          "[architecture]") {
    const fs::path root = glint::project_folder;
    std::vector<std::string> found;
    int files = 0;
    for (const char* folder :
         {"app", "ui", "lessons", "diagnose", "shader", "programs", "renderer", "models"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const auto extension = entry.path().extension();
            if (extension != ".h" && extension != ".cpp") continue;
            std::ostringstream text;
            text << std::ifstream(entry.path()).rdbuf();
            const auto more =
                forbidden_includes(fs::relative(entry.path(), root).generic_string(), text.str());
            found.insert(found.end(), more.begin(), more.end());
            ++files;
        }
    }
    CHECK(files > 10);
    for (const auto& line : found) FAIL_CHECK(line);
}

TEST_CASE("a layer that includes a higher one is reported", "[architecture]") {
    const auto reported = [](const char* path, const std::string& name) {
        return forbidden_includes(path, "#include \"" + name + "\"").size() == 1;
    };
    CHECK(reported("models/problem.cpp", "models/io/file.h"));
    CHECK(reported("models/json/json_node.h", "models/fields/choices.h"));
    CHECK(reported("models/mesh/formats/mesh_file.cpp", "models/gltf/gltf.h"));
    CHECK(reported("models/gltf/gltf_write.cpp", "models/scene_file/scene_file.h"));
    CHECK(reported("models/new_room/file.h", "models/problem.h"));
    CHECK_FALSE(reported("models/scene_file/load_meshes.cpp", "models/gltf/gltf.h"));
    CHECK_FALSE(reported("models/mesh/normals.h", "models/range.h"));
    CHECK(reported("renderer/simd/pow.h", "renderer/lighting/illuminate.h"));
    CHECK(reported("renderer/lighting/phong.h", "renderer/geometry/interpolate.h"));
    CHECK(reported("renderer/geometry/geometry.h", "renderer/visibility/binning.h"));
    CHECK(reported("renderer/surface/surface.h", "renderer/shade/lighting.h"));
    CHECK(reported("renderer/shade/lighting.h", "renderer/renderer.h"));
    CHECK(reported("renderer/explain/explain.h", "renderer/renderer.h"));
    CHECK(reported("renderer/renderer.h", "renderer/reflectance/lobes.h"));
    CHECK(reported("renderer/image/sheet.h", "diagnose/diagnose.h"));
    CHECK(reported("diagnose/search/score.h", "diagnose/diagnose.h"));
    CHECK(reported("renderer/renderer.h", "renderer/new_room/file.h"));
    CHECK(reported("renderer/new_room/file.h", "renderer/renderer.h"));
    CHECK(reported("renderer/renderer.h", "programs/program.h"));
    CHECK(reported("programs/program.h", "diagnose/diagnose.h"));
    CHECK(reported("programs/program.h", "shader/shader_text.h"));
    CHECK(reported("shader/shader_text.h", "diagnose/diagnose.h"));
    CHECK(reported("diagnose/diagnose.h", "lessons/quiz.h"));
    CHECK_FALSE(reported("renderer/shade/lighting.h", "renderer/picture.h"));
    CHECK_FALSE(reported("renderer/renderer.cpp", "renderer/explain/explain.h"));
    CHECK_FALSE(reported("renderer/reflectance/highlight.h", "renderer/renderer.h"));
    CHECK_FALSE(reported("renderer/surface/surface.h", "renderer/geometry/geometry.h"));
}

TEST_CASE("fields and handles do not include the window's state, not even indirectly", "[architecture]") {
    std::map<std::string, std::string> files;
    const fs::path root = glint::project_folder;
    for (const auto& entry : fs::recursive_directory_iterator(root / "ui")) {
        if (!entry.is_regular_file()) continue;
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        files[fs::relative(entry.path(), root).generic_string()] = text.str();
    }
    int asked = 0;
    for (const auto& [path, text] : files) {
        if (!path.starts_with("ui/fields/") && !path.starts_with("ui/picture/handles/")) continue;
        ++asked;
        std::string way;
        for (const std::string& file : way_of_includes(files, path, "ui/ui.h")) way += " > " + file;
        INFO("includes ui/ui.h:" << way);
        CHECK(way.empty());
    }
    CHECK(asked > 20);
    CHECK(way_of_includes({{"a.h", "#include \"b.h\""}, {"b.h", "// why\n#include \"c.h\"\n"}}, "a.h",
                          "c.h") == std::vector<std::string>{"a.h", "b.h", "c.h"});
    CHECK(way_of_includes({{"a.h", "#include \"b.h\""}}, "b.h", "a.h").empty());
}

TEST_CASE("no two headers define a class with the same name, which the linker could confuse",
          "[architecture]") {
    // Ignores specializations and classes in nested namespaces, which are indented or in a .cpp.
    const std::regex definition(R"(^(?:struct|class|enum class|enum)(?: alignas\(\d+\))? (\w+)[^;<]*\{.*)");
    std::map<std::string, std::string> header_of;
    for (const char* folder :
         {"app", "ui", "lessons", "diagnose", "shader", "programs", "renderer", "models"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(glint::project_folder) / folder)) {
            if (entry.path().extension() != ".h") continue;
            std::ifstream file(entry.path());
            for (std::string line; std::getline(file, line);) {
                std::smatch match;
                if (!std::regex_match(line, match, definition)) continue;
                const auto [at, is_new] = header_of.emplace(match[1], entry.path().string());
                INFO(match[1] << " is defined in " << at->second << " and in " << entry.path().string());
                CHECK(is_new);
            }
        }
    CHECK(header_of.size() > 100);
}

TEST_CASE("an upward include is reported with its file and line", "[architecture]") {
    CHECK(forbidden_includes("ui/panel.cpp", "#include <string>\n#include \"app/window/window.h\"\n") ==
          std::vector<std::string>{
              "ui/panel.cpp:2: includes app/window/window.h, which points up from ui/ to app/"});
    CHECK(forbidden_includes("models/a.h", "#include \"renderer/picture.h\"").size() == 1);
    CHECK(forbidden_includes("models/a.h", "  #  include <ui/widgets/theme.h>  // why").size() == 1);
    CHECK(forbidden_includes("renderer/a/b.cpp", "#include \"ui/widgets/theme.h\"").size() == 1);
    CHECK(forbidden_includes("renderer/a/b.cpp", "#include \"../../app/main.h\"").size() == 1);
    CHECK(forbidden_includes("ui/widgets/a.cpp", "#include \"ui/fields/panels.h\"").size() == 1);
    CHECK(forbidden_includes("ui/widgets/a.cpp", "#include \"ui/widgets/theme.h\"").empty());
}

TEST_CASE("libraries of the window are reported below their layer", "[architecture]") {
    CHECK(forbidden_includes("renderer/a.cpp", "#include <imgui.h>").size() == 1);
    CHECK(forbidden_includes("models/a.cpp", "#include <GL/gl.h>").size() == 1);
    CHECK(forbidden_includes("ui/a.cpp", "#include <GLFW/glfw3.h>").size() == 1);
    CHECK(forbidden_includes("shader/a.cpp", "#include <GLFW/glfw3.h>").size() == 1);
    CHECK(forbidden_includes("shader/a.cpp", "#include <epoxy/gl.h>").empty());
    CHECK(forbidden_includes("ui/a.cpp", "#include <epoxy/gl.h>").size() == 1);
    CHECK(forbidden_includes("ui/a.cpp", "#include <imgui_impl_opengl3.h>").size() == 1);
    CHECK(forbidden_includes("models/mesh/mesh.h", "#include <OpenMesh/Core/IO/MeshIO.hh>").size() == 1);
    CHECK(forbidden_includes("renderer/a.cpp", "#include <OpenMesh/Core/IO/MeshIO.hh>").size() == 1);
}

TEST_CASE("libraries that take seconds to compile are reported outside their wrapper files",
          "[architecture]") {
    CHECK(forbidden_includes("ui/files/a.cpp", "#include <nlohmann/json.hpp>").size() == 1);
    CHECK(forbidden_includes("ui/feature.h", "#include <nlohmann/json_fwd.hpp>").empty());  // only names
    CHECK(forbidden_includes("app/arguments.h", "#include <CLI/CLI.hpp>").size() == 1);
    CHECK(forbidden_includes("app/options.cpp", "#include <CLI/CLI.hpp>").empty());
    CHECK(forbidden_includes("models/json/json.h", "#include <nlohmann/json.hpp>").empty());
}

TEST_CASE("allowed includes are not reported", "[architecture]") {
    CHECK(forbidden_includes("app/window/window.cpp",
                             "#include <GLFW/glfw3.h>\n#include <imgui_impl_glfw.h>\n"
                             "#include \"ui/widgets/theme.h\"\n#include \"models/mesh/mesh.h\"")
              .empty());
    CHECK(forbidden_includes("ui/a.cpp", "#include <imgui.h>\n#include \"renderer/renderer.h\"").empty());
    CHECK(forbidden_includes("models/a.cpp", "#include <OpenMesh/Core/IO/MeshIO.hh>").empty());
    CHECK(forbidden_includes("models/a.cpp", "// #include \"app/window/window.h\"\nint x;").empty());
}
