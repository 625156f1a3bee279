// The oracle says whether a mesh bounds a solid before the library is asked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "judge/wrong.hpp"
#include "oracle/solid.hpp"

namespace ecods::judge {

class WhetherSolid {
  public:
    explicit WhetherSolid(const Mesh& mesh);  // asks the oracle

    bool is_solid() const { return !is_empty_ && !open_ && pairs_.empty(); }

    // "a solid", "nothing", "open edge TRIANGLE.CORNER", or the first pair of triangles that meet wrongly.
    std::string words() const;

    // Asks the library: check_solid and self_intersections.
    std::optional<Wrong> ask(const Mesh& mesh) const;

  private:
    bool is_empty_;
    std::optional<oracle::CornerEdge> open_;
    std::vector<TrianglePair> pairs_;
};

}  // namespace ecods::judge
