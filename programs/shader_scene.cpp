#include "programs/shader_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <utility>

#include "models/mesh/normals.h"
#include "programs/scene_tables.h"

namespace glint {
namespace {

/// Collects uniform variables whose names begin with `prefix`.
class UniformList {
  public:
    explicit UniformList(std::vector<Uniform>& list, std::string prefix = {})
        : list_(list), prefix_(std::move(prefix)) {}
    void add(const char* name, int value) { list_.push_back({prefix_ + name, value}); }
    void add(const char* name, float value) { list_.push_back({prefix_ + name, value}); }
    void add(const char* name, const glm::dvec3& value) {
        list_.push_back({prefix_ + name, glm::vec3(value)});
    }
    void add(const char* name, const glm::dmat4& value) {
        list_.push_back({prefix_ + name, glm::mat4(value)});
    }

  private:
    std::vector<Uniform>& list_;
    std::string prefix_;
};

/// The light in camera coordinates, with its colours multiplied by its intensity.
void add_light(std::vector<Uniform>& list, std::size_t index, const Light& light, const glm::dmat4& view) {
    UniformList uniforms(list, "lights[" + std::to_string(index) + "].");
    const glm::dmat4 to_camera = light.space == LightSpace::World ? view : glm::dmat4(1);
    const auto direction = [&to_camera](const glm::vec3& v) {
        return glm::dvec3(to_camera * glm::dvec4(glm::dvec3(v), 0));
    };
    const auto color = [&light](const glm::vec3& c) {
        return static_cast<double>(light.intensity) * glm::dvec3(c);
    };
    const glm::vec3 place(light.position);
    const bool is_directional = light.kind == LightKind::Directional;
    uniforms.add("kind", static_cast<int>(light.kind));  // 0 directional, 1 point, 2 spot, 3 area
    uniforms.add("position", is_directional ? unit_or_zero(direction(place))
                                            : glm::dvec3(to_camera * glm::dvec4(glm::dvec3(place), 1)));
    uniforms.add("ambient", color(light.ambient));
    uniforms.add("diffuse", color(light.diffuse));
    uniforms.add("specular", color(light.specular));
    const bool falls_off = light.kind == LightKind::Point || light.kind == LightKind::Spot;
    const Falloff falloff = falls_off ? light.falloff : Falloff{};
    uniforms.add("constant", falloff.constant);
    uniforms.add("linear", falloff.linear);
    uniforms.add("quadratic", falloff.quadratic);
    uniforms.add("direction", unit_or_zero(direction(light.spot.direction)));
    uniforms.add("cutoff_deg", light.spot.cutoff_deg);
    uniforms.add("inner_deg", light.spot.inner_deg);
    uniforms.add("exponent", light.spot.exponent);
    uniforms.add("edge_u", direction(light.area.edge_u));
    uniforms.add("edge_v", direction(light.area.edge_v));
    uniforms.add("cells", static_cast<int>(std::lround(std::sqrt(light.area.samples))));
}

void add_material(std::vector<Uniform>& list, const Material& m, const Shading& shading) {
    constexpr float opengl_most = 128;
    UniformList uniforms(list, "material.");
    uniforms.add("ambient", m.ambient);
    uniforms.add("diffuse", m.diffuse);
    uniforms.add("specular", m.specular);
    uniforms.add("emission", m.emission);
    uniforms.add("shininess",
                 shading.rules == Rules::OpenGL2 ? std::min(m.shininess, opengl_most) : m.shininess);
    uniforms.add("roughness", m.roughness);
    uniforms.add("f0", m.f0);
    uniforms.add("model", static_cast<int>(reflection_of(m, shading.reflection)));
}

ShaderObject shader_object(const Object& object, const Shading& shading, const glm::dmat4& view,
                           CornerCache& cache) {
    ShaderObject o;
    o.corners = cache.of(object, shading);
    const glm::vec3& scale = object.transform.scale;
    o.is_mirrored = scale.x * scale.y * scale.z < 0;
    UniformList uniforms(o.uniforms);
    const glm::dmat4 to_camera = view * world_from_object(object.transform);
    uniforms.add("camera_from_object", to_camera);
    uniforms.add("for_normals", glm::dmat4(glm::inverseTranspose(glm::dmat3(to_camera))));
    add_material(o.uniforms, object.material, shading);
    return o;
}

double encoded(double linear, const Display& display) {
    const double x = std::clamp(linear * static_cast<double>(display.exposure), 0.0, 1.0);
    if (display.transfer == Transfer::None) return x;
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

/// Appends the three numbers of each vector.
void append(std::vector<float>& numbers, std::initializer_list<glm::vec3> vectors) {
    for (const glm::vec3& v : vectors) numbers.insert(numbers.end(), {v.x, v.y, v.z});
}

std::vector<float> corner_numbers(const Object& object, bool facets, bool centroids) {
    const Mesh& mesh = *object.mesh;
    const CornerNormals normals = corner_normals(mesh, object.normals);
    const float side = object.normals.flip ? -1 : 1;
    const auto color = [&mesh](std::uint32_t position) {
        return mesh.colors.empty() ? glm::vec3(1) : mesh.colors[position];
    };
    std::vector<float> numbers;
    numbers.reserve(3 * numbers_per_corner * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        const glm::vec3 facet = facets ? facet_normal(mesh, t.face) : glm::vec3(0);
        glm::dvec3 centroid(0), mean(0);
        if (centroids) {
            const auto face = mesh.corners_of(t.face);
            for (const std::uint32_t position : face) {
                centroid += glm::dvec3(mesh.positions[position]) / static_cast<double>(face.size());
                mean += glm::dvec3(color(position)) / static_cast<double>(face.size());
            }
        }
        for (const std::uint32_t c : t.corner) {
            const std::uint32_t position = mesh.corner_position[c];
            const glm::vec3 place = mesh.positions[position];
            const std::uint32_t normal = normals.corner.empty() ? position : normals.corner[c];
            append(numbers,
                   {place, side * (facets ? facet : normals.normals[normal]),
                    centroids ? glm::vec3(centroid) : place, centroids ? glm::vec3(mean) : color(position)});
        }
    }
    return numbers;
}

}  // namespace

CornerNumbers CornerCache::of(const Object& object, const Shading& shading) {
    const bool centroids = shading.mode == ShadingMode::Flat && !flat_at_provoking_corner(shading);
    const bool facets = centroids || shading.mode == ShadingMode::Facet;
    Kept& kept = kept_[{normals_key(object), object.normals.flip, facets, centroids}];
    if (!kept.numbers)
        kept = {object.mesh,
                std::make_shared<const std::vector<float>>(corner_numbers(object, facets, centroids))};
    return kept.numbers;
}

Result<ShaderScene> shader_scene(const Scene& given, PictureSize size, CornerCache& cache) {
    Scene scene = given;
    scene.shading.mistakes = {};
    Result<ShaderStages> stages = shader_stages({scene, size, ""});
    if (Problem* problem = std::get_if<Problem>(&stages)) return std::move(*problem);
    ShaderScene out;
    out.size = size;
    out.stages = std::get<ShaderStages>(std::move(stages));
    out.cull = scene.shading.cull;
    out.background = scene.display.background;
    for (int c = 0; c < 3; ++c)
        out.shown_background[c] =
            static_cast<float>(encoded(static_cast<double>(out.background[c]), scene.display));
    const glm::dmat4 view = view_from_world(scene.camera);
    const std::vector<Light> lights = shining(scene);
    UniformList uniforms(out.uniforms);
    const glm::dmat4 projection = clip_from_view(scene.camera.projection, size);
    uniforms.add("clip_from_camera", projection);
    uniforms.add("projection", projection);
    uniforms.add("origin_of_world", glm::dvec3(view[3]));
    uniforms.add("global_ambient", scene.global_ambient);
    uniforms.add("light_count", static_cast<int>(lights.size()));
    for (std::size_t i = 0; i < lights.size(); ++i) add_light(out.uniforms, i, lights[i], view);
    for (const Object& object : shown(scene))
        out.objects.push_back(shader_object(object, scene.shading, view, cache));
    return out;
}

}  // namespace glint
