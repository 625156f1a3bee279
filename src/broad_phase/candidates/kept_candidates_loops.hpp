// The loops of KeptCandidates over all boxes or all candidates, which are compiled for each instruction set
// (simd/dispatch.hpp). What is dispatched must be inlined where that is done, so it is in this header; the class
// declares no more than the name of Loops.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "broad_phase/candidates/kept_candidates.hpp"
#include "simd/inline.hpp"

namespace ecods {

struct KeptCandidates::Loops {
    // How many boxes ahead memory is asked for.
    static constexpr std::size_t prefetch_distance = 12;

    // How many candidates ahead. The last ones are a part of their own, with none ahead.
    static constexpr std::size_t prefetch_candidates = 24;
    struct Part {
        std::size_t end;
        std::size_t ahead;
    };

    // Of a walk over all slots in their order: the box that comes some slots later, which may lie on two cache lines.
    ECODS_ALWAYS_INLINE static void prefetch_box_ahead(const KeptCandidates& self, const Aabb* boxes,
                                                       std::size_t slot) noexcept {
        const std::size_t count = self.proxies_.size();
        const auto* ahead = reinterpret_cast<const char*>(
            &boxes[self.proxies_[slot + prefetch_distance < count ? slot + prefetch_distance : count - 1]]);
        __builtin_prefetch(ahead);
        __builtin_prefetch(ahead + sizeof(Aabb) - 1);
    }

    // Whether a box is in its fat box; `line` is the box in space.
    ECODS_ALWAYS_INLINE static bool is_in_fat_box(const MovingFrame& frame, const PackedBox& fat_line, const Aabb& box,
                                                  const PackedBox& line) noexcept {
        if (frame.is_at_origin()) return contains(fat_line, line);
        PackedBox in_frame;
        make_packed_box(frame.of(box), in_frame);
        return contains(fat_line, in_frame);
    }

    // Takes the boxes of all slots from the table, and notes those that escaped from their fat boxes.
    ECODS_ALWAYS_INLINE static void move_all(KeptCandidates& self, const ProxyTable& table) {
        const Aabb* const boxes = table.boxes().data();
        const std::size_t count = self.proxies_.size();
        const MovingFrame frame = self.frame_;
        for (std::size_t slot = 0; slot < count; ++slot) {
            prefetch_box_ahead(self, boxes, slot);
            PackedBox line;
            const Aabb& box = boxes[self.proxies_[slot]];
            make_packed_box(box, line);
            if (!is_in_fat_box(frame, self.fat_lines_[slot], box, line)) [[unlikely]] {
                if (self.fat_lines_[slot].is_empty()) continue;  // a free slot
                self.escaped_.push_back({static_cast<SlotIndex>(slot), self.lines_[slot]});
            }
            self.lines_[slot] = line;
        }
    }

    // The same for some proxies.
    ECODS_ALWAYS_INLINE static void move_some(KeptCandidates& self, std::span<const ProxyIndex> proxies,
                                              const ProxyTable& table) {
        const MovingFrame frame = self.frame_;
        for (std::size_t i = 0; i < proxies.size(); ++i) {
            if (i + prefetch_distance < proxies.size()) {
                const SlotIndex ahead = self.slots_[proxies[i + prefetch_distance]];
                __builtin_prefetch(&self.lines_[ahead]);
                __builtin_prefetch(&self.fat_lines_[ahead]);
            }
            const SlotIndex slot = self.slots_[proxies[i]];
            PackedBox line;
            const Aabb& box = table.boxes()[proxies[i]];
            make_packed_box(box, line);
            if (!is_in_fat_box(frame, self.fat_lines_[slot], box, line)) [[unlikely]] {
                self.escaped_.push_back({slot, self.lines_[slot]});
            }
            self.lines_[slot] = line;
        }
    }

    // Takes the boxes of all slots, whose fat boxes are not looked at.
    ECODS_ALWAYS_INLINE static void take_all_lines(KeptCandidates& self, const ProxyTable& table) {
        const Aabb* const boxes = table.boxes().data();
        const std::size_t count = self.proxies_.size();
        for (std::size_t slot = 0; slot < count; ++slot) {
            prefetch_box_ahead(self, boxes, slot);
            if (self.lines_[slot].is_empty()) continue;  // a free slot
            make_packed_box(boxes[self.proxies_[slot]], self.lines_[slot]);
        }
    }

