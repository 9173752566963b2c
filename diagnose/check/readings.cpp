#include "diagnose/check/readings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "diagnose/check/frames.h"

namespace glint {
namespace {

constexpr double near = 6e-3;  // of the size of what is compared, or of 1 where that is smaller

/// One way in which a program may have come by its numbers. V: camera from world coordinates, M: world from
/// object coordinates, P: clip from camera coordinates.
struct Reading {
    std::string words;
    std::function<glm::dvec3(const ReadAt& at, const CheckFrames& frames)> numbers;
};

std::vector<Reading> point_readings() {
    return {
        {"ours", [](const ReadAt& p, const CheckFrames&) { return p.position; }},
        {"ours times V inverted: they were left in world coordinates",
         [](const ReadAt& p, const CheckFrames& f) { return point_in(Frame::World, p, f, p.position); }},
        {"ours times (V M) inverted: they were left in object coordinates",
         [](const ReadAt& p, const CheckFrames& f) { return point_in(Frame::Object, p, f, p.position); }},
        {"ours times P: they are in clip coordinates, not divided by w",
         [](const ReadAt& p, const CheckFrames& f) { return point_in(Frame::Clip, p, f, p.position); }},
        {"ours times P and divided by w: they are in normalized device coordinates",
         [](const ReadAt& p, const CheckFrames& f) { return device_point(p, f); }},
        {"world coordinates times V with w = 0 in place of 1: the view's translation is missing",
         [](const ReadAt& p, const CheckFrames& f) {
             return view_turn(f) * point_in(Frame::World, p, f, p.position);
         }},
        {"ours times V: the view was applied twice",
         [](const ReadAt& p, const CheckFrames& f) {
             return glm::dvec3(f.view_from_world * glm::dvec4(p.position, 1));
         }},
    };
}

std::vector<Reading> normal_readings() {
    const auto object = [](const ReadAt& p, const CheckFrames& f) { return normal_in(Frame::Object, p, f); };
    const auto world = [](const ReadAt& p, const CheckFrames& f) { return normal_in(Frame::World, p, f); };
    return {
        {"ours", [](const ReadAt& p, const CheckFrames&) { return p.normal; }},
        {"ours times V transposed: they were left in world coordinates", world},
        {"ours times (V M) transposed: they were left in object coordinates", object},
        {"ours times P: they were taken on to clip coordinates",
         [](const ReadAt& p, const CheckFrames& f) { return normal_in(Frame::Clip, p, f); }},
        {"by V M in place of its inverse transpose",
         [object](const ReadAt& p, const CheckFrames& f) {
             return view_turn(f) * glm::dmat3(p.world_from_object) * object(p, f);
         }},
        {"by M in place of its inverse transpose, and left in world coordinates",
         [object](const ReadAt& p, const CheckFrames& f) {
             return glm::dmat3(p.world_from_object) * object(p, f);
         }},
        {"by V M as points are, with w = 1: the translation is in them",
         [object](const ReadAt& p, const CheckFrames& f) {
             return glm::dvec3(f.view_from_world * p.world_from_object * glm::dvec4(object(p, f), 1));
         }},
        {"object coordinates times V alone: the model's matrix is missing",
         [object](const ReadAt& p, const CheckFrames& f) { return view_turn(f) * object(p, f); }},
        {"ours times V: the view was applied twice",
         [](const ReadAt& p, const CheckFrames& f) { return view_turn(f) * p.normal; }},
        {"world coordinates times V transposed in place of V",
         [world](const ReadAt& p, const CheckFrames& f) {
             return glm::transpose(view_turn(f)) * world(p, f);
         }},
    };
}

std::vector<Reading> depth_readings() {
    const auto all = [](double x) { return glm::dvec3(x); };
    return {
        {"ours, turned round: z itself, which is negative in front of the camera",
         [all](const ReadAt& p, const CheckFrames&) { return all(p.position.z); }},
        {"the distance to the eye in place of that along the line of sight",
         [all](const ReadAt& p, const CheckFrames&) { return all(glm::length(p.position)); }},
        {"z in normalized device coordinates, -1 to 1",
         [all](const ReadAt& p, const CheckFrames& f) { return all(device_point(p, f).z); }},
        {"the depth buffer's numbers, 0 to 1",
         [all](const ReadAt& p, const CheckFrames& f) { return all((device_point(p, f).z + 1) / 2); }},
    };
}

/// A direction from the point to `head`: the eye or the light, or nothing where that is infinitely far away.
struct Heading {
    std::string name;
    std::function<glm::dvec3(const ReadAt& at)> direction;
    std::function<glm::dvec3(const ReadAt& at)> head;
};

Heading to_eye() {
    return {"the eye", [](const ReadAt& p) { return p.view; }, [](const ReadAt&) { return glm::dvec3(0); }};
}

Heading to_light() {
    return {"the light", [](const ReadAt& p) { return p.to_light; },
            [](const ReadAt& p) { return p.position + p.distance * p.to_light; }};
}

/// The light or the eye in one frame, the point in another.
void add_mixed(std::vector<Reading>& readings, const Heading& to) {
    for (const Frame head : all_frames)
        for (const Frame point : all_frames) {
            if (head == point) continue;
            readings.push_back(
                {fmt::format("from the point in {} to {} in {}", name_of(point), to.name, name_of(head)),
                 [to, head, point](const ReadAt& p, const CheckFrames& f) {
                     return point_in(head, p, f, to.head(p)) - point_in(point, p, f, p.position);
                 }});
        }
    for (const Frame head : all_frames)
        readings.push_back(
            {fmt::format("the position of {} itself, in {}: the point is not subtracted", to.name,
                         name_of(head)),
             [to, head](const ReadAt& p, const CheckFrames& f) { return point_in(head, p, f, to.head(p)); }});
}

std::vector<Reading> direction_readings(const Heading& to, bool has_head) {
    const auto in = [to](Frame frame) {
        return [to, frame](const ReadAt& p, const CheckFrames& f) {
            return direction_in(frame, p, f, to.direction(p));
        };
    };
    std::vector<Reading> readings{
        {"ours", [to](const ReadAt& p, const CheckFrames&) { return to.direction(p); }},
        {"ours times V transposed: they were left in world coordinates", in(Frame::World)},
        {"ours times (V M) inverted: they were left in object coordinates", in(Frame::Object)},
        {"ours times P: they were taken on to clip coordinates", in(Frame::Clip)},
        {"ours times V: the view was applied twice",
         [to](const ReadAt& p, const CheckFrames& f) { return view_turn(f) * to.direction(p); }},
        {"(0, 0, 1) everywhere: that of an eye infinitely far away",
         [](const ReadAt&, const CheckFrames&) { return glm::dvec3(0, 0, 1); }},
        {"(0, 0, 1) everywhere, in world coordinates",
         [](const ReadAt&, const CheckFrames& f) {
             return glm::transpose(view_turn(f)) * glm::dvec3(0, 0, 1);
         }},
    };
    if (has_head) add_mixed(readings, to);
    return readings;
}

std::vector<Reading> cosine_readings() {
    const auto all = [](double x) { return glm::dvec3(x); };
    const auto right = [](const ReadAt& p) { return glm::dot(p.normal, p.to_light); };
    std::vector<Reading> readings{
        {"ours", [=](const ReadAt& p, const CheckFrames&) { return all(right(p)); }},
        {"ours, 0 where it is negative",
         [=](const ReadAt& p, const CheckFrames&) { return all(std::max(right(p), 0.0)); }},
        {"ours without its sign",
         [=](const ReadAt& p, const CheckFrames&) { return all(std::abs(right(p))); }},
        {"ours times the distance to the light: l is not of length 1",
         [=](const ReadAt& p, const CheckFrames&) { return all(right(p) * p.distance); }},
    };
    for (const Frame n : all_frames)
        for (const Frame l : all_frames)
            readings.push_back({fmt::format("of n in {} and l in {}", name_of(n), name_of(l)),
                                [=](const ReadAt& p, const CheckFrames& f) {
                                    return all(
                                        glm::dot(normal_in(n, p, f), direction_in(l, p, f, p.to_light)));
                                }});
    return readings;
}

glm::dvec3 unit(glm::dvec3 v) { return glm::dot(v, v) > 0 ? glm::normalize(v) : v; }

enum class Length { Counts, Ignored };

bool equal_nearly(const glm::dvec3& mine, const glm::dvec3& expected) {
    return glm::length(mine - expected) <= near * std::max(1.0, glm::length(expected));
}

/// Whether nearly all points agree, and nearly all of those that differ from ours: where few differ, the rest
/// prove nothing.
template <class Agrees> bool nearly_all(const std::vector<ReadPoint>& points, const Agrees& agrees) {
    constexpr std::size_t in_a_hundred = 97;
    std::size_t agree = 0, other = 0, agree_of_other = 0;
    for (const ReadPoint& point : points) {
        const bool has_ours = equal_nearly(point.mine, point.ours), has_this = agrees(point);
        agree += has_this ? 1 : 0;
        other += has_ours ? 0 : 1;
        agree_of_other += has_this && !has_ours ? 1 : 0;
    }
    return 100 * agree >= in_a_hundred * points.size() && 100 * agree_of_other >= in_a_hundred * other;
}

/// Whether the points have what the reading says.
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
    // The first reading is the right one. Its negative comes second, before readings that may give the same
    // numbers by chance: v = (0, 0, 1) is the same when it is negated and when it is negated and transformed
    // to clip coordinates.
    std::vector<std::pair<const Reading*, double>> order{{&readings.front(), 1.0}, {&readings.front(), -1.0}};
    for (const double sign : {1.0, -1.0})
        for (std::size_t i = 1; i < readings.size(); ++i) order.emplace_back(&readings[i], sign);
    for (const auto& [reading, sign] : order) {
        if (!gives(*reading, points, frames, sign, length)) continue;
        std::string words = reading->words;
        if (sign < 0) words += ", and turned round";
        const bool is_unit = std::all_of(points.begin(), points.end(), [](const ReadPoint& p) {
            return std::abs(glm::length(p.mine) - glm::length(p.ours)) <= near;
        });
        if (length == Length::Ignored && !is_unit) words += ", not of length 1";
        // They differ, or nobody had asked.
        return words == "ours" ? "ours but for small differences" : words;
    }
    return {};
}

/// Returns "ours times 0.318" if nearly all points are the same multiple of ours and the squared error that
/// is left is small beside the given numbers. Without the second condition the small numbers of another term
/// would pass as a small multiple of ours.
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

/// Whether the light has a position, that is, is not directional.
bool has_place(const std::vector<ReadPoint>& points) { return points.front().at.front().distance > 0; }

}  // namespace

