// PlaneSigns computes the side of a plane, spanned by a triangle of one body, on which a vertex of the other body lies.
// Integers compute each sign once for a query; then it is cached.
//
// Bodies that lie face on face have many pairs of triangles that the filter cannot decide, but few planes. If the
// coplanar triangles of a body are known (query/shape/coplanar_groups.hpp), they share one plane. If the planes of two
// groups are parallel, as for parts modelled face on face under one rotation, all points of one group are on the same
// side of the other group's plane.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/point/frame.hpp"
#include "exact/sign/exact_signs.hpp"
#include "query/shape/coplanar_groups.hpp"

namespace ecods {

// A NumberMemo is a direct-mapped cache of small numbers by 64-bit keys. An entry holds the last used one of all keys
// that are hashed to it.
class NumberMemo {
  public:
    void clear() noexcept {
        if (++epoch_ == 0) {  // epochs repeat after 2^32 calls
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
    static constexpr int size_bits = 11;  // 2^11 entries of 16 bytes: 32 KiB

    struct Entry {
        std::uint64_t key = 0;
        std::uint32_t epoch = 0;
        std::int32_t number = 0;
    };
    std::vector<Entry> entries_;  // empty before the first use
    std::uint32_t epoch_ = 1;
};

class PlaneSigns {
  public:
    static constexpr std::size_t triangle_count_max = std::size_t{1} << 31;  // of both bodies together; limited by keys

    // Deletes the groups and all cached signs. Cost: constant.
    void clear() noexcept {
        groups_ = {};
        is_parted_ = false;
        parallel_.clear();
        sides_.clear();
    }

    // Makes this object compute signs for the bodies of `frame`. `a` and `b` must be the groups of the frame's two
    // bodies, and outlive this object; either may be empty. The frame's arithmetic must be one of the integer kinds.
    void use(exact::Frame& frame, const CoplanarGroups& a, const CoplanarGroups& b) noexcept;
    bool are_used() const noexcept { return groups_[0] != nullptr; }
    const CoplanarGroups& groups(std::size_t body) const noexcept { return *groups_[body]; }

    // Returns the number of signs that were computed in integers.
    std::uint64_t computed_count() const noexcept { return computed_count_; }

    // Returns `sides` with each zero replaced by the exact sign. sides[i] is the sign of corner i of triangle `other`
    // (of the other body) relative to the plane of triangle `own` of `body`.
    exact::Sides complete(exact::Sides sides, std::size_t body, std::uint32_t own, std::uint32_t other);

    // Returns true if two parallel planes were found that have one body on each side of the gap between them.
    bool are_parted() const noexcept { return is_parted_; }

    // Returns true if triangle a of the first body and triangle b of the second are in groups whose planes are parallel
    // with a gap.
    bool are_triangles_apart(std::uint32_t a, std::uint32_t b);

    // Returns true if the planes of a group of the first body and a group of the second are parallel with a gap.
    bool are_apart(std::uint32_t group_a, std::uint32_t group_b) {
        const int side = side_of_parallel(0, group_a, group_b);
        return side == 1 || side == -1;
    }

  private:
    static constexpr int not_parallel = 2;

    // Returns the side of the plane of `group` (of `body`) on which all points of `other_group` (of the other body)
    // lie. Returns not_parallel if the planes of the two groups are not parallel.
    int side_of_parallel(std::size_t body, std::uint32_t group, std::uint32_t other_group);
    int compute_side_of_parallel(std::size_t body, std::uint32_t group, std::uint32_t other_group);
    bool part_bodies(std::size_t body, std::uint32_t group, std::uint32_t other_group, int side);

    // Returns the orientation of the body's pose: -1 if it mirrors the body, otherwise 1.
    int turn(std::size_t body);

    // Returns the side of the plane of triangle `own` (of `body`) on which a vertex of the other body lies.
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
