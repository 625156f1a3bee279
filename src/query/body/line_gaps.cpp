#include "query/body/line_gaps.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "base/double_key.hpp"
#include "exact/point/mesh_extent.hpp"
#include "geometry/find_invalid.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/mesh_body.hpp"
#include "query/solid/ray_query.hpp"
#include "query/solid/solid_memory.hpp"

namespace ecods {
namespace {

// PlaceOnLine names the vertices of the mesh of LinePlaces, whose pose maps the vertices to points on or beside the
// line.
enum PlaceOnLine : std::uint32_t { begin, after_begin, beside_begin, before_begin, end, after_end };

// LinePlaces poses the vertices named by PlaceOnLine. The pose maps (s, 1 - s, 0) to the point of a segment, or (s, r,
// 0) to the point at s + r of a ray; the third column of R is the shift. So the posed points are exact for all doubles.
class LinePlaces {
  public:
    LinePlaces(const Line& line, const Vec3& shift)
        : mesh_(Mesh::create(places(line),
                             {Triangle{begin, after_begin, beside_begin}, Triangle{before_begin, end, after_end}})),
          extent_(exact::measure(*mesh_)) {
        pose_.R << line.b, (line.is_ray ? line.b : line.a), shift;
        if (line.is_ray) pose_.t = line.a;
    }

    exact::BodyRef ref() const noexcept { return {mesh_.get(), &extent_, &pose_}; }

  private:
    static std::vector<Vec3> places(const Line& line) {
        if (!line.is_ray) return {{0, 1, 0}, {1, 0, 0}, {0, 1, 1}, {-1, 2, 0}, {1, 0, 0}, {2, -1, 0}};
        const double last = is_finite(line.end) ? line.end : 0;
        return {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {last, 0, 0}, {last, 1, 0}};
    }

    std::shared_ptr<const Mesh> mesh_;
    exact::MeshExtent extent_;
    Pose pose_;
};

bool is_first_of_rank(std::span<const ExactHit> hits, std::size_t i) noexcept {
    return i == 0 || hits[i - 1].hit.rank != hits[i].hit.rank;
}

}  // namespace

bool LineGaps::is_point(const Line& line) noexcept {
    if (line.is_ray) return key_of(line.end) == 0;
    bool is_same = true;
    for (int axis = 0; axis < 3; ++axis) is_same &= key_of(line.a[axis]) == key_of(line.b[axis]);
    return is_same;
}

LineGaps::LineGaps(const Line& line, const PosedBody& body, QueryMemory& memory)
    : hits_(exact_hits(line, body.boundary(), memory)), crosses_(hits_.size()) {
    if (is_finite(line.end)) {
        const exact::Fraction last = exact::fraction_of(line.end);
        end_ = LongFraction{{last.num.limbs(), false}, {last.den.limbs(), false}};
    }
    ends_on_surface_ = std::ranges::any_of(hits_, [&](const ExactHit& hit) { return is_at_end(hit.leave); });
    if (is_point(line)) return;
    const ShiftedLine shifted(line, hits_, body.boundary());
    for (std::size_t i = 0; i < hits_.size();) {
        std::size_t next = i;
        bool is_odd = false;
        for (; next < hits_.size() && hits_[next].hit.rank == hits_[i].hit.rank; ++next)
            is_odd ^= shifted.crosses(next);
        for (; i < next; ++i) crosses_[i] = is_odd;
    }
    if (!body.has_inside()) {
        find_gaps({});
        return;
    }
    const LinePlaces places(line, shifted.shift());
    SolidMemory& own = SolidMemory::of(memory);
    const MeshBody solid(body.boundary());
    own.frame.bind(std::array{places.ref(), solid.ref()});
    RayQuery rays(own.frame, 1, solid.tree, own.stack, QueryMemoryAccess::state(memory).counts);
    const auto side = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
        return rays.side_beside({0, p}, {0, q}, {0, r});
    };
    if (begins_on_surface()) before_begin_ = side(begin, before_begin, before_begin);
    if (ends_on_surface()) after_end_ = side(end, after_end, after_end);
    find_gaps(side(begin, after_begin, beside_begin));
}

void LineGaps::find_gaps(std::optional<Side> first) {
    bool is_inside = first == Side::inside;
    LongFraction reach;  // where the next gap may begin
    const auto add = [&](const std::optional<LongFraction>& to) {
        if (!to || compare(reach, *to) < 0) gaps_.push_back({reach, to, is_inside ? Side::inside : Side::outside});
    };
    for (std::size_t i = 0; i < hits_.size(); ++i) {
        const ExactHit& hit = hits_[i];
        if (is_first_of_rank(hits_, i)) {
            add(hit.enter);
            is_inside ^= first && crosses(i) && !hit.enter.num.is_zero();
        }
        if (compare(reach, hit.leave) < 0) reach = hit.leave;
    }
    add(end_);
}

bool LineGaps::is_at_end(const LongFraction& parameter) const noexcept {
    return end_ && compare(parameter, *end_) == 0;
}

Side LineGaps::before(const LongFraction& parameter) const {
    if (parameter.num.is_zero()) return before_begin_;
    const auto gap =
        std::ranges::lower_bound(gaps_, 0, {}, [&](const Gap& g) { return g.to ? compare(*g.to, parameter) : 1; });
    const bool is_found = gap != gaps_.end() && gap->to && compare(*gap->to, parameter) == 0;
    return is_found ? gap->side : Side::on;
}

Side LineGaps::after(const LongFraction& parameter) const {
    if (is_at_end(parameter)) return after_end_;
    const auto gap = std::ranges::lower_bound(gaps_, 0, {}, [&](const Gap& g) { return compare(g.from, parameter); });
    const bool is_found = gap != gaps_.end() && compare(gap->from, parameter) == 0;
    return is_found ? gap->side : Side::on;
}

}  // namespace ecods
