#include "environment/digest_ways.hpp"

#include <bit>

#include "base/hash.hpp"
#include "exact/measure/contact/first_meeting.hpp"
#include "exact/measure/contact/moving_triangles.hpp"
#include "exact/point/integer_points.hpp"
#include "query/cast/triangle_contacts.hpp"
#include "query/hit/hit_memory.hpp"
#include "query/hit/triangle_hits.hpp"

namespace ecods::environment {
namespace {

class Digest {
  public:
    explicit Digest(std::uint64_t start) : value_(start) {}

    void add(double x) { value_ = combine(value_, std::bit_cast<std::uint64_t>(x)); }
    void add(std::uint64_t x) { value_ = combine(value_, x); }
    void add(const Vec3& v) {
        for (int k = 0; k < 3; ++k) add(v[k]);
    }
    void add(const Feature& feature) {
        add(std::uint64_t{feature.corner} << 8 | static_cast<std::uint64_t>(feature.kind));
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_;
};

}  // namespace

// Enclosures are not the same everywhere; that they are right is.
std::uint64_t digest_of_hit(std::uint64_t start, const Line& line, const exact::BodyRef& body) {
    using Verdict = HitEnclosure::Verdict;
    Digest digest(start);
    const ScaledLine scaled(line);
    TriangleHits hits;
    hits.prepare(body);
    hits.bind(line, scaled, body);
    const Triangle& triangle = body.mesh->triangles()[0];
    const HitEnclosure enclosure = hits.enclose(triangle);
    exact::LineHit hit;
    const bool is_hit = hits.find(triangle, hit);
    digest.add(std::uint64_t{is_hit});
    digest.add(std::uint64_t{is_hit ? enclosure.verdict != Verdict::none : enclosure.verdict != Verdict::face});
    if (!is_hit) return digest.value();
    const auto add = [&](const Hit& rounded) {
        digest.add(rounded.parameter);
        digest.add(rounded.leave_parameter);
        digest.add(rounded.point);
        digest.add(rounded.leave_point);
        digest.add(rounded.feature);
        digest.add(static_cast<std::uint64_t>(rounded.kind));
    };
    add(rounded(line, hit, 0));
    if (enclosure.verdict == Verdict::face) hits.find_crossing(triangle, hit);
    add(rounded(line, hit, 0));
    // Whether it is known so cheaply is not a part of the answer; what it is must be the same.
    exact::RoundedCrossing crossing;
    if (enclosure.verdict == Verdict::face && hits.round_crossing(triangle, crossing)) {
        const Hit exact = rounded(line, hit, 0);
        if (crossing.at.parameter != exact.parameter || crossing.at.point != exact.point) digest.add(std::uint64_t{1});
    }
    return digest.value();
}

std::uint64_t digest_of_translation(std::uint64_t start, const exact::BodyRef& a, const Vec3& motion,
                                    const exact::BodyRef& b) {
    Digest digest(start);
    TriangleContacts contacts;
    contacts.bind(a, motion, b);
    const ContactInterval interval = contacts.enclose(0, 0);
    for (const ContactInterval& known : {interval, ContactInterval()}) {
        const auto contact = contacts.contact(0, 0, known);
        digest.add(std::uint64_t{contact.has_value()});
        if (!contact) continue;
        digest.add(contact->time);
        digest.add(contact->a);
        digest.add(contact->b);
        digest.add(static_cast<std::uint64_t>(contact->kind));
        digest.add(std::uint64_t{contacts.meet_by(0, 0, contact->time)});
    }
    const auto contact = contacts.contact(0, 0, ContactInterval());
    const auto is_below = [](double x, double y) {
        return std::bit_cast<std::int64_t>(x) <= std::bit_cast<std::int64_t>(y);
    };
    digest.add(std::uint64_t{!contact ||
                             (is_below(interval.lower, contact->time) && is_below(contact->time, interval.upper))});
    return digest.value();
}

std::uint64_t digest_of_motion(std::uint64_t start, const exact::BodyRef& a, const Pose& to_a, const exact::BodyRef& b,
                               const Pose& to_b) {
    Digest digest(start);
    exact::PosedPoints<12> points;
    for (std::size_t i = 0; i < 3; ++i) {
        points[i] = {a.pose, &a.mesh->vertices()[i]};
        points[3 + i] = {b.pose, &b.mesh->vertices()[i]};
        points[6 + i] = {&to_a, &a.mesh->vertices()[i]};
        points[9 + i] = {&to_b, &b.mesh->vertices()[i]};
    }
    const auto meeting = exact::with_integers(points, [](const auto& integers) {
        exact::MovingTriangles moving(integers);
        return exact::first_meeting(moving);
    });
    digest.add(std::uint64_t{meeting.has_value()});
    if (!meeting) return digest.value();
    digest.add(meeting->time);
    const exact::FeaturePair& features = meeting->features;
    for (const auto part : {static_cast<unsigned>(features.kind), unsigned{features.vertex_side}, unsigned{features.a},
                            unsigned{features.b}}) {
        digest.add(std::uint64_t{part});
    }
    return digest.value();
}

}  // namespace ecods::environment
