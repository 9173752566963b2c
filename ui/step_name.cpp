// Names of undo steps, derived from what changed: whoever edits need not say it, and cannot say it wrong.
#include <fmt/core.h>

#include <algorithm>

#include "ui/history.h"

namespace glint {
namespace {

/// A light that turned its shape while it moved.
bool is_carried(const Light& a, const Light& b) {
    Light same = a;
    same.position = b.position;
    same.spot.direction = b.spot.direction;
    same.area.edge_u = b.area.edge_u;
    same.area.edge_v = b.area.edge_v;
    return same == b && a.position != b.position;
}

std::string light_step(const Light& a, const Light& b) {
    const std::string& name = b.name;
    Light same = a;  // `a` with one part of `b`: equal to `b` when nothing else changed
    const auto only = [&](auto member) {
        same = a;
        same.*member = b.*member;
        return same == b;
    };
    if (only(&Light::name)) return fmt::format("Rename {}", a.name);
    if (only(&Light::position)) return fmt::format("{} {}", b.position.w == 0 ? "Turn" : "Move", name);
    if (is_carried(a, b)) return fmt::format("Move {}", name);
    if (only(&Light::enabled)) return fmt::format("Switch {} {}", name, b.enabled ? "on" : "off");
    if (only(&Light::intensity)) return fmt::format("Brightness of {}", name);
    if (only(&Light::falloff)) return fmt::format("Falloff of {}", name);
    if (only(&Light::spot)) return fmt::format("Cone of {}", name);
    if (only(&Light::area)) return fmt::format("Area of {}", name);
    if (a.space != b.space)
        return fmt::format("{} to {} coordinates", name, b.space == LightSpace::World ? "world" : "camera");
    if (a.kind != b.kind) return fmt::format("Type of {}", name);
    same = a;
    same.ambient = b.ambient, same.diffuse = b.diffuse, same.specular = b.specular;
    if (same == b) return fmt::format("Colour of {}", name);
    return fmt::format("Edit {}", name);
}

const char* transform_step(const Transform& a, const Transform& b) {
    Transform same = a;
    same.translate = b.translate;
    if (same == b) return "Move";
    same = a;
    same.rotate_deg = b.rotate_deg;
    if (same == b) return "Rotate";
    same.translate = b.translate;
    if (same == b) return "Rotate";  // about a point that is not the object's origin
    same = a;
    same.scale = b.scale;
    return same == b ? "Scale" : "Transform";
}

std::string object_step(const Object& a, const Object& b) {
    const auto only = [&](auto member) {
        Object same = a;
        same.*member = b.*member;
        return same == b;
    };
    if (only(&Object::name)) return fmt::format("Rename {}", a.name);
    if (only(&Object::transform))
        return fmt::format("{} {}", transform_step(a.transform, b.transform), b.name);
    if (only(&Object::material)) return fmt::format("Material of {}", b.name);
    if (only(&Object::normals)) return fmt::format("Normals of {}", b.name);
    if (only(&Object::source)) return fmt::format("Mesh of {}", b.name);
    return fmt::format("Edit {}", b.name);
}

/// "Add X", "Delete X", the step of the one item that differs, or "Edit <plural>".
template <class Item, class ItemStep>
std::string list_step(const std::vector<Item>& a, const std::vector<Item>& b, ItemStep item_step,
                      const char* plural) {
    const auto shorter = static_cast<std::ptrdiff_t>(std::min(a.size(), b.size()));
    const auto first = std::mismatch(a.begin(), a.begin() + shorter, b.begin()).first - a.begin();
    const auto at = static_cast<std::size_t>(first);
    if (b.size() == a.size() + 1) return fmt::format("Add {}", b[at].name);
    if (a.size() == b.size() + 1) return fmt::format("Delete {}", a[at].name);
    if (a.size() == b.size() && std::equal(a.begin() + first + 1, a.end(), b.begin() + first + 1))
        return item_step(a[at], b[at]);
    return fmt::format("Edit {}", plural);
}

std::string shading_step(const Shading& a, const Shading& b) {
    if (a.mode != b.mode) return "Shading mode";
    if (a.reflection != b.reflection) return "Reflection model";
    if (a.terms != b.terms) return "Terms";
    if (a.mistakes != b.mistakes) return "Mistakes";
    return "Shading";
}

}  // namespace

std::string step_name(const Scene& before, const Scene& after) {
    std::vector<std::string> parts;
    if (before.camera != after.camera) parts.emplace_back("Camera");
    if (before.global_ambient != after.global_ambient) parts.emplace_back("Global ambient");
    if (before.lights != after.lights)
        parts.push_back(list_step(before.lights, after.lights, light_step, "lights"));
    if (before.objects != after.objects)
        parts.push_back(list_step(before.objects, after.objects, object_step, "objects"));
    if (before.shading != after.shading) parts.push_back(shading_step(before.shading, after.shading));
    if (before.npr != after.npr) parts.emplace_back("Strokes and tones");
    if (before.display != after.display) parts.emplace_back("Display");
    if (parts.empty()) return {};
    return parts.size() == 1 ? parts.front() : "Edit scene";
}

}  // namespace glint
