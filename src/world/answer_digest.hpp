// Digests of what a world answers, for traces: answers with equal bits, about bodies of equal slots and generations,
// have equal ones.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/hash.hpp"
#include "ecods/world_answers.hpp"

namespace ecods {

class AnswerDigest {
  public:
    template <class Answer>
    static std::uint64_t of(const Answer& answer) noexcept {
        AnswerDigest digest;
        digest.take(answer);
        return digest.value_;
    }

  private:
    void take(std::uint64_t word) noexcept { value_ = combine(value_, word); }
    void take(double number) noexcept { take(coordinate_bits(number)); }
    void take(const Vec3& point) noexcept {
        for (const double x : point) take(x);
    }
    void take(BodyId body) noexcept { take(std::uint64_t{body.slot} << 16 | body.generation); }
    template <class... Values>
    void take_each(const Values&... values) noexcept {
        (take(values), ...);
    }
    void take(const BodyPair& bodies) noexcept { take_each(bodies.a, bodies.b); }
    void take(const Feature& feature) noexcept {
        take(std::uint64_t{feature.triangle} << 32 | feature.corner << 8 | static_cast<std::uint64_t>(feature.kind));
    }
    void take(const BodyHit& of_body) noexcept {
        const Hit& hit = of_body.hit;
        take_each(of_body.body, hit.parameter, hit.leave_parameter,
                  std::uint64_t{hit.rank} << 8 | static_cast<std::uint64_t>(hit.kind), hit.feature, hit.point,
                  hit.leave_point);
    }
    void take(const FirstContact& contact) noexcept {
        take_each(contact.time, static_cast<std::uint64_t>(contact.kind), contact.a, contact.b);
    }
    void take(const BodyContact& met) noexcept { take_each(met.body, met.contact); }
    void take(const Meeting& meeting) noexcept { take_each(meeting.bodies, meeting.contact); }
    void take(const NearestBody& nearest) noexcept { take_each(nearest.body, nearest.distance); }
    void take(const ClosestPair& closest) noexcept { take_each(closest.bodies, closest.distance); }
    void take(const Depth& depth) noexcept { take_each(depth.depth, depth.a, depth.b, depth.direction); }
    void take(const BodyDepth& pair) noexcept { take_each(pair.bodies, pair.depth); }
    void take(const SolidDistance& pair) noexcept { take_each(pair.bodies, pair.distance); }
    void take(const BodyAt& at) noexcept { take_each(at.body, static_cast<std::uint64_t>(at.side)); }
    void take(const BodiesContaining& found) noexcept { take_each(found.bodies, std::uint64_t{found.skipped_count}); }
    template <class Item>
    void take(const std::optional<Item>& item) noexcept {
        take(std::uint64_t{item.has_value()});
        if (item) take(*item);
    }
    template <class Item>
    void take(const std::vector<Item>& items) noexcept {
        take(std::uint64_t{items.size()});
        for (const Item& item : items) take(item);
    }

    std::uint64_t value_ = 0;
};

}  // namespace ecods
