#include "judge/cast_truth.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "judge/text.hpp"
#include "oracle/float_environment.hpp"

namespace ecods::judge {
namespace {

std::optional<oracle::ExactContact> swapped(std::optional<oracle::ExactContact> contact) {
    if (!contact) return contact;
    std::swap(contact->a, contact->b_first);
    std::swap(contact->b, contact->a_second);
    return contact;
}

// The double that this fraction is, if it is one.
std::optional<double> exact_double(const mpq_class& x) {
    const double d = x.get_d();
    if (!std::isfinite(d) || mpq_class(d) != x) return std::nullopt;
    return d;
}

// x + s (y - x)
std::optional<double> between(double x, double y, double s) {
    if (x == y) return x;
    return exact_double(mpq_class(x) + mpq_class(s) * (mpq_class(y) - mpq_class(x)));
}

std::optional<Pose> pose_between(const Pose& from, const Pose& to, double s) {
    Pose pose;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            const auto x =
                column < 3 ? between(from.R(row, column), to.R(row, column), s) : between(from.t[row], to.t[row], s);
            if (!x) return std::nullopt;
            (column < 3 ? pose.R(row, column) : pose.t[row]) = *x;
        }
    }
    return pose;
}

std::optional<Pose> moved(Pose pose, const Vec3& motion, double s) {
    for (int k = 0; k < 3; ++k) {
        const auto x = exact_double(mpq_class(pose.t[k]) + mpq_class(s) * mpq_class(motion[k]));
        if (!x) return std::nullopt;
        pose.t[k] = *x;
    }
    return pose;
}

}  // namespace

std::optional<FirstContact> to_first_contact(const std::optional<oracle::ExactContact>& exact) {
    if (!exact) return std::nullopt;
    return FirstContact{exact->rounded, static_cast<ClosestKind>(exact->kind), to_feature(exact->a),
                        to_feature(exact->b)};
}

bool is_same(const std::optional<FirstContact>& x, const std::optional<FirstContact>& y) {
    if (x.has_value() != y.has_value()) return false;
    return !x || (same_bits(x->time, y->time) && x->kind == y->kind && x->a == y->a && x->b == y->b);
}

std::string text(const std::optional<FirstContact>& contact) {
    if (!contact) return "nothing";
    return fmt::format("{:a} {}: {}, {}", contact->time, written(contact->kind), text(contact->a), text(contact->b));
}

CastTruth::CastTruth(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b, int samples) {
    const oracle::Soup of_a = soup(a), of_b = soup(b);
    exact_ = oracle::first_contact(of_a, motion, of_b);
    add("cast", a, motion, b, exact_);
    const auto mirrored = swapped(exact_);
    add("cast, swapped", b, -motion, a, mirrored);
    const oracle::FloatEnvironment environment;
    const auto pose_at = [&](double s) { return moved(a.pose, motion, s); };
    if (const auto to = pose_at(1)) {
        add("cast, as a motion", {*a.what, a.pose, *to}, {*b.what, b.pose, b.pose}, exact_);
        add("cast, as the second's motion", {*b.what, b.pose, b.pose}, {*a.what, a.pose, *to}, mirrored);
    }
    const auto poses_at = [&](double s) -> std::optional<std::array<Pose, 2>> {
        const auto pose = pose_at(s);
        if (!pose) return std::nullopt;
        return std::array{*pose, b.pose};
    };
    add_samples(poses_at, *a.what, *b.what, samples);
}

CastTruth::CastTruth(const Moving<MeshShape>& a, const Moving<MeshShape>& b, int samples) {
    const oracle::MovingSoup of_a{soup<MeshShape>({*a.what, a.from}), a.to},
        of_b{soup<MeshShape>({*b.what, b.from}), b.to};
    exact_ = oracle::first_contact(of_a, of_b);
    add("cast", a, b, exact_);
    add("cast, swapped", b, a, swapped(exact_));
    const oracle::FloatEnvironment environment;
    const auto poses_at = [&](double s) -> std::optional<std::array<Pose, 2>> {
        const auto pose_a = pose_between(a.from, a.to, s), pose_b = pose_between(b.from, b.to, s);
        if (!pose_a || !pose_b) return std::nullopt;
        return std::array{*pose_a, *pose_b};
    };
    add_samples(poses_at, *a.what, *b.what, samples);
}

void CastTruth::add(const std::string& name, const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                    const std::optional<oracle::ExactContact>& expected) {
    questions_.push_back(
        {name, [=](const Ask& ask) { return cast(a, motion, b, 1, ask); }, to_first_contact(expected)});
}

void CastTruth::add(const std::string& name, const Moving<MeshShape>& a, const Moving<MeshShape>& b,
                    const std::optional<oracle::ExactContact>& expected) {
    questions_.push_back({name, [=](const Ask& ask) { return cast(a, b, 1, ask); }, to_first_contact(expected)});
}

void CastTruth::add_samples(const PosesAt& poses_at, const MeshShape& a, const MeshShape& b, int count) {
    std::vector<double> times = sample_times(count);
    if (exact_ && exact_->rounded > 0) times.push_back(neighbour(exact_->rounded, -1));
    WayTruth::add_samples(times, poses_at, a, b);
}

}  // namespace ecods::judge
