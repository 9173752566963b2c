#pragma once
// How light reaches a point: directly, ignoring all objects in between (the local model); directly unless an
// object blocks it; or also by reflection at other surfaces (docs/scene_file.md, "Transport"). Plain data;
// renderer/transport computes it.

namespace glint {

enum class TransportModel { Local, Shadows, Bounces };

struct Transport {
    TransportModel model = TransportModel::Local;
    int paths = 64;   // random paths per lit point, 1 to 65,536
    int bounces = 4;  // maximum number of surfaces on a path, 0 to 64
    int seed = 1;     // a different seed gives different random numbers
    bool operator==(const Transport&) const = default;
};

}  // namespace glint
