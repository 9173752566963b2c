// Converts the nodes of a file to objects, lights and a camera.
#include <fmt/core.h>

#include <cmath>
#include <glm/mat4x4.hpp>
#include <optional>

#include "models/gltf/gltf.h"
#include "models/gltf/gltf_document.h"
#include "models/gltf/gltf_items.h"
#include "models/gltf/gltf_nodes.h"

namespace glint {
namespace {

class SceneReader {
  public:
    SceneReader(const Node& root, const std::vector<std::size_t>& first_parts, const std::string& file_name)
        : root_(root), first_parts_(first_parts), file_name_(file_name) {}

    GltfFile::Content read() {
        check_nodes(root_);
        count_all();
        std::vector<Placed> waiting;
        const auto begin_with = [&](const Node& scene) {
            require_object(scene);
            scene.with("nodes", [&](const Node& list) { add_numbers(list, glm::dmat4(1), {}, waiting); });
        };
        if (root_.has("scene"))
            follow(root_, root_, "scene", "scenes", begin_with);
        else if (count_of(root_, "scenes") > 0)
            root_.with("scenes",
                       [&](const Node& all) { begin_with(Node(all.value()[0], all, std::size_t{0})); });
        else
            begin_with_roots(waiting);
        std::reverse(waiting.begin(), waiting.end());  // the last is processed first
        while (!waiting.empty()) {
            const Placed next = waiting.back();
            waiting.pop_back();
            visit(next, waiting);
        }
        say_left_out();
        return std::move(content_);
    }

  private:
    struct Placed {
        std::uint64_t node;
        glm::dmat4 world;                // the parent's
        std::optional<glm::dmat4> view;  // the parent's, from the camera, if that is above it
    };

    static void add_numbers(const Node& list, const glm::dmat4& world, const std::optional<glm::dmat4>& view,
                            std::vector<Placed>& to) {
        list.each(max_json_values, "numbers of nodes", [&](const Node& at) {
            to.push_back({node_number(at), world, view});
        });
    }
    /// Without a scene in the file, starts with the nodes that are not children of another node.
    void begin_with_roots(std::vector<Placed>& waiting) {
        std::vector<char> is_child(count_of(root_, "nodes"), 0);
        root_.with("nodes", [&](const Node& nodes) {
            nodes.each(max_json_values, "nodes", [&](const Node& node) {
                node.with("children", [&](const Node& list) {
                    list.each(max_json_values, "numbers of nodes",
                              [&](const Node& at) { is_child[node_number(at)] = 1; });
                });
            });
        });
        for (std::size_t i = 0; i < is_child.size(); ++i)
            if (is_child[i] == 0) waiting.push_back({i, glm::dmat4(1), {}});
    }

    void visit(const Placed& at, std::vector<Placed>& waiting) {
        const std::size_t count = count_of(root_, "nodes");
        if (at.node >= count)
            root_.fail(fmt::format("the scene has a node {}", at.node),
                       fmt::format("one of {} nodes", count));
        visited_.resize(count, 0);
        root_.with("nodes", [&](const Node& nodes) {
            const Node node(nodes.value()[at.node], nodes, at.node);
            if (std::exchange(visited_[at.node], 1) != 0)
                node.fail("the node is below itself, or below two others", "a tree of nodes");
            const glm::dmat4 local = local_of(node), world = at.world * local;
            std::optional<glm::dmat4> view;
            if (at.view) view = *at.view * local;
            std::string name;
            read_name(node, name);
            if (node.has("camera")) add_camera(node, world, view);
            if (node.has("skin")) ++left_.skins;
            if (node.has("mesh")) add_mesh(node, name, world);
            with_light(root_, node, [&](const Node& light) { add_light(light, name, world, view); });
            node.with("children", [&](const Node& list) {
                std::vector<Placed> children;
                add_numbers(list, world, view, children);
                waiting.insert(waiting.end(), children.rbegin(), children.rend());
            });
        });
    }

