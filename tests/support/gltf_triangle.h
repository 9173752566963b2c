#pragma once
// A one-triangle glTF file for tests to damage on purpose, and the resulting error message.

#include <stdexcept>
#include <string>

#include "models/scene_file/scene_file.h"
#include "tests/support/program.h"

namespace glint::gltf_triangle {

/// A triangle in 36 bytes, with a normal, as a .glb written by Glint.
inline std::string triangle_glb() {
    const TemporaryDirectory folder;
    const std::string obj = folder.file("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto document = std::get<SceneDocument>(open_document(obj));
    return std::get<GltfWritten>(glb_of(document.scene, "t")).bytes;
}

inline constexpr const char* triangle = R"({"asset": {"version": "2.0"},
 "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri":
   "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";

inline std::string changed(const std::string& from, const std::string& to) {
    std::string text = triangle;
    const std::size_t at = text.find(from);
    if (at == text.npos) throw std::runtime_error("text to replace not found: " + from);
    return text.replace(at, from.size(), to);
}

inline std::string error_of(const std::string& bytes, const std::string& name = "t.gltf") {
    const TemporaryDirectory folder;
    const Result<SceneDocument> opened = open_document(folder.file(name, bytes));
    const Problem* problem = problem_of(opened);
    if (problem == nullptr) return "";
    const std::string text = problem->text();
    return text.starts_with(folder.path() + "/") ? text.substr(folder.path().size() + 1) : text;
}

}  // namespace glint::gltf_triangle
