// LineGaps finds the parts of a line between the points that the line shares with the surface of a body, and the side
// of the surface on which each part is.
//
// A gap is an open interval of parameters, as long as possible, in which the line shares no point with the surface. So
// it begins at the line's beginning, at a hit, or where the line leaves a face that it runs along.
//
// Proof of the sides. A gap is on one side of the surface. The line that is shifted aside by an infinitesimal distance
// (shifted_line.hpp) is on the same side. It changes its side exactly where it crosses a triangle, since a solid has
// the points with an odd number of crossed triangles (query/solid/README.md). Each triangle that it crosses is one that
// the line hits. So the sides of all gaps follow from the side on which the shifted line begins, and from the triangles
// that it crosses at each parameter.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ecods/results.hpp"
#include "geometry/line.hpp"
#include "query/body/posed_body.hpp"
#include "query/body/shifted_line.hpp"
#include "query/hit/exact_hits.hpp"

namespace ecods {

class LineGaps {
  public:
    struct Gap {
        LongFraction from;
        std::optional<LongFraction> to;  // empty at the end of a ray without an end
        Side side;                       // outside or inside
    };

    // Finds the gaps of the line. The line must be valid. If the body has no inner points, all gaps are outside.
    LineGaps(const Line& line, const PosedBody& body, QueryMemory& memory);

    std::span<const ExactHit> hits() const noexcept { return hits_; }
    std::span<const Gap> gaps() const noexcept { return gaps_; }

    // Return true if the line's first point, or its last one, is on the surface.
    bool begins_on_surface() const noexcept { return !hits_.empty() && hits_.front().enter.num.is_zero(); }
    bool ends_on_surface() const noexcept { return ends_on_surface_; }

    // Return the side on which the line is just before, or just after, the parameter of a hit; `on` if the line runs
    // along the surface there. The line counts as continued beyond its ends.
    Side before(const LongFraction& parameter) const;
    Side after(const LongFraction& parameter) const;

    bool is_at_end(const LongFraction& parameter) const noexcept;

    // Returns true if the shifted line crosses an odd number of the triangles that are hit first at this hit's
    // parameter.
    bool crosses(std::size_t hit) const noexcept { return crosses_[hit] != 0; }

    // Returns true for a segment of length 0, or a ray that ends where it begins.
    static bool is_point(const Line& line) noexcept;

  private:
    // Sets gaps_. `first` is the side on which the shifted line begins; empty for a body without inner points.
    void find_gaps(std::optional<Side> first);

    std::vector<ExactHit> hits_;
    std::vector<Gap> gaps_;              // ascending
    std::vector<std::uint8_t> crosses_;  // by hit
    std::optional<LongFraction> end_;    // of the line; empty if the line has no end
    bool ends_on_surface_ = false;
    Side before_begin_ = Side::outside, after_end_ = Side::outside;
};

}  // namespace ecods
