#include <fmt/format.h>

#include <cmath>

#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "ecods/turn.hpp"
#include "fuzz/pairs/case_run.hpp"
#include "judge/text.hpp"
#include "scenes/lattice_bodies.hpp"

namespace ecods::fuzz {
namespace {

using scenes::Random;
using scenes::TurnCase;
using scenes::hard::integer;

constexpr int grid = 4096;  // times are multiples of 1 / grid
constexpr int step = grid / 64;

TurnCase small_integers(Random& random) {
    TurnCase made{scenes::lattice_mesh(random, 4, 4, false), scenes::lattice_mesh(random, 4, 4, false), {}, {}};
    made.pose_a.t = scenes::lattice_point(random, 6);
    Quaternion& q = made.turn.q;
    do {
        q = {double(integer(random, -3, 3)), double(integer(random, -3, 3)), double(integer(random, -3, 3)),
             double(integer(random, -3, 3))};
    } while (q.w <= 0 && q.x == 0 && q.y == 0 && q.z == 0);
    made.turn.pivot_from = made.turn.pivot_to = scenes::lattice_point(random, 6);
    if (scenes::hard::coin(random)) made.turn.pivot_to += scenes::lattice_point(random, 4);
    return made;
}

// Both bodies at the time k / grid, times a factor. All numbers are multiples of 2^-12 and below 2^39: with |k| and
// grid up to 2^12 the quaternion's components are below 2^15, its square below 2^32, and other numbers below 2^5.
struct Sample {
    Pose a, b;
    double factor;

    Sample(const TurnCase& made, int k) {
        const double w = grid + k * (made.turn.q.w - 1);
        const Vec3 v = k * Vec3(made.turn.q.x, made.turn.q.y, made.turn.q.z);
        factor = w * w + v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) a.R(i, j) = 2 * v[i] * v[j];
            const int next = (i + 1) % 3, last = (i + 2) % 3;
            a.R(i, i) = w * w + v[i] * v[i] - v[next] * v[next] - v[last] * v[last];
        }
        for (int i = 0; i < 3; ++i) {
            const int next = (i + 1) % 3, last = (i + 2) % 3;
            a.R(last, next) += 2 * w * v[i];
            a.R(next, last) -= 2 * w * v[i];
        }
        const Vec3 &from = made.turn.pivot_from, &to = made.turn.pivot_to;
        for (int i = 0; i < 3; ++i) {
            a.t[i] = factor * (from[i] + (to[i] - from[i]) * k / grid);
            for (int j = 0; j < 3; ++j) a.t[i] += a.R(i, j) * (made.pose_a.t[j] - from[j]);
            b.R(i, i) = factor;
        }
    }
};

class Run : CaseRun {
  public:
    Run(std::uint32_t seed, Lie lie, CaseCounts& counts) : CaseRun(seed, lie, counts) { family_ = "small integers"; }

    void check_one() {
        const TurnCase made = small_integers(random_);
        ++counts_.cases;
        const MeshShape a(made.a), b(made.b);
        auto contact = cast({a, made.pose_a, made.turn}, {b, made.pose_b}, 1, memory_);
        if (lie_ && contact) contact->time += (1 - contact->time) / 2 + 1;
        ++counts_.kinds[family_][contact ? judge::written(contact->kind) : "nothing"];
        check_before(made, a, b, contact);
        if (contact) check_near(made, a, b, contact->time);
        if (made.turn.pivot_from == made.turn.pivot_to) check_swapped(made, a, b, contact);
        ++index_;
    }

  private:
    bool meet(const TurnCase& made, const MeshShape& a, const MeshShape& b, int k) {
        const Sample sample(made, k);
        return intersects({a, sample.a}, {b, sample.b}, memory_);
    }

    // No sample before the first time is one of contact.
    void check_before(const TurnCase& made, const MeshShape& a, const MeshShape& b,
                      const std::optional<FirstContact>& contact) {
        ++counts_.checks["apart before"];
        for (int k = 0; k <= grid; k += step) {
            if (contact && k >= contact->time * grid) return;
            if (meet(made, a, b, k)) {
                fail({"cast", fmt::format("contact at {} / {}", k, grid), judge::text(contact)}, made, "samples");
            }
        }
    }

    // Just before the first time the bodies are as near as they can come by then: no point is faster than 2 |v| / N
    // times its distance from the axis, and the glide. N changes by less than the half in between.
    void check_near(const TurnCase& made, const MeshShape& a, const MeshShape& b, double time) {
        const int k = std::max(0, static_cast<int>(std::ceil(time * grid)) - 1);
        const Sample sample(made, k);
        double radius = 0;
        for (const Vec3& v : a.mesh().vertices()) {
            radius = std::max(radius, (v + made.pose_a.t - made.turn.pivot_from).norm());
        }
        const double axis = Vec3(made.turn.q.x, made.turn.q.y, made.turn.q.z).norm();
        const double speed =
            4 * axis * radius * grid * grid / sample.factor + (made.turn.pivot_to - made.turn.pivot_from).norm();
        const double gap = distance({a, sample.a}, {b, sample.b}, memory_) / sample.factor;
        ++counts_.checks["near before"];
        if (gap > speed * 1.01 / grid) {
            fail({"cast", fmt::format("{} at {} / {}", gap, k, grid), judge::text(time)}, made, "the distance before");
        }
        counts_.checks["in contact soon after"] += k + 1 <= grid && meet(made, a, b, k + 1);
    }

    // The other body turns the other way round.
    void check_swapped(const TurnCase& made, const MeshShape& a, const MeshShape& b,
                       const std::optional<FirstContact>& contact) {
        const auto& [w, x, y, z] = made.turn.q;
        const Turn back{{w, -x, -y, -z}, made.turn.pivot_from, made.turn.pivot_to};
        const auto swapped = cast({b, made.pose_b, back}, {a, made.pose_a}, 1, memory_);
        ++counts_.checks["the other turns"];
        const auto time_of = [](const std::optional<FirstContact>& found) { return found ? found->time : -1; };
        if (time_of(swapped) != time_of(contact)) {
            fail({"cast, swapped", judge::text(contact), judge::text(swapped)}, made, "the other turns");
        }
    }
};

}  // namespace

void run_turn_samples(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    check_cases(seed, lie, counts, 1000, &Run::check_one);
}

}  // namespace ecods::fuzz
