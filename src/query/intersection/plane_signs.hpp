// Finds on which sides of the planes of one body's triangles the other body's vertices lie. Integers compute each sign
// once for a query; then it is cached.
//
// Bodies that lie face on face have many pairs of triangles that the filter leaves open, but few planes. If a body's
// coplanar triangles are known (query/shape/coplanar_groups.hpp), they share one plane. If two such planes are
// parallel, as in parts modelled face on face under one rotation, all points of one are on the same side of the other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/point/frame.hpp"
#include "exact/sign/exact_signs.hpp"
#include "query/shape/coplanar_groups.hpp"

namespace ecods {

// A direct-mapped cache of small numbers by 64-bit keys: of all keys with one slot, it holds the last one that was
// used.
class NumberMemo {
  public:
    void clear() noexcept {
        if (++epoch_ == 0) {  // after 2^32 calls epochs would repeat
            entries_.clear();
            epoch_ = 1;
        }
    }

    template <class Make>
    int get(std::uint64_t key, Make&& make) {
        if (entries_.empty()) entries_.resize(std::size_t{1} << size_bits);
        Entry& entry = entries_[key * 0x9e3779b97f4a7c15 >> (64 - size_bits)];
        if (entry.key == key && entry.epoch == epoch_) return entry.number;
        const int number = make();
        entry = {key, epoch_, number};
        return number;
    }

  private:
    static constexpr int size_bits = 11;  // 32 KiB

    struct Entry {
        std::uint64_t key = 0;
        std::uint32_t epoch = 0;
        std::int32_t number = 0;
    };
    std::vector<Entry> entries_;  // empty until first use
    std::uint32_t epoch_ = 1;
};

class PlaneSigns {
  public:
    static constexpr std::size_t triangle_count_max = std::size_t{1} << 31;  // of both bodies; limited by keys

    // Forgets groups and signs. Cost: constant.
    void clear() noexcept {
        groups_ = {};
        is_parted_ = false;
        parallel_.clear();
        sides_.clear();
    }

    // Enables signs. The frame's arithmetic must be one of integers. The groups must be those of its two bodies; either
    // may be empty; they must outlive this.
    void use(exact::Frame& frame, const CoplanarGroups& a, const CoplanarGroups& b) noexcept;
    bool are_used() const noexcept { return groups_[0] != nullptr; }
    const CoplanarGroups& groups(std::size_t body) const noexcept { return *groups_[body]; }

    // The number of signs that were computed in integers.
    std::uint64_t computed_count() const noexcept { return computed_count_; }

    // Replaces zero signs by the exact ones. `sides` are the signs of the corners of triangle `other` of the other body
    // about the plane of triangle `own` of `body`.
    exact::Sides complete(exact::Sides sides, std::size_t body, std::uint32_t own, std::uint32_t other);

    // True if two parallel planes are known that have one body on each side of the gap between them.
    bool are_parted() const noexcept { return is_parted_; }

    // True if two triangles of the bodies are in groups, and these are in parallel planes with a gap.
    bool are_triangles_apart(std::uint32_t a, std::uint32_t b);

    // True if a group of the first body and one of the second are in parallel planes with a gap.
    bool are_apart(std::uint32_t group_a, std::uint32_t group_b) {
        const int side = side_of_parallel(0, group_a, group_b);
        return side == 1 || side == -1;
    }

  private:
    static constexpr int not_parallel = 2;

    // The side of the plane of a body's group on which all points of the other body's group lie, or not_parallel.
    int side_of_parallel(std::size_t body, std::uint32_t group, std::uint32_t other_group);
    int compute_side_of_parallel(std::size_t body, std::uint32_t group, std::uint32_t other_group);
    bool part_bodies(std::size_t body, std::uint32_t group, std::uint32_t other_group, int side);

    // The sign of a pose's orientation: -1 if it mirrors the body, otherwise 1.
    int turn(std::size_t body);

    // The side of the plane of triangle `own` on which a vertex of the other body lies.
    int side(std::size_t body, std::uint32_t own, std::uint32_t vertex);

    const Triangle& triangle(std::size_t body, std::uint32_t index) const {
        return frame_->body(body).mesh->triangles()[index];
    }

    exact::Frame* frame_ = nullptr;
    std::array<const CoplanarGroups*, 2> groups_{};
    std::array<int, 2> turn_{};  // by body; 0 until known
    bool is_parted_ = false;
    NumberMemo parallel_, sides_;
    std::uint64_t computed_count_ = 0;
};

}  // namespace ecods
