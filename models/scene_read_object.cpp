#include <fmt/core.h>

#include "models/scene_read.h"
#include "models/utf8.h"

namespace glint {
namespace {

constexpr Range crease_range{0, 180, "0 to 180"};
constexpr Range shininess_range{0, 10'000, "0 to 10000"};
constexpr Range roughness_range{0, 1, "0 to 1"};

MeshFile read_mesh_file(const Node& node) {
    const std::string& path = text(node, "the name of a mesh file");
    if (path.empty()) node.fail("an empty file name", "the name of a mesh file");
    if (path.find('\0') != std::string::npos)
        node.fail("a file name with a zero byte", "the name of a mesh file");
    return {unescaped_bytes(path)};
}

MeshSource read_source(const Node& node) {
    node.allow_keys({"file", "primitive", "detail"});
    if (node.has("file") && node.has("primitive"))
        node.fail("both \"file\" and \"primitive\"", "one of the two");
    if (node.has("file") && node.has("detail"))
        node.fail("\"detail\" beside \"file\"", "it for a primitive only");
    if (node.has("file")) {
        MeshFile file;
        node.with("file", [&](const Node& at) { file = read_mesh_file(at); });
        return file;
    }
    PrimitiveMesh mesh;
    read_enum(node, "primitive", mesh.primitive);
    mesh.detail = default_detail(mesh.primitive);
    node.with("detail",
              [&](const Node& at) { mesh.detail = whole_number(at, 1, max_detail(mesh.primitive)); });
    return mesh;
}

Transform read_transform(const Node& node) {
    Transform t;
    node.allow_keys({"translate", "rotate_deg", "scale"});
    read(node, "translate", t.translate);
    read(node, "rotate_deg", t.rotate_deg);
    node.with("scale", [&](const Node& at) {
        const std::vector<double> s = numbers(at, 3, 3);
        t.scale = glm::vec3(s[0], s[1], s[2]);
        for (std::size_t i = 0; i < 3; ++i)
            if (t.scale[static_cast<int>(i)] == 0)
                Node(at.value()[i], at, i).fail("a scale of 0", "a number other than 0 (below 0 mirrors)");
    });
    return t;
}

NormalOptions read_normals(const Node& node) {
    NormalOptions n;
    node.allow_keys({"source", "weighting", "crease_deg"});
    read_enum(node, "source", n.source);
    read_enum(node, "weighting", n.weighting);
    read(node, "crease_deg", n.crease_deg, crease_range);
    return n;
}

Material read_material(const Node& node) {
    Material m;
    node.allow_keys({"ambient", "diffuse", "specular", "emission", "shininess", "roughness", "f0"});
    read(node, "ambient", m.ambient, at_least_zero);
    read(node, "diffuse", m.diffuse, at_least_zero);
    read(node, "specular", m.specular, at_least_zero);
    read(node, "emission", m.emission, at_least_zero);
    read(node, "shininess", m.shininess, shininess_range);
    read(node, "roughness", m.roughness, roughness_range);
    read(node, "f0", m.f0, at_least_zero);
    return m;
}

}  // namespace

Object read_object(const Node& node) {
    Object o;
    node.allow_keys({"name", "mesh", "transform", "normals", "material"});
    read(node, "name", o.name);
    node.with("mesh", [&](const Node& at) { o.source = read_source(at); });
    node.with("transform", [&](const Node& at) { o.transform = read_transform(at); });
    node.with("normals", [&](const Node& at) { o.normals = read_normals(at); });
    node.with("material", [&](const Node& at) { o.material = read_material(at); });
    return o;
}

}  // namespace glint
