// What the tests of meshes measure.
#pragma once

#include <algorithm>
#include <map>
#include <utility>

#include "ecods/mesh.hpp"

namespace ecods::scenes {

// Of the solid that the triangles enclose; positive when they are counter-clockwise seen from outside.
inline double volume_of(const Mesh& mesh) {
    double volume = 0;
    for (const Triangle& t : mesh.triangles()) {
        const Vec3 &a = mesh.vertices()[t[0]], &b = mesh.vertices()[t[1]], &c = mesh.vertices()[t[2]];
        volume += (a.x() * (b.y() * c.z() - b.z() * c.y()) + a.y() * (b.z() * c.x() - b.x() * c.z()) +
                   a.z() * (b.x() * c.y() - b.y() * c.x())) /
                  6;
    }
    return volume;
}

// Whether each edge has two triangles, which run along it in opposite directions.
inline bool is_closed(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
    for (const Triangle& t : mesh.triangles())
        for (std::size_t i = 0; i < 3; ++i) ++count[{t[i], t[(i + 1) % 3]}];
    return std::all_of(count.begin(), count.end(), [&](const auto& entry) {
        const auto opposite = count.find({entry.first.second, entry.first.first});
        return entry.second == 1 && opposite != count.end() && opposite->second == 1;
    });
}

}  // namespace ecods::scenes
