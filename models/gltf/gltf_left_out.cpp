#include "models/gltf/gltf_left_out.h"

namespace glint {

void say(const GltfLeftOut& left, Warnings& w) {
    warn(w, left.textures, "material has textures, which are not read",
         "materials have textures, which are not read");
    warn(w, left.blended, "material is transparent, which is not drawn",
         "materials are transparent, which is not drawn");
    warn(w, left.colours, "primitive has colours of vertices, which are not read",
         "primitives have colours of vertices, which are not read");
    warn(w, left.skins, "node has a skin: it is shown as it was modelled",
         "nodes have a skin: they are shown as they were modelled");
    warn(w, left.animations, "animation is left out", "animations are left out");
    warn(w, left.morphs, "primitive has morph targets, which are left out",
         "primitives have morph targets, which are left out");
    warn(w, left.lines, "primitive of points or lines is left out",
         "primitives of points or lines are left out");
    warn(w, left.sparse, "primitive with sparse accessors is left out",
         "primitives with sparse accessors are left out");
    warn(w, left.cameras, "further camera is left out", "further cameras are left out");
    warn(w, left.lights, "light beyond the most that a scene has is left out",
         "lights beyond the most that a scene has are left out");
    warn(w, left.sheared, "object is sheared, which is straightened",
         "objects are sheared, which is straightened");
    warn(w, left.flat, "object whose transform has no extent is left out",
         "objects whose transforms have no extent are left out");
}

}  // namespace glint
