// Converts the nodes of a file to objects, lights and a camera.

#include <fmt/core.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <optional>

#include "models/gltf/gltf.h"
#include "models/gltf/gltf_document.h"

namespace glint {
namespace {

/// Counts the items of each kind that were left out.
struct GltfLeftOut {
    std::size_t textures = 0, blended = 0, skins = 0, animations = 0, morphs = 0, lines = 0, sparse = 0,
                colours = 0, emissions = 0, instances = 0, cones = 0;
    std::size_t cameras = 0, sheared = 0, flat = 0, far = 0, lights = 0, ranges = 0;
    std::map<std::string_view, std::size_t> effects;  // number of materials, by extension
};
/// Returns one warning, with its count, for each kind of missing object.
Warnings said_objects(const GltfLeftOut& left) {
    Warnings w;
    warn(w, left.lines, "primitive of points or lines is left out",
         "primitives of points or lines are left out");
    warn(w, left.sparse, "primitive with sparse accessors is left out",
         "primitives with sparse accessors are left out");
    warn(w, left.instances, "instance exceeds a scene's maximum number of objects and is left out",
         "instances exceed a scene's maximum number of objects and are left out");
    warn(w, left.flat, "object has a scale of 0, which makes it flat, and is left out",
         "objects have a scale of 0, which makes them flat, and are left out");
    warn(w, left.far, "object is larger or farther away than 1e7, and is left out",
         "objects are larger or farther away than 1e7, and are left out");
    return w;
}

/// Returns one warning for each kind, missing objects included.
Warnings said(const GltfLeftOut& left) {
    Warnings w;
    warn(w, left.textures, "material has textures, which are not read",
         "materials have textures, which are not read");
    warn(w, left.emissions, "material has an emissive texture: its emission is left out",
         "materials have emissive textures: their emission is left out");
    warn(w, left.blended, "material is transparent, but is drawn as opaque",
         "materials are transparent, but are drawn as opaque");
    for (const auto& [name, count] : left.effects)
        warn(w, count, fmt::format("material has {}, which is left out", name),
             fmt::format("materials have {}, which is left out", name));
    warn(w, left.colours, "primitive has vertex colours, which are not read",
         "primitives have vertex colours, which are not read");
    warn(w, left.skins, "node has a skin: it is shown as it was modelled",
         "nodes have a skin: they are shown as they were modelled");
    warn(w, left.animations, "animation is left out", "animations are left out");
    warn(w, left.morphs, "primitive has morph targets, which are left out",
         "primitives have morph targets, which are left out");
    const Warnings objects = said_objects(left);
    w.insert(w.end(), objects.begin(), objects.end());
    warn(w, left.cameras, "additional camera is left out", "additional cameras are left out");
    warn(w, left.lights, "light exceeds a scene's maximum number of lights and is left out",
         "lights exceed a scene's maximum number of lights and are left out");
    warn(w, left.cones,
         "spot has an inner angle above its outer one or an outer one above 90°, which is clamped",
         "spots have inner angles above their outer ones or outer ones above 90°, which are clamped");
    warn(w, left.ranges, "light has a range, but also shines beyond it here",
         "lights have a range, but also shine beyond it here");
    warn(w, left.sheared, "object is sheared; the shear is removed",
         "objects are sheared; the shear is removed");
    return w;
}

class SceneReader {
  public:
    SceneReader(const GltfDocument& document, const std::string& file_name, const glm::dvec3& offset)
        : document_(document), root_(document.root), file_name_(file_name) {
        to_origin_[3] = glm::dvec4(-offset, 1);
    }

    GltfFile::Content read() {
        check_nodes(root_);
        count_all();
        std::vector<Placed> waiting;
        const auto begin_with = [&](const Node& scene) {
            require_object(scene);
            scene.with("nodes", [&](const Node& list) { add_numbers(list, to_origin_, {}, waiting); });
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
        glm::dmat4 world;                // the parent's matrix
        std::optional<glm::dmat4> view;  // the same in camera coordinates, if below the camera's node
    };

    static void add_numbers(const Node& list, const glm::dmat4& world, const std::optional<glm::dmat4>& view,
                            std::vector<Placed>& to) {
        list.each(max_json_values, "numbers of nodes", [&](const Node& at) {
            to.push_back({node_number(at), world, view});
        });
    }
    /// If the file has no scene, starts with the nodes that are not children of other nodes.
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
            if (is_child[i] == 0) waiting.push_back({i, to_origin_, {}});
    }

