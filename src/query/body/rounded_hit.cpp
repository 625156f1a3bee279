// Computes hits of rounded bodies. A line is within the radius of a triangle of the core in one interval of its
// parameters. The line is in the body in the union of these intervals and, if the core is a solid, of the parts of the
// line inside the core that are further than the radius from the core's surface.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "base/double_key.hpp"
#include "ecods/error.hpp"
#include "ecods/hit.hpp"
#include "ecods/rounded.hpp"
#include "exact/measure/round/round_root_sum.hpp"
#include "exact/point/posed_point.hpp"
#include "exact/point/vectors.hpp"
#include "geometry/find_invalid.hpp"
#include "query/body/near_pairs.hpp"
#include "query/body/rounded_pair.hpp"
#include "query/body/rounded_way.hpp"
#include "query/body/starts_inside.hpp"
#include "query/intersection/asking.hpp"
#include "query/shape/mesh_body.hpp"

namespace ecods {
namespace {

using exact::RootSum;
using exact::ScaledInteger;

constexpr double no_end = std::numeric_limits<double>::infinity();

// An End is an end of an interval: its exact parameter, the parameter rounded once, and the core's feature there.
struct End {
    RootSum at;
    double rounded = 0;
    Feature feature;
};
int compare(const End& x, const End& y) {
    const std::int64_t a = key_of(x.rounded), b = key_of(y.rounded);
    return a != b ? (a < b ? -1 : 1) : exact::compare(x.at, y.at);
}

struct Interval {
    End enter, leave;

    bool is_moment() const { return compare(enter, leave) == 0; }
};

class LineAsked {
  public:
    LineAsked(const Line& line, const Posed<Rounded>& rounded, QueryMemory& memory)
        : line_(line),
          rounded_(rounded),
          memory_(memory),
          core_(CoreAndRadius(rounded).core),
          radius_(rounded.what->radius()),
          begin_(exact::exact_vector(line.a)),
          step_(line.is_ray ? exact::exact_vector(line.b) : exact::minus(exact::exact_vector(line.b), begin_)),
          begin_body_(point_shape(), Pose(Mat3::Identity(), line.a)),
          last_(last_of_box()) {
        start_ = locate(line.a, rounded, memory);
        begins_in_core_ = is_inside(line.a, core_, memory);
    }

    std::optional<Hit> first() {
        if (start_.side == Side::inside) return hit_inside(line_.a);
        if (is_point() || start_.side == Side::on) {
            const std::vector<Hit> hits = all();
            return hits.empty() ? std::nullopt : std::optional(hits.front());
        }
        RoundedWay way = way_of_line();
        std::optional<Interval> best;
        search_earliest(
            std::min(last_, line_.end),
            [&](double from, double to, std::size_t most) { return near().list(from, to, most); },
            [&](const PairList& pairs) {
                way.add(pairs);
                best = first_of(way);
                return best ? best->enter.rounded : std::numeric_limits<double>::infinity();
            });
        if (!best || !is_on_line(best->enter)) return std::nullopt;
        return hit_at(best->enter, best->is_moment() ? HitKind::face : HitKind::front, 0);
    }

    std::vector<Hit> all() {
        std::vector<Hit> hits;
        if (is_point()) {
            if (start_.side == Side::inside) hits.push_back(hit_inside(line_.a));
            if (start_.side == Side::on) hits.push_back(hit_at(beginning(), HitKind::face, 0));
            return hits;
        }
        for (const Interval& interval : intervals()) {
            if (!is_on_line(interval.enter)) break;
            const bool is_inside = hits.empty() && start_.side == Side::inside;
            const auto rank = [&] { return static_cast<std::uint32_t>(hits.size()); };
            if (!is_inside && interval.is_moment()) {
                hits.push_back(hit_at(interval.enter, HitKind::face, rank()));
                continue;
            }
            hits.push_back(is_inside ? hit_inside(line_.a) : hit_at(interval.enter, HitKind::front, rank()));
            if (is_on_line(interval.leave)) hits.push_back(hit_at(interval.leave, HitKind::back, rank()));
        }
        return hits;
    }

