#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnose/check/check.h"
#include "models/scene/mistakes.h"

namespace glint {
namespace {

using At = const ReadAt&;
using Frames = const CheckFrames&;

/// The frames in which a program may have left a vector.
enum class Frame { Object, World, Camera, Clip };
constexpr std::array all_frames{Frame::Object, Frame::World, Frame::Camera, Frame::Clip};

const char* name_of(Frame frame) {
    constexpr std::array names{"object coordinates", "world coordinates", "camera coordinates",
                               "clip coordinates"};
    return names[static_cast<std::size_t>(frame)];
}

/// The rotation in the view matrix.
glm::dmat3 view_turn(const CheckFrames& f) { return glm::dmat3(f.view_from_world); }

/// The transform from the frame to camera coordinates. Object coordinates are those of the object at `at`.
glm::dmat4 camera_from(Frame frame, At at, Frames f) {
    switch (frame) {
    case Frame::Object:
        return f.view_from_world * at.world_from_object;
    case Frame::World:
        return f.view_from_world;
    case Frame::Camera:
        break;
    case Frame::Clip:
        return glm::inverse(f.clip_from_view);
    }
    return glm::dmat4(1);
}

/// Transforms a point from camera coordinates to the frame; clip coordinates are not divided by w.
glm::dvec3 point_in(Frame frame, At at, Frames f, glm::dvec3 point) {
    return glm::dvec3(glm::inverse(camera_from(frame, at, f)) * glm::dvec4(point, 1));
}
/// Returns the position in normalized device coordinates.
glm::dvec3 device_point(At at, Frames f) {
    const glm::dvec4 clip = f.clip_from_view * glm::dvec4(at.position, 1);
    return glm::dvec3(clip) / clip.w;
}
/// Transforms a direction from camera coordinates to the frame and normalizes it.
glm::dvec3 direction_in(Frame frame, At at, Frames f, glm::dvec3 direction) {
    const glm::dvec4 there = glm::inverse(camera_from(frame, at, f)) * glm::dvec4(direction, 0);
    return glm::normalize(glm::dvec3(there));
}
/// Transforms the normal to the frame and normalizes it. Uses the transpose of the matrix that takes points
/// from the frame to camera coordinates; for clip coordinates, uses P itself, like a program that treats a
/// normal as a direction.
glm::dvec3 normal_in(Frame frame, At at, Frames f) {
    if (frame == Frame::Clip) return direction_in(frame, at, f, at.normal);
    return glm::normalize(glm::transpose(glm::dmat3(camera_from(frame, at, f))) * at.normal);
}

constexpr double near = 6e-3;  // relative to the compared number, or to 1 if the number is smaller

/// One way in which a program may have computed its numbers. V: camera from world coordinates, M: world from
/// object coordinates, P: clip from camera coordinates.
struct Reading {
    std::string words;
    std::function<glm::dvec3(At at, Frames frames)> numbers;
};

/// A number as a buffer stores it, in three channels.
glm::dvec3 all(double x) { return glm::dvec3(x); }

std::vector<Reading> point_readings() {
    return {
        {"ours", [](At p, Frames) { return p.position; }},
        {"ours times V inverted: they were left in world coordinates",
         [](At p, Frames f) { return point_in(Frame::World, p, f, p.position); }},
        {"ours times (V M) inverted: they were left in object coordinates",
         [](At p, Frames f) { return point_in(Frame::Object, p, f, p.position); }},
        {"ours times P: they are in clip coordinates, not divided by w",
         [](At p, Frames f) { return point_in(Frame::Clip, p, f, p.position); }},
        {"ours times P and divided by w: they are in normalized device coordinates",
         [](At p, Frames f) { return device_point(p, f); }},
        {"world coordinates times V with w = 0 in place of 1: the view's translation is missing",
         [](At p, Frames f) { return view_turn(f) * point_in(Frame::World, p, f, p.position); }},
        {"ours times V: the view was applied twice",
         [](At p, Frames f) { return glm::dvec3(f.view_from_world * glm::dvec4(p.position, 1)); }},
    };
}

/// "(x, z, -y)".
std::string text_of(const AxesForm& form) {
    std::string text;
    for (int i = 0; i < 3; ++i)
        text += fmt::format("{}{}{}", i > 0 ? ", " : "(", form.sign[i] < 0 ? "-" : "", "xyz"[form.from[i]]);
    return text + ")";
}

/// Adds normals that are computed from other attributes of the mesh or with other matrices.
void add_other_normals(std::vector<Reading>& readings) {
    const auto add = [&readings](std::string words, const auto& vector) {
        readings.push_back({std::move(words), vector});
    };
    const auto turned = [](const ReadAt& p, const CheckFrames& f, glm::dvec3 object) {
        const glm::dmat3 m(camera_from(Frame::Object, p, f));
        return glm::transpose(glm::inverse(m)) * object;
    };
    add("transformed by the inverse of V M, not transposed", [](At p, Frames f) {
        return glm::inverse(glm::dmat3(camera_from(Frame::Object, p, f))) * normal_in(Frame::Object, p, f);
    });
    add("transformed by the inverse of M, not transposed, and then V", [](At p, Frames f) {
        return view_turn(f) *
               (glm::inverse(glm::dmat3(p.world_from_object)) * normal_in(Frame::Object, p, f));
    });
    add("transformed by the inverse of M, not transposed, and left in world coordinates", [](At p, Frames f) {
        return glm::inverse(glm::dmat3(p.world_from_object)) * normal_in(Frame::Object, p, f);
    });
    add("transformed by the inverse transpose of P V M: it includes the projection",
        [](At p, Frames f) { return glm::transpose(glm::inverse(glm::dmat3(f.clip_from_view))) * p.normal; });
    add("the positions, transformed like normals",
        [turned](At p, Frames f) { return turned(p, f, point_in(Frame::Object, p, f, p.position)); });
    add("the positions in object coordinates",
        [](At p, Frames f) { return point_in(Frame::Object, p, f, p.position); });
    for (int i = 0; i < axes_forms; ++i)
        add(fmt::format("those with {} for (x, y, z) in the mesh", text_of(axes_form(i))),
            [turned, form = axes_form(i)](At p, Frames f) {
                const glm::dvec3 n = normal_in(Frame::Object, p, f);
                return turned(p, f,
                              {form.sign[0] * n[form.from[0]], form.sign[1] * n[form.from[1]],
                               form.sign[2] * n[form.from[2]]});
            });
}

std::vector<Reading> normal_readings() {
    const auto object = [](At p, Frames f) { return normal_in(Frame::Object, p, f); };
    const auto world = [](At p, Frames f) { return normal_in(Frame::World, p, f); };
    std::vector<Reading> readings{
        {"ours", [](At p, Frames) { return p.normal; }},
        {"ours times V transposed: they were left in world coordinates", world},
        {"ours times (V M) transposed: they were left in object coordinates", object},
        {"ours times P: they were transformed to clip coordinates",
         [](At p, Frames f) { return normal_in(Frame::Clip, p, f); }},
        {"transformed by V M in place of its inverse transpose",
         [object](At p, Frames f) { return view_turn(f) * glm::dmat3(p.world_from_object) * object(p, f); }},
        {"transformed by M in place of its inverse transpose, and left in world coordinates",
         [object](At p, Frames f) { return glm::dmat3(p.world_from_object) * object(p, f); }},
        {"transformed by V M like points, with w = 1: they include the translation",
         [object](At p, Frames f) {
             return glm::dvec3(f.view_from_world * p.world_from_object * glm::dvec4(object(p, f), 1));
         }},
        {"object coordinates times V alone: the model matrix is missing",
         [object](At p, Frames f) { return view_turn(f) * object(p, f); }},
        {"ours times V: the view was applied twice", [](At p, Frames f) { return view_turn(f) * p.normal; }},
        {"world coordinates times V transposed in place of V",
         [world](At p, Frames f) { return glm::transpose(view_turn(f)) * world(p, f); }},
    };
    add_other_normals(readings);
    return readings;
}

std::vector<Reading> depth_readings() {
    return {
        {"ours, negated: z itself, which is negative in front of the camera",
         [](At p, Frames) { return all(p.position.z); }},
        {"the distance to the eye in place of that along the line of sight",
         [](At p, Frames) { return all(glm::length(p.position)); }},
        {"z in normalized device coordinates, -1 to 1",
         [](At p, Frames f) { return all(device_point(p, f).z); }},
        {"the depth buffer's numbers, 0 to 1",
         [](At p, Frames f) { return all((device_point(p, f).z + 1) / 2); }},
    };
}

/// The direction from the point to the eye or to the light, and the position of that eye or light, `head`. It
/// has no position if it is infinitely far away.
struct Heading {
    std::string name;
    std::function<glm::dvec3(At at)> direction;
    std::function<glm::dvec3(At at)> head;
};

Heading to_eye() {
    return {"the eye", [](At p) { return p.view; }, [](At) { return glm::dvec3(0); }};
}

Heading to_light() {
    return {"the light", [](At p) { return p.to_light; },
            [](At p) { return p.position + p.distance * p.to_light; }};
}

/// Adds readings with the light or the eye in one frame and the point in another.
void add_mixed(std::vector<Reading>& readings, const Heading& to) {
    for (const Frame head : all_frames)
        for (const Frame point : all_frames) {
            if (head == point) continue;
            readings.push_back({fmt::format("vectors from the point in {} to {} in {}", name_of(point),
                                            to.name, name_of(head)),
                                [to, head, point](At p, Frames f) {
                                    return point_in(head, p, f, to.head(p)) -
                                           point_in(point, p, f, p.position);
                                }});
        }
    for (const Frame head : all_frames)
        readings.push_back({fmt::format("the position of {} itself, in {}: the point is not subtracted",
                                        to.name, name_of(head)),
                            [to, head](At p, Frames f) { return point_in(head, p, f, to.head(p)); }});
}

std::vector<Reading> direction_readings(const Heading& to, bool has_head) {
    const auto in = [to](Frame frame) {
        return [to, frame](At p, Frames f) { return direction_in(frame, p, f, to.direction(p)); };
    };
    std::vector<Reading> readings{
        {"ours", [to](At p, Frames) { return to.direction(p); }},
        {"ours times V transposed: they were left in world coordinates", in(Frame::World)},
        {"ours times (V M) inverted: they were left in object coordinates", in(Frame::Object)},
        {"ours times P: they were transformed to clip coordinates", in(Frame::Clip)},
        {"ours times V: the view was applied twice",
         [to](At p, Frames f) { return view_turn(f) * to.direction(p); }},
        {"(0, 0, 1) everywhere: the direction to an eye infinitely far away",
         [](At, Frames) { return glm::dvec3(0, 0, 1); }},
        {"(0, 0, 1) everywhere, in world coordinates",
         [](At, Frames f) { return glm::transpose(view_turn(f)) * glm::dvec3(0, 0, 1); }},
    };
    if (has_head) add_mixed(readings, to);
    return readings;
}

std::vector<Reading> cosine_readings() {
    const auto right = [](At p) { return glm::dot(p.normal, p.to_light); };
    std::vector<Reading> readings{
        {"ours", [=](At p, Frames) { return all(right(p)); }},
        {"ours, with negative values clamped to 0",
         [=](At p, Frames) { return all(std::max(right(p), 0.0)); }},
        {"ours without its sign", [=](At p, Frames) { return all(std::abs(right(p))); }},
        {"ours times the distance to the light: l is not of length 1",
         [=](At p, Frames) { return all(right(p) * p.distance); }},
    };
    for (const Frame n : all_frames)
        for (const Frame l : all_frames)
            readings.push_back(
                {fmt::format("those for n in {} and l in {}", name_of(n), name_of(l)), [=](At p, Frames f) {
                     return all(glm::dot(normal_in(n, p, f), direction_in(l, p, f, p.to_light)));
                 }});
    return readings;
}

/// Readings for the distance to the light.
std::vector<Reading> distance_readings() {
    std::vector<Reading> readings{
        {"ours", [](At p, Frames) { return all(p.distance); }},
        {"1 everywhere: taken after l was normalized", [](At, Frames) { return all(1); }},
        {"sqrt(r^2 + 1): the w coordinates differ by 1",
         [](At p, Frames) { return all(std::hypot(p.distance, 1)); }},
        {"the square of ours", [](At p, Frames) { return all(p.distance * p.distance); }},
        {"the distance to the eye", [](At p, Frames) { return all(glm::length(p.position)); }},
    };
    std::vector<Reading> mixed;
    add_mixed(mixed, to_light());
    for (const Reading& m : mixed)
        readings.push_back({m.words, [m](At p, Frames f) { return all(glm::length(m.numbers(p, f))); }});
    return readings;
}

std::vector<Reading> falloff_readings() {
    const auto at = [](At p, double constant, double linear, double quadratic, double r) {
        return glm::dvec3(
            1 / (constant * p.falloff.x + r * (linear * p.falloff.y + r * quadratic * p.falloff.z)));
    };
    std::vector<Reading> readings;
    for (const Reading& r : distance_readings())
        readings.push_back({r.words == "ours" ? r.words : "ours with a different distance: " + r.words,
                            [at, r](At p, Frames f) { return at(p, 1, 1, 1, r.numbers(p, f).x); }});
    readings.push_back(
        {"1 everywhere: the light does not fall off", [](At, Frames) { return glm::dvec3(1); }});
    readings.push_back(
        {"those without the constant", [at](At p, Frames) { return at(p, 0, 1, 1, p.distance); }});
    readings.push_back(
        {"the inverse of ours", [at](At p, Frames) { return 1.0 / at(p, 1, 1, 1, p.distance); }});
    readings.push_back({"those with the linear and the quadratic factor swapped", [](At p, Frames) {
                            return glm::dvec3(
                                1 / (p.falloff.x + p.distance * (p.falloff.z + p.distance * p.falloff.y)));
                        }});
    return readings;
}

/// Readings for the cone's factor.
std::vector<Reading> cone_readings() {
    const auto hard = [](At p, double cosine, double least) {
        return glm::dvec3(cosine >= least ? std::pow(std::max(cosine, 0.0), p.exponent) : 0.0);
    };
    const auto cosine = [](At p) { return -glm::dot(p.to_light, p.axis); };
    const auto edge = [](At p, double share) { return std::cos(glm::radians(share * p.cutoff_deg)); };
    return {
        {"ours", [=](At p, Frames) { return hard(p, cosine(p), edge(p, 1)); }},
        {"1 everywhere: the cone is not tested", [](At, Frames) { return glm::dvec3(1); }},
        {"those for half the cutoff", [=](At p, Frames) { return hard(p, cosine(p), edge(p, 0.5)); }},
        {"those for the cutoff's degrees taken as radians",
         [=](At p, Frames) { return hard(p, cosine(p), std::cos(p.cutoff_deg)); }},
        {"1 inside, without the exponent",
         [=](At p, Frames) { return glm::dvec3(cosine(p) >= edge(p, 1) ? 1 : 0); }},
        {"1 outside the cone, and 0 inside",
         [=](At p, Frames) { return glm::dvec3(cosine(p) >= edge(p, 1) ? 0 : 1); }},
        {"those for an axis that points the other way",
         [=](At p, Frames) { return hard(p, -cosine(p), edge(p, 1)); }},
        {"those for an axis left in world coordinates",
         [=](At p, Frames f) {
             return hard(p, -glm::dot(p.to_light, glm::transpose(view_turn(f)) * p.axis), edge(p, 1));
         }},
    };
}

glm::dvec3 mirrored(glm::dvec3 v, glm::dvec3 n) { return 2 * glm::dot(n, v) * n - v; }

std::vector<Reading> mirrored_readings() {
    std::vector<Reading> readings =
        direction_readings({"r", [](At p) { return mirrored(p.to_light, p.normal); }, {}}, false);
    readings.push_back({"(n·l) n - l: not doubled",
                        [](At p, Frames) { return glm::dot(p.normal, p.to_light) * p.normal - p.to_light; }});
    readings.push_back({"2 (n·l) (n - l)", [](At p, Frames) {
                            return 2 * glm::dot(p.normal, p.to_light) * (p.normal - p.to_light);
                        }});
    readings.push_back(
        {"v mirrored about n in place of l", [](At p, Frames) { return mirrored(p.view, p.normal); }});
    return readings;
}

std::vector<Reading> halfway_readings() {
    std::vector<Reading> readings =
        direction_readings({"h", [](At p) { return glm::normalize(p.to_light + p.view); }, {}}, false);
    readings.push_back({"the direction of l - v", [](At p, Frames) { return p.to_light - p.view; }});
    readings.push_back({"l itself", [](At p, Frames) { return p.to_light; }});
    return readings;
}

glm::dvec3 unit(glm::dvec3 v) { return glm::dot(v, v) > 0 ? glm::normalize(v) : v; }

enum class Length { Counts, Ignored };

bool equal_nearly(const glm::dvec3& mine, const glm::dvec3& expected) {
    return glm::length(mine - expected) <= near * std::max(1.0, glm::length(expected));
}

/// Whether nearly all points agree, including nearly all of those that differ from ours: if few differ, the
/// agreement of the rest proves nothing.
template <class Agrees> bool nearly_all(const std::vector<ReadPoint>& points, const Agrees& agrees) {
    constexpr std::size_t few_of_a_hundred = 3;
    std::size_t other = 0, unlike = 0, unlike_of_other = 0;
    for (const ReadPoint& point : points) {
        const bool has_ours = equal_nearly(point.mine, point.ours);
        other += has_ours ? 0 : 1;
        if (agrees(point)) continue;
        ++unlike;
        unlike_of_other += has_ours ? 0 : 1;
        if (100 * unlike > few_of_a_hundred * points.size()) return false;
    }
    return 100 * unlike_of_other <= few_of_a_hundred * other;
}

/// Whether the points match the reading's numbers.
bool gives(const Reading& reading, const std::vector<ReadPoint>& points, const CheckFrames& frames,
           double sign, Length length) {
    return nearly_all(points, [&](const ReadPoint& point) {
        glm::dvec3 expected(0), mine = point.mine;
        for (const ReadAt& at : point.at) {
            const glm::dvec3 here = sign * reading.numbers(at, frames);
            expected += at.weight * (length == Length::Ignored ? unit(here) : here);
        }
        if (length == Length::Ignored && point.at.size() == 1) mine = unit(mine);
        return equal_nearly(mine, expected);
    });
}

std::string first_reading(const std::vector<Reading>& readings, const std::vector<ReadPoint>& points,
                          const CheckFrames& frames, Length length) {
    // The first reading is the correct one. Its negative comes second, before readings that may give the same
    // numbers by chance: v = (0, 0, 1) is the same when it is negated and when it is negated and transformed
    // to clip coordinates.
    std::vector<std::pair<const Reading*, double>> order{{&readings.front(), 1.0}, {&readings.front(), -1.0}};
    for (const double sign : {1.0, -1.0})
        for (std::size_t i = 1; i < readings.size(); ++i) order.emplace_back(&readings[i], sign);
    for (const auto& [reading, sign] : order) {
        if (!gives(*reading, points, frames, sign, length)) continue;
        std::string words = reading->words;
        if (sign < 0) words += ", and negated";
        const bool is_unit = std::all_of(points.begin(), points.end(), [](const ReadPoint& p) {
            return std::abs(glm::length(p.mine) - glm::length(p.ours)) <= near;
        });
        if (length == Length::Ignored && !is_unit) words += ", not of length 1";
        // They do differ somewhat, since readings are only sought for a buffer that differs.
        return words == "ours" ? "ours except for small differences" : words;
    }
    return {};
}

/// Returns "ours times 0.318" if nearly all points are the same multiple of ours and the remaining squared
/// error is small compared with the given numbers. Without the second condition the small numbers of a
/// different term would pass as a small multiple of ours.
std::string multiple(const std::vector<ReadPoint>& points) {
    constexpr double most_left = 1e-3;  // of the sum of squares, that is, about 3 % of the numbers
    double product = 0, square = 0, square_of_mine = 0;
    for (const ReadPoint& p : points) {
        const glm::dvec3 mine = p.mine, ours = p.ours;
        product += glm::dot(mine, ours);
        square += glm::dot(ours, ours);
        square_of_mine += glm::dot(mine, mine);
    }
    if (square <= 0) return {};
    const double factor = product / square, left = square_of_mine - factor * product;
    const auto agrees = [factor](const ReadPoint& p) {
        return equal_nearly(p.mine, factor * glm::dvec3(p.ours));
    };
    if (left > most_left * square_of_mine || !nearly_all(points, agrees)) return {};
    return fmt::format("ours times {:.4g}", factor);
}

/// Whether a diffuse term matches ours where n·l is positive, and is negative elsewhere.
bool is_unclamped(const std::vector<ReadPoint>& points) {
    return nearly_all(points, [](const ReadPoint& p) {
        const ReadAt& at = p.at.front();
        const bool is_lit = glm::dot(at.normal, at.to_light) > 0;
        return is_lit ? equal_nearly(p.mine, p.ours)
                      : std::max({p.mine.x, p.mine.y, p.mine.z}) <= float(near);
    });
}

/// Whether the light has a position, that is, is not directional.
bool has_place(const std::vector<ReadPoint>& points) { return points.front().at.front().distance > 0; }

}  // namespace

BufferKind buffer_kind(const std::string& name) {
    constexpr std::pair<std::string_view, BufferKind> kinds[] = {
        {"position", BufferKind::Point},     {"depth", BufferKind::Depth},
        {"normal", BufferKind::Normal},      {"view", BufferKind::View},
        {"l_", BufferKind::ToLight},         {"n_dot_l_", BufferKind::Cosine},
        {"distance_", BufferKind::Distance}, {"falloff_", BufferKind::Falloff},
        {"cone_", BufferKind::Cone},         {"r_", BufferKind::Mirrored},
        {"h_", BufferKind::Halfway},         {"diffuse_", BufferKind::Diffuse}};
    for (const auto& [begin, kind] : kinds)
        if (name.starts_with(begin)) return kind;
    return BufferKind::Color;
}

int buffer_light(const std::string& name) {
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    return digits == name.size() ? -1 : std::stoi(name.substr(digits));
}

std::string reading_of(BufferKind kind, const std::vector<ReadPoint>& points, const CheckFrames& frames) {
    if (points.empty()) return {};
    const auto first = [&](const std::vector<Reading>& readings, Length length) {
        return first_reading(readings, points, frames, length);
    };
    std::string found;
    switch (kind) {
    case BufferKind::Point:
        return first(point_readings(), Length::Counts);
    case BufferKind::Normal: {
        found = first(normal_readings(), Length::Ignored);
        if (!found.empty()) return found;
        std::vector<ReadPoint> decoded = points;
        for (ReadPoint& p : decoded) p.mine = 2.0f * p.mine - 1.0f;
        found = first_reading(normal_readings(), decoded, frames, Length::Ignored);
        if (found.empty()) return found;
        const std::string normal = found.starts_with("ours except") ? "ours" : found;
        return "n / 2 + 1/2, as normals are stored in colours, where n is " + normal;
    }
    case BufferKind::View:
        return first(direction_readings(to_eye(), true), Length::Ignored);
    case BufferKind::ToLight:
        return first(direction_readings(to_light(), has_place(points)), Length::Ignored);
    case BufferKind::Mirrored:
        return first(mirrored_readings(), Length::Ignored);
    case BufferKind::Halfway:
        return first(halfway_readings(), Length::Ignored);
    case BufferKind::Depth:
        found = first(depth_readings(), Length::Counts);
        break;
    case BufferKind::Cosine:
        found = first(cosine_readings(), Length::Counts);
        break;
    case BufferKind::Distance:
        found = first(distance_readings(), Length::Counts);
        break;
    case BufferKind::Falloff:
        found = first(falloff_readings(), Length::Counts);
        break;
    case BufferKind::Cone:
        return first(cone_readings(), Length::Counts);
    case BufferKind::Diffuse:
        if (is_unclamped(points)) return "ours, negative where n·l is: it is not clamped";
        break;
    case BufferKind::Color:
        break;
    }
    return found.empty() ? multiple(points) : found;
}

}  // namespace glint