BufferKind buffer_kind(const std::string& name) {
    if (name == "position") return BufferKind::Point;
    if (name == "depth") return BufferKind::Depth;
    if (name == "normal") return BufferKind::Normal;
    if (name == "view") return BufferKind::View;
    if (name.rfind("l_", 0) == 0) return BufferKind::ToLight;
    if (name.rfind("n_dot_l_", 0) == 0) return BufferKind::Cosine;
    return BufferKind::Color;
}

int buffer_light(const std::string& name) {
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    return digits == name.size() ? -1 : std::stoi(name.substr(digits));
}

std::string reading_of(BufferKind kind, const std::vector<ReadPoint>& points, const CheckFrames& frames) {
    if (points.empty()) return {};
    std::string found;
    switch (kind) {
    case BufferKind::Point:
        return first_reading(point_readings(), points, frames, Length::Counts);
    case BufferKind::Depth:
        found = first_reading(depth_readings(), points, frames, Length::Counts);
        break;
    case BufferKind::Normal:
        return first_reading(normal_readings(), points, frames, Length::Ignored);
    case BufferKind::View:
        return first_reading(direction_readings(to_eye(), true), points, frames, Length::Ignored);
    case BufferKind::ToLight:
        return first_reading(direction_readings(to_light(), has_place(points)), points, frames,
                             Length::Ignored);
    case BufferKind::Cosine:
        found = first_reading(cosine_readings(), points, frames, Length::Counts);
        break;
    case BufferKind::Color:
        break;
    }
    return found.empty() ? multiple(points) : found;
}

}  // namespace glint