  private:
    bool is_point() const { return is_zero(step_) || key_of(line_.end) == 0; }
    bool is_on_line(const End& end) const {
        return key_of(line_.end) == key_of(no_end) || exact::compare(end.at, ScaledInteger(line_.end)) <= 0;
    }
    End beginning() const {
        End end;
        end.feature = start_.feature;
        return end;
    }

    NearLine near() const { return {line_, core_.boundary(), radius_, memory_}; }
    RoundedWay way_of_line() const { return {begin_body_, step_, core_.boundary(), radius_}; }

    // Returns a parameter beyond which the infinite line is outside the box of the body; infinity if none is known.
    // Along the axis on which the line is fastest, the box is passed after the greater distance of its ends. The
    // differences of ends, sums and quotients have five roundings, which 8 u' covers.
    // Claim: verify/proofs/root_sums.py
    double last_of_box() const {
        const Aabb box = rounded_.what->box(rounded_.pose);
        const Vec3 step = line_.is_ray ? line_.b : Vec3(line_.b - line_.a);
        Eigen::Index axis = 0;
        const double speed = step.cwiseAbs().maxCoeff(&axis);
        const double reach = std::max(std::abs(box.min[axis] - line_.a[axis]), std::abs(box.max[axis] - line_.a[axis]));
        const double last = (reach + 0x1p-1000) / speed * (1 + 8 * two_u);
        return speed > 0x1p-1000 && is_finite(last) ? last : no_end;
    }

    End renamed(const exact::RoundedContact::End& end, Feature feature) const {
        core_.rename(feature);
        return {end.time, end.rounded, feature};
    }

    // Returns the interval that begins at the least real parameter. If several intervals begin there, the first by the
    // order of features supplies the beginning, and the one that ends last supplies the end.
    std::optional<Interval> first_of(const RoundedWay& way) const {
        const NearTimes* best = nullptr;
        for (const NearTimes& times : way.found()) {
            if (best == nullptr || precedes(times, *best)) best = &times;
        }
        if (best == nullptr) return std::nullopt;
        Interval result{renamed(best->interval.first, best->first.b), renamed(best->interval.last, best->last.b)};
        for (const NearTimes& times : way.found()) {
            const End leave = renamed(times.interval.last, times.last.b);
            if (exact::compare(times.interval.first.time, best->interval.first.time) == 0 &&
                compare(leave, result.leave) > 0) {
                result.leave = leave;
            }
        }
        return result;
    }
    static bool precedes(const NearTimes& x, const NearTimes& y) {
        const std::int64_t a = key_of(x.interval.first.rounded), b = key_of(y.interval.first.rounded);
        if (a != b) return a < b;
        const int order = exact::compare(x.interval.first.time, y.interval.first.time);
        return order != 0 ? order < 0 : rank(x.first) < rank(y.first);
    }
    static bool leaves_later(const NearTimes& x, const NearTimes& y) {
        const std::int64_t a = key_of(x.interval.last.rounded), b = key_of(y.interval.last.rounded);
        if (a != b) return a > b;
        const int order = exact::compare(x.interval.last.time, y.interval.last.time);
        return order != 0 ? order > 0 : rank(x.last) < rank(y.last);
    }

    // Returns the intervals of parameters in which the line is in the body, ascending, from the line's beginning on.
    std::vector<Interval> intervals() {
        RoundedWay way = way_of_line();
        way.add(*near().list(0, last_, std::numeric_limits<std::size_t>::max()));
        std::vector<const NearTimes*> sorted;
        for (const NearTimes& times : way.found()) sorted.push_back(&times);
        std::ranges::sort(sorted, [](const NearTimes* x, const NearTimes* y) { return precedes(*x, *y); });
        std::vector<Interval> result;
        const NearTimes* latest = nullptr;  // of the last interval: the triangle that the line leaves last
        for (const NearTimes* const times : sorted) {
            End enter = renamed(times->interval.first, times->first.b);
            const End leave = renamed(times->interval.last, times->last.b);
            if (key_of(enter.rounded) < 0 || (result.empty() && begins_in_core_)) enter = beginning();
            const bool joins = !result.empty() && (compare(enter, result.back().leave) <= 0 ||
                                                   is_inside_between(result.back().leave, enter));
            if (!joins) {
                result.push_back({enter, leave});
                latest = times;
            } else if (leaves_later(*times, *latest)) {
                result.back().leave = leave;
                latest = times;
            }
        }
        return result;
    }

