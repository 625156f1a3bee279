// Computes hashes of a world's answers, for traces. Two answers have equal digests if all their values have equal bits
// and their bodies have equal slots and generations.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/hash.hpp"
#include "ecods/cast.hpp"
#include "ecods/hit.hpp"
#include "ecods/results.hpp"

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
    template <class... Parts>
    void take(const Parts&... parts) noexcept {
        static_assert(sizeof...(Parts) > 1);
        (take(parts), ...);
    }
    void take(const BodyPair& bodies) noexcept { take(bodies.a, bodies.b); }
    void take(const Feature& feature) noexcept {
        take(std::uint64_t{feature.triangle} << 32 | feature.corner << 8 | static_cast<std::uint64_t>(feature.kind));
    }
    void take(BodyId body, const Hit& h) noexcept {
        take(body, h.parameter, h.leave_parameter);
        take(std::uint64_t{h.rank} << 8 | static_cast<std::uint64_t>(h.kind));
        take(h.feature, h.point, h.leave_point);
    }
    void take(const BodyHit& hit) noexcept { take(hit.body, hit.hit); }
    void take(const BodySidedHit& hit) noexcept {
        const SidedHit& s = hit.sided;
        take(hit.body, s.hit);
        take(static_cast<std::uint64_t>(s.passage) << 16 | static_cast<std::uint64_t>(s.before) << 8 |
             static_cast<std::uint64_t>(s.after));
        take(s.normal);
    }
    void take(const BodyInsidePart& inside) noexcept {
        const InsidePart& p = inside.part;
        take(inside.body, p.from, p.to, p.from_point, p.to_point);
        take(static_cast<std::uint64_t>(p.begin) << 8 | static_cast<std::uint64_t>(p.end));
    }
    void take(const FirstContact& contact) noexcept {
        take(contact.time, static_cast<std::uint64_t>(contact.kind), contact.a, contact.b);
    }
    void take(const BodyEntry& entered) noexcept {
        take(entered.body, entered.entry.time, entered.entry.a, entered.entry.b);
    }
    void take(const BodyContact& met) noexcept { take(met.body, met.contact); }
    void take(const Meeting& meeting) noexcept { take(meeting.bodies, meeting.contact); }
    void take(const NearestBody& nearest) noexcept { take(nearest.body, nearest.distance); }
    // Adds the bodies and the distance to the digest. Leaves out the points, because points follow from bodies and
    // poses, and traces of version 1 had no points.
    void take(const ClosestPair& closest) noexcept { take(closest.bodies, closest.distance); }
    void take(const Depth& depth) noexcept { take(depth.depth, depth.a, depth.b, depth.direction); }
    void take(const BodyDepth& pair) noexcept { take(pair.bodies, pair.depth); }
    void take(const PairDistance& pair) noexcept { take(pair.bodies, pair.distance); }
    void take(const BodyAt& at) noexcept { take(at.body, static_cast<std::uint64_t>(at.side)); }
    void take(const BodiesContaining& found) noexcept { take(found.bodies, std::uint64_t{found.skipped_count}); }
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