    void visit(const Placed& at, std::vector<Placed>& waiting) {
        const std::size_t count = count_of(root_, "nodes");
        if (at.node >= count)
            root_.fail(fmt::format("the scene refers to node {}", at.node),
                       fmt::format("one of {} nodes", count));
        visited_.resize(count, 0);
        root_.with("nodes", [&](const Node& nodes) {
            const Node node(nodes.value()[at.node], nodes, at.node);
            if (std::exchange(visited_[at.node], 1) != 0)
                node.fail("the node is its own descendant, or has two parents", "a tree of nodes");
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
            const auto first = static_cast<int>(document_.first_parts[index]);
            mesh.with("primitives", [&](const Node& primitives) {
                const std::vector<glm::dmat4> instances = instances_of(node);
                // Many nodes may use a mesh with many primitives, none of which becomes an object.
                visited_primitives_ += primitives.value().size() * instances.size();
                if (visited_primitives_ > max_json_values)
                    node.fail("the nodes refer to too many primitives",
                              fmt::format("at most {}", max_json_values));
                for (const glm::dmat4& instance : instances) {
                    const std::size_t objects = content_.scene.objects.size() + primitives.value().size();
                    if (instances.size() > 1 && objects > max_objects) {
                        ++left_.instances;
                        continue;
                    }
                    int part = first;
                    primitives.each(max_json_values, "primitives", [&](const Node& primitive) {
                        require_object(primitive);
                        add_primitive(primitive, part++, !name.empty() ? name : mesh_name, world * instance);
                    });
                }
            });
        });
    }
    /// The instance transforms of EXT_mesh_gpu_instancing, relative to the node; without the extension, a
    /// single identity.
    std::vector<glm::dmat4> instances_of(const Node& node) {
        std::vector<glm::dmat4> all(1, glm::dmat4(1));
        if (!has_extension(node, "EXT_mesh_gpu_instancing")) return all;
        const auto begin_with = [&](std::size_t count) {
            all.resize(std::max(all.size(), count), glm::dmat4(1));
        };
        const auto each = [&](const Node& from, const char* key, const char* type, const auto& f) {
            if (!from.has(key)) return;
            const GltfNumbers numbers = numbers_of(document_, root_, from, key, type);
            begin_with(numbers.count);
            for (std::size_t i = 0; i < numbers.count; ++i) f(numbers, i, all[i]);
        };
        node.with("extensions", [&](const Node& extensions) {
            with_object(extensions, "EXT_mesh_gpu_instancing", [&](const Node& extension) {
                with_object(extension, "attributes", [&](const Node& from) {
                    each(from, "SCALE", "VEC3", [](const GltfNumbers& n, std::size_t i, glm::dmat4& m) {
                        for (int k = 0; k < 3; ++k) m[k] *= n.at(i, static_cast<std::size_t>(k));
                    });
                    each(from, "ROTATION", "VEC4", [](const GltfNumbers& n, std::size_t i, glm::dmat4& m) {
                        const glm::dquat turn(n.at(i, 3), n.at(i, 0), n.at(i, 1), n.at(i, 2));
                        if (glm::dot(turn, turn) > 0) m = glm::mat4_cast(glm::normalize(turn)) * m;
                    });
                    each(from, "TRANSLATION", "VEC3", [](const GltfNumbers& n, std::size_t i, glm::dmat4& m) {
                        m[3] = glm::dvec4(n.at(i, 0), n.at(i, 1), n.at(i, 2), 1);
                    });
                });
            });
        });
        return all;
    }
    void add_primitive(const Node& primitive, int part, const std::string& name, const glm::dmat4& world) {
        if (mode_of(primitive) == PrimitiveMode::None) return void(++left_.lines);
        bool sparse = false, has_normals = false;
        with_object(primitive, "attributes", [&](const Node& a) {
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
        bool is_double_sided = false;
        if (primitive.has("material"))
            follow(root_, primitive, "material", "materials", [&](const Node& m) {
                const GltfMaterial read = material_of(m);
                object.material = noted(read);
                is_double_sided = read.is_double_sided;
            });
        object.double_sided = is_double_sided;
        double_sided_ += is_double_sided ? 1 : 0;
        if (content_.scene.objects.size() >= max_objects || part >= max_parts)
            primitive.fail("the scene has too many objects", fmt::format("at most {}", max_objects));
        content_.scene.objects.push_back(std::move(object));
    }

    Material noted(const GltfMaterial& m) {
        left_.emissions += m.lacks_emission ? 1 : 0;
        left_.textures += m.has_textures ? 1 : 0;
        left_.blended += m.is_transparent ? 1 : 0;
        for (const std::string_view effect : m.effects) ++left_.effects[effect];
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
        bool has_bad_cone = false;
        content_.scene.lights.push_back(light_from(
            light, name, view.value_or(world), view ? LightSpace::Camera : LightSpace::World, has_bad_cone));
        left_.cones += has_bad_cone ? 1 : 0;
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
        const bool all_double_sided = double_sided_ == scene.objects.size() && double_sided_ > 0;
        if (all_double_sided)
            for (Object& object : scene.objects) object.double_sided = false;  // nothing is culled
        scene.shading.cull = all_double_sided ? Cull::None : Cull::Back;
        scene.shading.two_sided = double_sided_ > 0;
        scene.display.transfer = Transfer::Srgb;
        scene.display.background = glm::vec3(0.01f, 0.01f, 0.013f);  // as dark as the default, once encoded
        if (content_.has_lights || content_.is_ours) scene.global_ambient = glm::vec3(0);
        content_.warnings = document_.warnings;
        const Warnings left = said(left_);
        content_.warnings.insert(content_.warnings.end(), left.begin(), left.end());
        content_.objects_left_out = said_objects(left_);
    }

    const GltfDocument& document_;
    const Node root_;
    glm::dmat4 to_origin_{1};
    const std::string& file_name_;
    GltfFile::Content content_;
    GltfLeftOut left_;
    std::vector<char> visited_;
    std::size_t visited_primitives_ = 0;
    std::size_t double_sided_ = 0;  // number of objects
};

}  // namespace

Result<GltfFile::Content> GltfFile::content(const std::string& file_name, const glm::dvec3& offset) const {
    return result_of(document_->path, [&] { return SceneReader(*document_, file_name, offset).read(); });
}

}  // namespace glint
