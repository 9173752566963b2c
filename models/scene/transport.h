#pragma once
// How light reaches a point: along a straight line past everything (the local model), unless something is in
// the way, or also by way of other surfaces (docs/scene_file.md, "Transport"). Plain data; renderer/transport
// computes it.

namespace glint {

enum class TransportModel { Local, Shadows, Bounces };

struct Transport {
    TransportModel model = TransportModel::Local;
    int paths = 64;   // random paths of each lit point, 1 to 65,536
    int bounces = 4;  // surfaces that a path meets at most, 0 to 64
    int seed = 1;     // another seed gives other random numbers
    bool operator==(const Transport&) const = default;
};

}  // namespace glint
