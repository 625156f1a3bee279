// A number that has every bit of an answer.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "base/hash.hpp"
#include "ecods/certificate.hpp"
#include "ecods/results.hpp"

namespace ecods::allocation {

// Every bit of answers in one number: text would have allocations of its own, most of those that fail.
class Digest {
  public:
    explicit Digest(std::uint64_t start = 0) : value_(start) {}

    void add(std::uint64_t x) { value_ = combine(value_, x); }
    void add(std::uint32_t x) { add(std::uint64_t{x}); }
    void add(bool x) { add(std::uint64_t{x}); }
    void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
    template <class Enum>
    requires std::is_enum_v<Enum>
    void add(Enum value) { add(static_cast<std::uint64_t>(value)); }
    void add(const TrianglePair& pair) {
        add(pair.a);
        add(pair.b);
    }
    void add(const Vec3& v) {
        for (int k = 0; k < 3; ++k) add(v[k]);
    }
    void add(const ClosestPoints& closest) {
        add(closest.distance);
        add(closest.a.triangle);
        add(closest.b.triangle);
        add(closest.point_a);
        add(closest.point_b);
    }
    void add(const CloseFeatures& close) {
        add(close.closest);
        add(close.direction);
    }
    void add(const DistanceBounds& bounds) {
        add(bounds.lower);
        add(bounds.upper);
    }
    void add(const TriangleIntersection& intersection) {
        for (const Vec3& corner : intersection.shared.corners()) add(corner);
        add(intersection.shared.normal);
    }
    void add(const FirstContact& contact) {
        add(contact.time);
        add(contact.a.triangle);
        add(contact.b.triangle);
    }
    void add(const Certificate& certificate) {
        add(certificate.claim());
        add(certificate.value());
        add(certificate.step_count());
        add(certificate.axis_count());
    }
    void add(const Hit& hit) {
        add(hit.parameter);
        add(hit.triangle());
    }
    template <class Answer>
    void add(const std::optional<Answer>& answer) {
        add(answer.has_value());
        if (answer) add(*answer);
    }
    template <class Answer>
    void add(const std::vector<Answer>& answers) {
        add(answers.size());
        for (const Answer& each : answers) add(each);
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_;
};

template <class Answer>
std::uint64_t digest(const Answer& answer) {
    Digest made;
    made.add(answer);
    return made.value();
}

}  // namespace ecods::allocation
