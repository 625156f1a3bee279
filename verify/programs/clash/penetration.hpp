// How deep two parts are in each other: solids with inner points in common.
#pragma once

#include <memory>
#include <mutex>
#include <unordered_map>

#include "ecods/aabb.hpp"
#include "ecods/convex_solid.hpp"
#include "ecods/intersection.hpp"
#include "programs/clash/report.hpp"

namespace ecods::clash {

// Which shapes are convex, found out when it is first asked. Safe from many threads.
class ConvexShapes {
  public:
    // Null if the shape is not convex. The part is a solid.
    std::shared_ptr<const ConvexSolid> find(const Part& part);

  private:
    std::mutex mutex_;
    std::unordered_map<const MeshShape*, std::shared_ptr<const ConvexSolid>> shapes_;
};

// The depth of convex solids, and quick bounds of that of others. From above: boxes around them are parted along an
// axis. From below: a ball around the middle of the box of common points (`common`), as large as both solids hold it,
// stays met by translations of less than twice its radius; 0 if the middle is not inside both.
Interval depth_of(const Part& a, const Part& b, const Aabb& common, ConvexShapes& shapes, QueryMemory& memory);

// The same with the library's bounds of solids that are not convex, which cost some milliseconds.
Interval narrow_depth_of(const Part& a, const Part& b, ConvexShapes& shapes, QueryMemory& memory);

}  // namespace ecods::clash
