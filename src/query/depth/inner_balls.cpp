#include "query/depth/inner_balls.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "base/next.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/shape/mesh_body.hpp"

namespace ecods::depths {
namespace {

class BallSearch {
  public:
    BallSearch(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory) : a_(a), b_(b), memory_(memory) {
        // `low` and `high` become the corners of the intersection of both solids' boxes.
        Vec3 low, high;
        for (const Posed<Solid>* solid : {&a, &b}) {
            const exact::MeshExtent& extent = MeshShapeAccess::tree(*solid->what).extent;
            const Vec3 center = solid->pose.R * extent.center + solid->pose.t;
            const Vec3 half = solid->pose.R.cwiseAbs() * extent.half;
            low = solid == &a ? Vec3(center - half) : Vec3(low.cwiseMax(center - half));
            high = solid == &a ? Vec3(center + half) : Vec3(high.cwiseMin(center + half));
        }
        middle_ = 0.5 * low + 0.5 * high;
        half_ = 0.5 * high - 0.5 * low;
    }

    double find(const std::optional<BallHint>& hint) {
        for (int i = 0; i < 27; ++i) {
            const Vec3 at(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            take(middle_ + (2.0 / 3) * half_.cwiseProduct(at));
        }
        climb(half_ / 3);
        if (hint) {
            // Starts the second search without the best point so far, because a good point may be far from it.
            const double most = most_;
            most_ = -number_max;
            count_ = 0;
            take(hint->middle);
            climb(Vec3::Constant(hint->step));
            most_ = std::max(most, most_);
        }
        return std::max(0.0, most_);
    }

  private:
    static constexpr double number_max = std::numeric_limits<double>::max();
    static constexpr int halvings_max = 6;
    static constexpr int point_count_max = 90;

    // Moves the best point by steps along the axes, as long as the two balls grow; halves the steps if no step helps.
    void climb(Vec3 step) {
        for (int halvings = 0; halvings < halvings_max;) {
            const Vec3 from = best_;
            const double before = most_;
            for (int axis = 0; axis < 3; ++axis) {
                take(from + step[axis] * Vec3::Unit(axis));
                take(from - step[axis] * Vec3::Unit(axis));
            }
            if (most_ > before) continue;
            step /= 2;
            ++halvings;
        }
    }

    // Returns the radius of a ball inside the solid around the point; if the point is outside, minus its distance from
    // the solid.
    double radius(const Posed<Solid>& solid, const Vec3& point) {
        const Posed<MeshShape> at(point_shape(), {Mat3::Identity(), point});
        const Side side = locate(point, solid, memory_).side;
        if (side == Side::on) return 0;
        const double d = surface::distance(at, Posed<MeshShape>(solid), memory_);
        return side == Side::inside ? std::min(next_down(d), number_max) : -d;
    }

    void take(const Vec3& point) {
        if (count_ == point_count_max || !point.allFinite()) return;
        ++count_;
        const double r = radius(a_, point), s = radius(b_, point);
        // The sum and the product each round by at most 2^-52, so the value is rounded down. If the sum is subnormal or
        // nearly so, it is exact, and the product is at most the sum. If the sum overflows, it is above number_max.
        const double value = r > 0 && s > 0 ? std::min((r + s) * (1 - 0x1p-50), number_max) : std::min({r, s, 0.0});
        if (!(value > most_)) return;
        best_ = point;
        most_ = value;
    }

    const Posed<Solid>& a_;
    const Posed<Solid>& b_;
    QueryMemory& memory_;
    Vec3 middle_, half_;
    Vec3 best_ = Vec3::Zero();
    double most_ = -number_max;
    int count_ = 0;
};

}  // namespace

double find_inner_balls(const Posed<Solid>& a, const Posed<Solid>& b, const std::optional<BallHint>& hint,
                        QueryMemory& memory) {
    return BallSearch(a, b, memory).find(hint);
}

}  // namespace ecods::depths
