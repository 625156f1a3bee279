// Where two parts clash, and how deep.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>

#include "ecods/convex_solid.hpp"
#include "ecods/intersection.hpp"
#include "programs/clash/report.hpp"
#include "programs/clash/verdict.hpp"

namespace ecods::clash {

// The place of a verdict about these parts, with at most so many lines.
Place place_of(const Part& a, const Part& b, const Verdict& verdict, std::size_t line_limit, QueryMemory& memory);

// Which shapes are convex, found out when it is first asked. Safe from many threads.
class ConvexShapes {
  public:
    // Null if the shape is not convex. The part is a solid.
    std::shared_ptr<const ConvexSolid> find(const Part& part);

  private:
    std::mutex mutex_;
    std::unordered_map<const MeshShape*, std::shared_ptr<const ConvexSolid>> shapes_;
};

// The depth of two solids with inner points in common, as Interval says (depth.hpp).
Interval depth_of(const Part& a, const Part& b, ConvexShapes& shapes, QueryMemory& memory);

}  // namespace ecods::clash