    // Notes which of the pairs found overlap, whose proxies go to a list, and leaves those with a box that is awake.
    ECODS_ALWAYS_INLINE static void mark_overlapping(KeptCandidates& self, std::vector<Candidate>& overlapping) {
        overlapping.resize(self.candidates_.size());
        Candidate* pair = overlapping.data();
        Candidate* write = self.candidates_.data();
        BoxReach reach;
        for (const Candidate candidate : self.candidates_) {
            const auto [a, b] = candidate;
            make_reach(self.lines_[a], reach);
            const bool now = overlaps(self.lines_[b], reach);
            *pair = {self.proxies_[a], self.proxies_[b]};
            pair += now ? 1 : 0;
            *write = {a, b | (static_cast<SlotIndex>(now) * overlap_bit)};
            write += ((self.flags_[a] | self.flags_[b]) & awake) != 0 ? 1 : 0;
        }
        self.candidates_.resize(static_cast<std::size_t>(write - self.candidates_.data()));
        overlapping.resize(static_cast<std::size_t>(pair - overlapping.data()));
    }

    // Tests all candidates, and reports those that began or ceased to overlap. Where fat boxes changed, candidates that
    // are none any more go. They did not overlap, but for those of a box that was removed.
    template <bool have_some_gone>
    ECODS_ALWAYS_INLINE static void filter(KeptCandidates& self, Update& update) {
        const PackedBox* const lines = self.lines_.data();
        const std::uint8_t* const flags = self.flags_.data();
        Candidate* const candidates = self.candidates_.data();
        Candidate* write = candidates;
        const std::size_t count = self.candidates_.size();
        std::uint64_t overlapping = 0;
        BoxReach reach;
        const Part parts[] = {{count - std::min(count, prefetch_candidates), prefetch_candidates}, {count, 0}};
        std::size_t i = 0;
        for (const Part& part : parts) {
            for (; i < part.end; ++i) {
                __builtin_prefetch(&lines[candidates[i + part.ahead][1] & ~overlap_bit]);
                const Candidate candidate = candidates[i];
                const auto [owner, entry] = candidate;
                const SlotIndex partner = entry & ~overlap_bit;
                if constexpr (have_some_gone) {
                    if (((flags[owner] | flags[partner]) & changed) != 0) [[unlikely]] {
                        make_reach(self.fat_lines_[owner], reach);
                        if (!overlaps(self.fat_lines_[partner], reach) || self.fat_lines_[owner].is_empty()) {
                            self.report_removed(candidate, update);
                            continue;
                        }
                    }
                    *write = candidate;
                }
                make_reach(lines[owner], reach);
                const bool now = overlaps(lines[partner], reach);
                overlapping += entry / overlap_bit;
                if (now != (entry >= overlap_bit)) [[unlikely]] {
                    self.report(have_some_gone ? *write : candidates[i], update);
                }
                if constexpr (have_some_gone) ++write;
            }
        }
        if constexpr (have_some_gone) self.candidates_.resize(static_cast<std::size_t>(write - candidates));
        self.overlapping_ = overlapping;
    }

    // Makes the pairs that were found the candidates.
    ECODS_ALWAYS_INLINE static void take_found(KeptCandidates& self, Update& update) {
        BoxReach reach;
        Candidate* write = self.candidates_.data();
        for (const Candidate candidate : self.candidates_) {
            const auto [a, b] = candidate;
            make_reach(self.lines_[a], reach);
            const bool now = overlaps(self.lines_[b], reach);
            // Most that overlap did so before: no branch on `now` alone, which could not be predicted.
            make_reach(self.has_flag(a, searching) ? self.old_fat_lines_[a] : self.fat_lines_[a], reach);
            const bool before =
                overlaps(self.has_flag(b, searching) ? self.old_fat_lines_[b] : self.fat_lines_[b], reach);
            if (now & !before) [[unlikely]] {
                update.began.push_back(ordered_pair(self.proxies_[a], self.proxies_[b]));
            }
            *write = {a, b | (static_cast<SlotIndex>(now) * overlap_bit)};
            write += ((self.flags_[a] | self.flags_[b]) & awake) != 0 ? 1 : 0;
        }
        self.candidates_.resize(static_cast<std::size_t>(write - self.candidates_.data()));
    }
};

}  // namespace ecods
