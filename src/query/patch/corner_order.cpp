#include "query/patch/corner_order.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/assert.hpp"

namespace ecods::patches {
namespace {

using convex::LeastPairs;

// A Place is the place of a patch's corner on a closed edge, in the direction of the edge.
enum class Place : std::uint8_t { beginning, inside, end };

// A Side holds the corners of the patch that are on one closed edge of a polygon.
struct Side {
    struct End {
        std::size_t corner;
        Place place;
    };
    std::array<End, 2> ends;
    std::size_t count = 0;

    void add(std::size_t corner, Place place) noexcept {
        ECODS_ASSERT(count < 2);
        if (count < 2) ends[count++] = {corner, place};
    }
    std::size_t other(std::size_t corner) const noexcept {
        return ends[0].corner == corner ? ends[1].corner : ends[0].corner;
    }
};

constexpr std::size_t short_size = 24;
using Order = ShortList<std::size_t, short_size>;

class Ring {
  public:
    Ring(const Polygons& polygons, const LeastPairs& corners) : polygons_(polygons), corners_(corners) {
        neighbors_.assign(corners.size(), {});
        for (const std::size_t of : {0, 1}) {
            sides_[of].assign(polygons[of].edge_count(), {});
            for (std::size_t i = 0; i < corners.size(); ++i) add(of, i);
            for (const Side& side : sides_[of]) link(side);
        }
    }

    // Returns the indices of the corners in their order around the normal, beginning with `first`.
    Order from(std::size_t first, const Turn& turn) const {
        Order order;
        order.push_back(first);
        std::size_t last = first, at = neighbors_[first].at[0];
        while (at != first && order.size() < corners_.size()) {
            order.push_back(at);
            last = std::exchange(at, neighbors_[at].other(last));
        }
        ECODS_ASSERT(order.size() == corners_.size());
        const auto [tail, head] = known_ ? *known_ : direction_at(first, turn);
        const auto place = std::ranges::find(order, tail);
        const std::size_t after = place + 1 == order.end() ? order[0] : place[1];
        if (after != head) std::reverse(order.begin() + 1, order.end());
        return order;
    }

  private:
    using Step = std::pair<std::size_t, std::size_t>;  // from a corner to the next one

    struct Neighbors {
        std::array<std::size_t, 2> at{};
        std::size_t count = 0;

        void add(std::size_t corner) noexcept {
            // Two corners may be on one edge of each polygon, so that the second edge links them again.
            if (std::find(at.begin(), at.begin() + count, corner) != at.begin() + count) return;
            ECODS_ASSERT(count < 2);
            at[count++] = corner;
        }
        std::size_t other(std::size_t corner) const noexcept { return at[0] == corner ? at[1] : at[0]; }
    };

    void add(std::size_t of, std::size_t corner) {
        const Polygon& polygon = polygons_[of];
        const HullFeature& part = corners_[corner][of];
        if (part.kind == Feature::Kind::face) return;
        const std::size_t i = last_[of] = polygon.index_of(part, last_[of]);
        if (part.kind == Feature::Kind::edge) return sides_[of][i].add(corner, Place::inside);
        sides_[of][i].add(corner, Place::beginning);
        sides_[of][polygon.previous(i)].add(corner, Place::end);
    }

    void link(const Side& side) {
        if (side.count < 2) return;
        const auto& [x, y] = side.ends;
        neighbors_[x.corner].add(y.corner);
        neighbors_[y.corner].add(x.corner);
        if (x.place == y.place) return;
        known_ = x.place < y.place ? Step(x.corner, y.corner) : Step(y.corner, x.corner);
    }

    // Returns the step from a corner where two edges cross to the next corner, which is on the edge that turns left.
    Step direction_at(std::size_t corner, const Turn& turn) const {
        const std::size_t of = turn.of(corners_[corner]) > 0 ? 1 : 0;
        const Side& side = sides_[of][polygons_[of].index_of(corners_[corner][of])];
        return {corner, side.other(corner)};
    }

    const Polygons& polygons_;
    const LeastPairs& corners_;
    std::array<ShortList<Side, short_size>, 2> sides_;  // by edge of each polygon
    ShortList<Neighbors, short_size> neighbors_;        // by corner
    std::array<std::size_t, 2> last_{};                 // the polygons' vertices at the last corner
    std::optional<Step> known_;
};

}  // namespace

void order_around(const Polygons& polygons, std::size_t first, LeastPairs& corners, const Turn& turn) {
    if (corners.size() < 3) {
        std::swap(corners[0], corners[first]);
        return;
    }
    const LeastPairs listed = corners;
    corners.clear();
    for (const std::size_t i : Ring(polygons, listed).from(first, turn)) corners.push_back(listed[i]);
}

}  // namespace ecods::patches