    // Returns true if the part of the line between two intervals is inside the core. All points of this part are
    // further from the core's surface than the radius. So one point of the part decides, and even a rounded point
    // decides if its error is less than the radius: there is no surface between the exact and the rounded point.
    bool is_inside_between(const End& from, const End& to) {
        if (!core_.has_inside()) return false;
        if (core_.is_convex()) return true;
        const Place place = place_on(line_, from.rounded + (to.rounded - from.rounded) / 2);
        if (!(place.error < rounded_.what->radius())) {
            throw NotSupported("the radius is too small for the coordinates: which hits are inside is not known");
        }
        return is_inside(place.point, core_, memory_);
    }

    Hit hit_at(const End& end, HitKind kind, std::uint32_t rank) const {
        Hit hit;
        hit.kind = kind;
        hit.rank = rank;
        hit.feature = end.feature;
        hit.parameter = hit.leave_parameter = end.rounded;
        for (std::size_t k = 0; k < 3; ++k) {
            hit.point[static_cast<Eigen::Index>(k)] = exact::round_root_sum(exact::affine(step_[k], end.at, begin_[k]));
        }
        hit.leave_point = hit.point;
        return hit;
    }

    const Line& line_;
    const Posed<Rounded>& rounded_;
    QueryMemory& memory_;
    PosedBody core_;
    exact::ExactSum radius_;
    exact::ScaledLongVector begin_, step_;
    Posed<MeshShape> begin_body_;  // the line's beginning
    double last_;                  // a parameter beyond which the infinite line is outside the body
    Location start_;               // where the line begins
    bool begins_in_core_ = false;  // inside a solid core, and not on its surface
};

template <class SegmentOrRay>
std::vector<Hit> find_all(const SegmentOrRay& asked, const Posed<Rounded>& rounded, const Ask& ask) {
    validate(asked);
    Asking asking(ask);
    const Line line(asked);
    return as_one_query(asking.memory(), [&] { return LineAsked(line, rounded, asking.memory()).all(); });
}

template <class SegmentOrRay>
std::optional<Hit> find_first(const SegmentOrRay& asked, const Posed<Rounded>& rounded, const Ask& ask) {
    validate(asked);
    Asking asking(ask);
    const Line line(asked);
    return as_one_query(asking.memory(), [&] { return LineAsked(line, rounded, asking.memory()).first(); });
}

}  // namespace

std::vector<Hit> Rounded::all_hits(const Segment& segment, const Pose& pose, const Ask& ask) const {
    if (key_of(radius_) == 0) return core_->all_hits(segment, pose, ask);
    return find_all(segment, {*this, pose}, ask);
}
std::vector<Hit> Rounded::all_hits(const Ray& ray, const Pose& pose, const Ask& ask) const {
    if (key_of(radius_) == 0) return core_->all_hits(ray, pose, ask);
    return find_all(ray, {*this, pose}, ask);
}
std::optional<Hit> Rounded::first_hit(const Segment& segment, const Pose& pose, const Ask& ask) const {
    if (key_of(radius_) == 0) return core_->first_hit(segment, pose, ask);
    return find_first(segment, {*this, pose}, ask);
}
std::optional<Hit> Rounded::first_hit(const Ray& ray, const Pose& pose, const Ask& ask) const {
    if (key_of(radius_) == 0) return core_->first_hit(ray, pose, ask);
    return find_first(ray, {*this, pose}, ask);
}

}  // namespace ecods