    void add_mesh(const Node& node, const std::string& name, const glm::dmat4& world) {
        follow(root_, node, "mesh", "meshes", [&](const Node& mesh) {
            require_object(mesh);
            const std::uint64_t index = whole(node, "mesh", 4294967295.0);
            std::string mesh_name;
            read_name(mesh, mesh_name);
            auto part = static_cast<int>(first_parts_[index]);
            mesh.with("primitives", [&](const Node& primitives) {
                // Many nodes may use a mesh with many primitives none of which becomes an object.
                visited_primitives_ += primitives.value().size();
                if (visited_primitives_ > max_json_values)
                    node.fail("the nodes show too many primitives",
                              fmt::format("at most {}", max_json_values));
                primitives.each(max_json_values, "primitives", [&](const Node& primitive) {
                    require_object(primitive);
                    add_primitive(primitive, part++, !name.empty() ? name : mesh_name, world);
                });
            });
        });
    }
    void add_primitive(const Node& primitive, int part, const std::string& name, const glm::dmat4& world) {
        if (mode_of(primitive) == PrimitiveMode::None) return void(++left_.lines);
        bool sparse = false, has_normals = false;
        primitive.with("attributes", [&](const Node& a) {
            require_object(a);
            sparse = is_sparse(root_, a, "POSITION") || is_sparse(root_, a, "NORMAL");
            has_normals = a.has("NORMAL");
            left_.colours += a.has("COLOR_0") ? 1 : 0;
        });
        if (sparse) return void(++left_.sparse);
        left_.morphs += primitive.has("targets") ? 1 : 0;
        bool sheared = false;
        const std::optional<Transform> transform = transform_of(world, sheared);
        if (!transform) return void(++(is_flat(world) ? left_.flat : left_.far));
        left_.sheared += sheared ? 1 : 0;
        Object object;
        object.name = name.empty() ? fmt::format("Object {}", content_.scene.objects.size() + 1) : name;
        object.source = MeshFile{file_name_, part};
        object.transform = *transform;
        if (!has_normals) object.normals.source = NormalSource::Facet;
        static const Json none = Json::object();
        object.material = material_of(Node(none)).material;
        if (primitive.has("material"))
            follow(root_, primitive, "material", "materials",
                   [&](const Node& m) { object.material = noted(material_of(m)); });
        if (content_.scene.objects.size() >= max_objects || part >= max_parts)
            primitive.fail("the scene has too many objects", fmt::format("at most {}", max_objects));
        content_.scene.objects.push_back(std::move(object));
    }

    Material noted(const GltfMaterial& m) {
        any_double_sided_ = any_double_sided_ || m.is_double_sided;
        left_.textures += m.has_textures ? 1 : 0;
        left_.blended += m.is_transparent ? 1 : 0;
        return m.material;
    }

    /// Sets `view` if this node has the scene's camera.
    void add_camera(const Node& node, const glm::dmat4& world, std::optional<glm::dmat4>& view) {
        if (content_.has_camera) return void(++left_.cameras);
        follow(root_, node, "camera", "cameras", [&](const Node& at) {
            const GltfCamera read = camera_from(node, at, world);
            content_.scene.camera = read.camera;
            content_.ahead = read.ahead;
            view = read.view_from_node;
        });
        content_.has_camera = true;
    }
    void add_light(const Node& light, const std::string& name, const glm::dmat4& world,
                   const std::optional<glm::dmat4>& view) {
        if (content_.scene.lights.size() >= max_lights) return void(++left_.lights);
        require_object(light);
        content_.scene.lights.push_back(
            light_from(light, name, view.value_or(world), view ? LightSpace::Camera : LightSpace::World));
        const bool has_place = content_.scene.lights.back().kind != LightKind::Directional;
        left_.ranges += has_place && light.has("range") ? 1 : 0;
        content_.has_lights = true;
    }
    void count_all() {
        left_.animations = count_of(root_, "animations");
        std::string generator;
        root_.with("asset", [&](const Node& asset) { glint::read(asset, "generator", generator); });
        content_.is_ours = generator == gltf_generator;
    }
    void say_left_out() {
        Scene& scene = content_.scene;
        scene.shading.reflection = Reflection::CookTorrance;
        scene.shading.cull = any_double_sided_ ? Cull::None : Cull::Back;
        scene.shading.two_sided = any_double_sided_;
        scene.display.transfer = Transfer::Srgb;
        scene.display.background = glm::vec3(0.01f, 0.01f, 0.013f);  // as dark as ours, once encoded
        if (content_.has_lights || content_.is_ours) scene.global_ambient = glm::vec3(0);
        content_.warnings = said(left_);
        content_.objects_left_out = said_objects(left_);
    }

    const Node& root_;
    const std::vector<std::size_t>& first_parts_;  // GltfDocument::first_parts
    const std::string& file_name_;
    GltfFile::Content content_;
    GltfLeftOut left_;
    std::vector<char> visited_;
    std::size_t visited_primitives_ = 0;
    bool any_double_sided_ = false;
};

}  // namespace

Result<GltfFile::Content> GltfFile::content(const std::string& file_name) const {
    return result_of(document_->path, [&] {
        const Node root(document_->root);
        return SceneReader(root, document_->first_parts, file_name).read();
    });
}

}  // namespace glint
