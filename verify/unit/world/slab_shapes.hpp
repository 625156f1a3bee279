// Cubes of the caller's own along the axes, and the test of two of them: segments, casts and moves by slabs, in
// doubles. Exact where differences are and quotients are powers of two; that is enough for worlds compared with models.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/hit.hpp"
#include "ecods/world.hpp"

namespace ecods {

inline constexpr ShapeKind slab_kind{4};

// The times at which a point that moves is in a box.
inline std::optional<std::pair<double, double>> times_in(const Aabb& box, const Vec3& origin, const Vec3& direction,
                                                         double max_time) {
    double from = 0, to = max_time;
    for (int k = 0; k < 3; ++k) {
        const double low = box.min[k] - origin[k], high = box.max[k] - origin[k], speed = direction[k];
        if (speed == 0) {
            if (low > 0 || high < 0) return std::nullopt;
            continue;
        }
        from = std::max(from, (speed > 0 ? low : high) / speed);
        to = std::min(to, (speed > 0 ? high : low) / speed);
    }
    return from <= to ? std::optional(std::pair(from, to)) : std::nullopt;
}

class SlabShape final : public Shape {
  public:
    explicit SlabShape(double half = 0.5, bool answers_hits = true) : half_(half), answers_hits_(answers_hits) {}

    double half() const noexcept { return half_; }
    ShapeKind kind() const noexcept override { return slab_kind; }
    Aabb box(const Pose& pose) const override {
        return {pose.t - Vec3::Constant(half_), pose.t + Vec3::Constant(half_)};
    }
    std::uint64_t digest() const noexcept override { return 77; }

    // Where the line comes in, and where it goes out.
    bool answers(Question question) const noexcept override { return answers_hits_ && question == Question::hits; }
    std::vector<Hit> all_hits(const Segment& segment, const Pose& pose, const Ask& ask) const override {
        return all_hits(Ray{segment.a, segment.b - segment.a, 1}, pose, ask);
    }
    std::vector<Hit> all_hits(const Ray& ray, const Pose& pose, const Ask& /*ask*/) const override {
        const auto times = times_in(box(pose), ray.origin, ray.direction, ray.max_parameter);
        if (!times) return {};
        std::vector<Hit> hits(2);
        for (int i = 0; i < 2; ++i) {
            hits[i].parameter = hits[i].leave_parameter = i == 0 ? times->first : times->second;
            hits[i].kind = i == 0 ? HitKind::front : HitKind::back;
            hits[i].feature = {Feature::Kind::face, static_cast<std::uint32_t>(i), 0};
            hits[i].point = hits[i].leave_point = ray.origin + hits[i].parameter * ray.direction;
        }
        return hits;
    }

  private:
    double half_;
    bool answers_hits_;
};

// `answers_casts` is false: of the questions here, none.
class SlabTest final : public TwoBodyTest {
  public:
    explicit SlabTest(bool answers_casts = true) : answers_casts_(answers_casts) {}

    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return first_contact(a, Vec3::Zero(), b, 0, ask).has_value();
    }
    bool answers(Question question) const noexcept override {
        return answers_casts_ && (question == Question::cast || question == Question::cast_moving);
    }
    std::optional<FirstContact> cast(const Posed<Shape>& a, const Vec3& motion, const Posed<Shape>& b, double max_time,
                                     const Ask& ask) const override {
        return first_contact(a, motion, b, max_time, ask);
    }
    std::optional<FirstContact> cast_moving(const Moving<Shape>& a, const Moving<Shape>& b, double max_time,
                                            const Ask& ask) const override {
        const Vec3 motion = (a.to.t - a.from.t) - (b.to.t - b.from.t);
        return first_contact({*a.what, a.from}, motion, {*b.what, b.from}, max_time, ask);
    }

  private:
    // Features that say which shape is which: by the halves of their sides, in quarters.
    static Feature feature_of(const Posed<Shape>& body) {
        const double side = half_of(body);
        return {Feature::Kind::face, static_cast<std::uint32_t>(4 * side), 0};
    }
    static double half_of(const Posed<Shape>& body) {
        const auto* slab = dynamic_cast<const SlabShape*>(body.what);
        return slab != nullptr ? slab->half() : 0.5 * (body.what->box(Pose()).max[0] - body.what->box(Pose()).min[0]);
    }
    static std::optional<FirstContact> first_contact(const Posed<Shape>& a, const Vec3& motion, const Posed<Shape>& b,
                                                     double max_time, const Ask& /*ask*/) {
        const Vec3 half = Vec3::Constant(half_of(a) + half_of(b));
        const auto times = times_in({b.pose.t - half, b.pose.t + half}, a.pose.t, motion, max_time);
        if (!times) return std::nullopt;
        FirstContact contact;
        contact.time = times->first;
        contact.kind = contact.time == 0 ? ClosestKind::intersecting : ClosestKind::vertex_face;
        contact.a = feature_of(a);
        contact.b = feature_of(b);
        return contact;
    }

    bool answers_casts_;
};

}  // namespace ecods
