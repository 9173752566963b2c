#include "tests/fuzz/scene_from_bytes.h"

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "models/fields/scene_fields.h"

namespace glint::fuzz {
namespace {

constexpr std::size_t most_items = 3;                // the maximum length of a list
constexpr int max_detail = 3;                        // detail of a mesh; an icosphere then has 1280 triangles
constexpr int most_samples = 9, most_entries = 300;  // of an area light; of a table of powers

MeshPtr mesh_of(const MeshSource& source) {
    static std::map<std::pair<Primitive, int>, MeshPtr> made;
    const auto& shape = std::get<PrimitiveMesh>(source);
    MeshPtr& mesh = made[{shape.primitive, shape.detail}];
    if (!mesh) mesh = std::make_shared<const Mesh>(make_primitive(shape.primitive, shape.detail));
    return mesh;
}

/// Leaves most numbers unchanged, and gives some an ordinary value and a few any magnitude, because a scene
/// of only extreme numbers shows nothing.
float number_within(const Range& range, float usual_max, float initial, Bytes& bytes) {
    constexpr unsigned keeps = 120, plain = 200, power = 228;
    constexpr std::array<float, 14> hard{0,      -0.0f, 1,    -1,     1e7f, -1e7f,      1e-45f,
                                         1e-38f, 1e6f,  1e5f, 1e-18f, 180,  9999999.0f, 0.0031308f};
    const unsigned kind = bytes.byte();
    const unsigned high = bytes.byte(), low = bytes.byte();
    const float share = static_cast<float>(256 * high + low) / 65535.0f;
    float x = initial;
    if (kind >= power)
        x = hard[low % hard.size()];
    else if (kind >= plain)
        x = (low % 2 == 0 ? 1.0f : -1.0f) * std::pow(10.0f, 60 * share - 30);
    else if (kind >= keeps)
        x = usual_max > 0 ? share * usual_max : 8 * share - 4;
    return range.contains(x) ? x : initial;
}

/// Counts the fields of a scene, and fills all of them or only the one with a given index.
class Filler {
  public:
    Filler(Bytes& bytes, int& count, std::optional<int> only, bool& moved_faces)
        : bytes_(bytes), count_(count), only_(only), moved_faces_(moved_faces) {}

    template <class T> void members(T& value) const {
        const T before = value;
        fields(value, [this](const Row& row, const auto& kind, auto& member) {
            Filler below = *this;
            below.moves_faces_ = moves_faces_ && row.moves_faces;
            below.at(kind, member);
        });
        if constexpr (std::is_same_v<T, Camera> || std::is_same_v<T, Light> || std::is_same_v<T, Object>)
            if (violation_of(value)) value = before;
    }

  private:
    /// Whether to fill the next field.
    [[nodiscard]] bool is_next() const {
        const bool next = !only_ || *only_ == count_;
        if (next) moved_faces_ = moved_faces_ || moves_faces_;
        ++count_;
        return next;
    }

    void at(const Real& kind, float& x) const {
        if (is_next()) x = number_within(kind.range, kind.usual_max, x, bytes_);
    }
    void at(const Colour& kind, glm::vec3& v) const {
        if (!is_next()) return;
        for (int i = 0; i < 3; ++i) v[i] = number_within(component_of(kind).range, 1, v[i], bytes_);
    }
    void at(const Vector& kind, glm::vec3& v) const {
        if (!is_next()) return;
        for (int i = 0; i < 3; ++i) v[i] = number_within(component_of(kind).range, 0, v[i], bytes_);
    }
    void at(const Homogeneous& kind, glm::vec4& v) const {
        if (is_next())
            for (int i = 0; i < 3; ++i) v[i] = number_within(component_of(kind).range, 0, v[i], bytes_);
        v.w = kind.is_direction() ? 0.0f : 1.0f;  // even if only the light's type has changed
    }
    void at(const Switch&, bool& on) const {
        constexpr unsigned keeps = 224;
        if (is_next() && bytes_.byte() >= keeps) on = !on;
    }
    template <class E> void at(const OneOf&, E& value) const {
        if (is_next()) value = enumerators<E>[bytes_.below(enumerators<E>.size())];
    }
    void at(const Count& kind, int& n) const {
        if (!is_next()) return;
        const int high = std::min(kind.high, kind.high > most_entries ? most_entries : most_samples);
        const int asked =
            kind.low + static_cast<int>(256 * bytes_.byte() + bytes_.byte()) % (high - kind.low + 1);
        if (kind.contains(asked)) n = asked;
    }
    void at(const Text&, std::string&) const {}
    template <class T> void at(const Group&, T& value) const { members(value); }
    template <class T> void at(const List&, std::vector<T>& list) const {
        if (is_next()) list.resize(bytes_.below(most_items + 1));
        for (T& item : list) members(item);
    }
    void at(const OneProjection&, Projection& projection) const {
        if (is_next()) {
            const std::size_t kind = bytes_.below(std::variant_size_v<Projection>);
            if (kind == 0) projection = Perspective{};
            if (kind == 1) projection = Orthographic{};
            if (kind == 2) projection = Frustum{};
        }
        std::visit([this](auto& p) { members(p); }, projection);
    }
    void at(const OneMesh&, MeshSource& source) const {
        if (!is_next()) return;
        const Primitive primitive = enumerators<Primitive>[bytes_.below(enumerators<Primitive>.size())];
        const PrimitiveInfo info = info_of(primitive);
        const int detail = 1 + static_cast<int>(bytes_.byte()) % std::min(info.max_detail, max_detail);
        source = PrimitiveMesh{primitive, detail};
    }

    Bytes& bytes_;
    int& count_;
    std::optional<int> only_;
    bool& moved_faces_;
    bool moves_faces_ = true;
};

void load(Scene& scene) {
    for (Object& object : scene.objects) object.mesh = mesh_of(object.source);
}

}  // namespace

unsigned Bytes::byte() {
    if (bytes_.empty()) return 0;
    const unsigned first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
}

Scene scene_from(Bytes& bytes) {
    Scene scene;
    scene.objects.resize(1);
    scene.lights.resize(1);
    scene.objects[0].source = PrimitiveMesh{Primitive::Cube, 1};
    int count = 0;
    bool moved_faces = false;
    Filler(bytes, count, {}, moved_faces).members(scene);
    load(scene);
    return scene;
}

EditedScene edited(const Scene& scene, Bytes& bytes) {
    EditedScene result{scene, false};
    Bytes none({});
    int count = 0;
    bool moved_faces = false;
    Filler(none, count, -1, moved_faces).members(result.scene);
    const int which = static_cast<int>(256 * bytes.byte() + bytes.byte()) % count;
    count = 0;
    Filler(bytes, count, which, result.moves_faces).members(result.scene);
    load(result.scene);
    return result;
}

}  // namespace glint::fuzz
