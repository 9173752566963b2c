#include "models/mesh/resolution/half_edges.h"

#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>

#include "models/mesh/normals.h"
#include "models/mesh/topology.h"

namespace glint {

Fans fans_of(const Mesh& mesh) {
    static const bool silent = (::omerr().disable(), true);  // it prints every face that it rejects
    static_cast<void>(silent);
    CreaseGroups groups = crease_groups(mesh, make_topology(mesh), 180);
    Fans fans;
    fans.position.resize(groups.count);
    fans.is_split.resize(mesh.positions.size(), 0);
    std::vector<std::uint32_t> first(mesh.positions.size(), no_index);
    for (std::size_t c = 0; c < groups.group.size(); ++c) {
        const std::uint32_t v = mesh.corner_position[c], fan = groups.group[c];
        fans.position[fan] = v;
        if (first[v] == no_index) first[v] = fan;
        if (first[v] == fan || fans.is_split[v] != 0) continue;
        fans.is_split[v] = 1;
        ++fans.split_count;
    }
    fans.corner = std::move(groups.group);
    return fans;
}

Mesh without_repeated_corners(const Mesh& mesh) {
    Mesh out;
    out.positions = mesh.positions;
    out.colors = mesh.colors;
    out.first_corner.push_back(0);
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t begin = out.corner_position.size();
        for (std::uint32_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c)
            if (mesh.corner_position[c] != mesh.corner_position[next_corner(mesh, f, c)])
                out.corner_position.push_back(mesh.corner_position[c]);
        if (out.corner_position.size() < begin + 3) out.corner_position.resize(begin);
        if (out.corner_position.size() > begin)
            out.first_corner.push_back(static_cast<std::uint32_t>(out.corner_position.size()));
    }
    return out;
}

Mesh triangles_of(const Mesh& mesh) {
    Mesh out;
    out.positions = mesh.positions;
    out.colors = mesh.colors;
    out.first_corner.push_back(0);
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle.corner)
            out.corner_position.push_back(mesh.corner_position[corner]);
        const std::size_t begin = out.corner_position.size() - 3;
        const auto* v = &out.corner_position[begin];
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
            out.corner_position.resize(begin);
        else
            out.first_corner.push_back(static_cast<std::uint32_t>(out.corner_position.size()));
    }
    return out;
}

std::size_t most_faces_around(const Mesh& mesh) {
    std::vector<std::size_t> faces(mesh.positions.size(), 0);
    for (const std::uint32_t v : mesh.corner_position) ++faces[v];
    return faces.empty() ? 0 : *std::max_element(faces.begin(), faces.end());
}

}  // namespace glint
