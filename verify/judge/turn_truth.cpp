#include "judge/turn_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "judge/text.hpp"
#include "oracle/float_environment.hpp"
#include "oracle/turn_subdivision.hpp"

namespace ecods::judge {
namespace {

using Fractions = std::array<mpq_class, 3>;
using Rows = std::array<Fractions, 3>;

// The pose of a body that turns, times a factor.
struct ScaledPose {
    Rows R;
    Fractions t;
    mpq_class factor;

    ScaledPose(const Pose& pose, const Turn& turn, const mpq_class& time) {
        const mpq_class w = 1 + time * (mpq_class(turn.q.w) - 1), x = time * mpq_class(turn.q.x),
                        y = time * mpq_class(turn.q.y), z = time * mpq_class(turn.q.z);
        const mpq_class half = (w * w + x * x + y * y + z * z) / 2;
        const Rows rotation{{{half - y * y - z * z, x * y - w * z, x * z + w * y},
                             {x * y + w * z, half - x * x - z * z, y * z - w * x},
                             {x * z - w * y, y * z + w * x, half - x * x - y * y}}};
        factor = half;
        for (std::size_t row = 0; row < 3; ++row) {
            const auto k = static_cast<int>(row);
            const mpq_class from(turn.pivot_from[k]), to(turn.pivot_to[k]);
            t[row] = factor * (from + time * (to - from));
            for (std::size_t i = 0; i < 3; ++i) {
                const auto c = static_cast<int>(i);
                t[row] += rotation[row][i] * (mpq_class(pose.t[c]) - mpq_class(turn.pivot_from[c]));
                for (std::size_t column = 0; column < 3; ++column) {
                    R[row][column] += rotation[row][i] * mpq_class(pose.R(c, static_cast<int>(column)));
                }
            }
        }
    }
};

// The double that the fraction is, if it is one.
bool set_exactly(double& x, const mpq_class& exact) {
    x = exact.get_d();
    return std::isfinite(x) && mpq_class(x) == exact;
}

std::optional<std::array<Pose, 2>> poses_at(const Turning<MeshShape>& a, const Pose& b, double time) {
    const ScaledPose scaled(a.pose, a.turn, mpq_class(time));
    std::array<Pose, 2> poses;
    // Whatever power of two the factor has does not matter.
    bool are_exact = true;
    for (int row = 0; row < 3; ++row) {
        const auto r = static_cast<std::size_t>(row);
        for (int column = 0; column < 3; ++column) {
            are_exact = are_exact &&
                        set_exactly(poses[0].R(row, column), scaled.R[r][static_cast<std::size_t>(column)]) &&
                        set_exactly(poses[1].R(row, column), scaled.factor * mpq_class(b.R(row, column)));
        }
        are_exact = are_exact && set_exactly(poses[0].t[row], scaled.t[r]) &&
                    set_exactly(poses[1].t[row], scaled.factor * mpq_class(b.t[row]));
    }
    if (!are_exact) return std::nullopt;
    return poses;
}

}  // namespace

std::string text(const Turn& turn) {
    return fmt::format("({:a}, {:a}, {:a}, {:a}) about {} to {}", turn.q.w, turn.q.x, turn.q.y, turn.q.z,
                       text(turn.pivot_from), text(turn.pivot_to));
}

oracle::TurningSoup turning_soup(const Turning<MeshShape>& a) {
    const auto& [w, x, y, z] = a.turn.q;
    return {soup<MeshShape>({*a.what, a.pose}), {w, x, y, z}, a.turn.pivot_from, a.turn.pivot_to};
}

TurnTruth::TurnTruth(const Turning<MeshShape>& a, const Posed<MeshShape>& b, int samples)
    : of_a_(turning_soup(a)), of_b_(soup(b)) {
    exact_ = oracle::first_contact(of_a_, of_b_);
    add("cast", a, b, 1, exact_);
    if (a.turn.pivot_from == a.turn.pivot_to) {
        auto swapped = exact_;
        if (swapped) {
            std::swap(swapped->a, swapped->b_first);
            std::swap(swapped->b, swapped->a_second);
        }
        const auto& [w, x, y, z] = a.turn.q;
        const Turn back{{w, -x, -y, -z}, a.turn.pivot_from, a.turn.pivot_to};
        add("cast, swapped", {*b.what, b.pose, back}, {*a.what, a.pose}, 1, swapped);
    }
    const oracle::FloatEnvironment environment;
    add_limits(a, b);
    add_samples(a, b, samples);
}

void TurnTruth::add(const std::string& name, const Turning<MeshShape>& a, const Posed<MeshShape>& b, double max_time,
                    const std::optional<oracle::ExactContact>& expected) {
    questions_.push_back({name, [=](const Ask& ask) { return cast(a, b, max_time, ask); }, to_first_contact(expected)});
}

// The limit is compared with the real time.
void TurnTruth::add_limits(const Turning<MeshShape>& a, const Posed<MeshShape>& b) {
    if (!exact_) return;
    const double time = exact_->rounded;
    for (const double limit : {time, time > 0 ? neighbour(time, -1) : 0, time / 2, std::min(1.0, neighbour(time, 1))}) {
        const bool is_within = exact_->time.compare(mpq_class(limit)) <= 0;
        add(fmt::format("cast up to {:a}", limit), a, b, limit, is_within ? exact_ : std::nullopt);
    }
}

void TurnTruth::add_samples(const Turning<MeshShape>& a, const Posed<MeshShape>& b, int count) {
    WayTruth::add_samples(
        sample_times(count), [&](double s) { return poses_at(a, b.pose, s); }, *a.what, *b.what);
}

std::optional<std::string> TurnTruth::contradiction() const {
    return oracle::contradiction(of_a_, of_b_, exact_);
}

}  // namespace ecods::judge
