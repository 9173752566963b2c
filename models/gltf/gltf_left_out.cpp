#include "models/gltf/gltf_items.h"

namespace glint {
namespace {

void say_camera(const GltfUnsaid& unsaid, Warnings& w) {
    if (unsaid.frustum) w.emplace_back("the frustum is written as a view whose middle is straight ahead");
    if (unsaid.mirroring)
        w.emplace_back(
            "the frustum mirrors the picture (left above right, or bottom above top), which is left out");
    if (unsaid.angle)
        w.emplace_back("the angle of view is beyond what glTF can express: the nearest is written");
}

void say_whole(const Scene& scene, Warnings& w) {
    if (scene.shading.reflection != Reflection::CookTorrance)
        w.emplace_back(
            "the reflection model is written as metal and roughness (cook-torrance), the nearest that "
            "glTF has");
    if (scene.display.transfer != Transfer::Srgb)
        w.emplace_back("glTF's pictures are encoded (sRGB): they are brighter than this scene's");
    if (scene.global_ambient != glm::vec3(0))
        w.emplace_back("the ambient light is left out, which glTF does not have");
    if (scene.transport != Transport{}) w.emplace_back("/transport is left out, which glTF does not have");
}

/// Settings other than the model that affect how faces are drawn and lit, and that glTF cannot express.
void say_shading(const Scene& scene, Warnings& w) {
    const Shading &now = scene.shading, read;
    std::string names;
    const auto add = [&names](bool differs, const char* name) {
        if (differs) names += std::string(names.empty() ? "" : ", ") + name;
    };
    add(now.mode != read.mode, "mode");
    add(now.interpolation != read.interpolation, "interpolation");
    add(now.local_viewer != read.local_viewer, "local_viewer");
    add(now.cull != read.cull, "cull");
    add(now.terms != read.terms, "terms");
    add(now.power_table != read.power_table, "power_table");
    add(now.mistakes != read.mistakes, "mistakes");
    if (!names.empty()) w.push_back("glTF has no words for these of /shading, which are left out: " + names);
    if (scene.npr.cool_to_warm || scene.npr.silhouettes || scene.npr.creases)
        w.emplace_back("cool-to-warm shading and strokes are left out, which glTF does not have");
}

void say_lights(const GltfUnsaid& unsaid, Warnings& w) {
    warn(w, unsaid.off, "light that is off is left out", "lights that are off are left out");
    warn(w, unsaid.areas, "area light is left out", "area lights are left out");
    warn(w, unsaid.falloffs,
         "light does not fall off with the square of the distance: only at the camera's target is it as "
         "bright as here",
         "lights do not fall off with the square of the distance: only at the camera's target are they as "
         "bright as here");
    warn(w, unsaid.cones, "spot has an exponent, which glTF does not have: a soft edge is written",
         "spots have exponents, which glTF does not have: soft edges are written");
    warn(w, unsaid.ambients, "light has an ambient colour, which is left out",
         "lights have ambient colours, which are left out");
    warn(w, unsaid.speculars, "light has highlights of another colour, which is left out",
         "lights have highlights of other colours, which are left out");
}

}  // namespace

Warnings said_objects(const GltfLeftOut& left) {
    Warnings w;
    warn(w, left.lines, "primitive of points or lines is left out",
         "primitives of points or lines are left out");
    warn(w, left.sparse, "primitive with sparse accessors is left out",
         "primitives with sparse accessors are left out");
    warn(w, left.instances, "instance beyond the most objects that a scene has is left out",
         "instances beyond the most objects that a scene has are left out");
    warn(w, left.flat, "object has a scale of 0, which makes it flat, and is left out",
         "objects have a scale of 0, which makes them flat, and are left out");
    warn(w, left.far, "object is larger or further away than 1e7, and is left out",
         "objects are larger or further away than 1e7, and are left out");
    return w;
}

Warnings said(const GltfLeftOut& left) {
    Warnings w;
    warn(w, left.textures, "material has textures, which are not read",
         "materials have textures, which are not read");
    warn(w, left.emissions, "material has an emissive texture: its emission is left out",
         "materials have emissive textures: their emission is left out");
    warn(w, left.blended, "material is transparent, which is not drawn",
         "materials are transparent, which is not drawn");
    warn(w, left.colours, "primitive has colours of vertices, which are not read",
         "primitives have colours of vertices, which are not read");
    warn(w, left.skins, "node has a skin: it is shown as it was modelled",
         "nodes have a skin: they are shown as they were modelled");
    warn(w, left.animations, "animation is left out", "animations are left out");
    warn(w, left.morphs, "primitive has morph targets, which are left out",
         "primitives have morph targets, which are left out");
    const Warnings objects = said_objects(left);
    w.insert(w.end(), objects.begin(), objects.end());
    warn(w, left.cameras, "further camera is left out", "further cameras are left out");
    warn(w, left.lights, "light beyond the most that a scene has is left out",
         "lights beyond the most that a scene has are left out");
    warn(w, left.cones,
         "spot has an inner angle above its outer one or an outer one above 90°, which is clamped",
         "spots have inner angles above their outer ones or outer ones above 90°, which are clamped");
    warn(w, left.ranges, "light has a range, beyond which it also shines here",
         "lights have a range, beyond which they also shine here");
    warn(w, left.sheared, "object is sheared, which is straightened",
         "objects are sheared, which is straightened");
    return w;
}

Warnings said(const GltfUnsaid& unsaid, const Scene& scene) {
    Warnings w;
    say_camera(unsaid, w);
    say_whole(scene, w);
    say_shading(scene, w);
    if (scene.shading.reflection == Reflection::CookTorrance)
        warn(w, unsaid.materials, "material has colours that no metal has: its diffuse colour is kept",
             "materials have colours that no metal has: their diffuse colours are kept");
    warn(w, unsaid.bright, "material reflects more light than it gets: its colour is clamped to 1",
         "materials reflect more light than they get: their colours end at 1");
    say_lights(unsaid, w);
    warn(w, unsaid.invisible, "invisible object is left out", "invisible objects are left out");
    warn(w, unsaid.colours, "mesh has colours of vertices, which are left out",
         "meshes have colours of vertices, which are left out");
    warn(w, unsaid.empty, "object without a triangle is left out", "objects without a triangle are left out");
    return w;
}

}  // namespace glint
