// Boxes that moved, and what that means for the candidates there are.
#include "base/dispatch.hpp"
#include "broad_phase/kept_candidates.hpp"

namespace ecods {
namespace {

// How many boxes ahead memory is asked for.
constexpr SlotIndex prefetch_distance = 12;

}  // namespace

ECODS_FOR_EACH_INSTRUCTION_SET
void KeptCandidates::move_all(const ProxyTable& table) {
    const Aabb* const boxes = table.boxes().data();
    const std::size_t count = proxies_.size();
    for (std::size_t slot = 0; slot < count; ++slot) {
        const auto* ahead = reinterpret_cast<const char*>(
            &boxes[proxies_[slot + prefetch_distance < count ? slot + prefetch_distance : count - 1]]);
        __builtin_prefetch(ahead);
        __builtin_prefetch(ahead + sizeof(Aabb) - 1);
        BoxLine line;
        make_box_line(boxes[proxies_[slot]], line);
        if (!contains(fat_lines_[slot], line)) [[unlikely]] {
            if (fat_lines_[slot].is_empty()) continue;  // a free slot
            escaped_.push_back({static_cast<SlotIndex>(slot), lines_[slot]});
        }
        lines_[slot] = line;
    }
}

ECODS_FOR_EACH_INSTRUCTION_SET
void KeptCandidates::move_some(const std::vector<ProxyIndex>& proxies, const ProxyTable& table) {
    movers_.clear();
    for (std::size_t i = 0; i < proxies.size(); ++i) {
        if (i + prefetch_distance < proxies.size()) {
            const SlotIndex ahead = slots_[proxies[i + prefetch_distance]];
            __builtin_prefetch(&lines_[ahead]);
            __builtin_prefetch(&fat_lines_[ahead]);
        }
        const SlotIndex slot = slots_[proxies[i]];
        BoxLine line;
        make_box_line(table.boxes()[proxies[i]], line);
        if (!contains(fat_lines_[slot], line)) [[unlikely]] {
            escaped_.push_back({slot, lines_[slot]});
        }
        lines_[slot] = line;
        flags_[slot] |= is_mover;
        movers_.push_back(slot);
    }
}

// A candidate began or ceased to overlap.
void KeptCandidates::report(SlotIndex slot, std::uint32_t index, Update& update) {
    const std::uint32_t entry = candidates_.entries(slot)[index];
    const ProxyPair pair = ordered_pair(proxies_[slot], proxies_[CandidateLists::slot_of(entry)]);
    (CandidateLists::overlaps(entry) ? update.ended : update.began).push_back(pair);
    candidates_.flip(slot, index);
}

ECODS_FOR_EACH_INSTRUCTION_SET
void KeptCandidates::filter_all(Update& update) {
    BoxReach reach;
    const auto slot_count = static_cast<SlotIndex>(candidates_.slot_count());
    const BoxLine* const lines = lines_.data();
    for (SlotIndex slot = 0; slot < slot_count; ++slot) {
        const SlotIndex ahead = slot + prefetch_distance < slot_count ? slot + prefetch_distance : slot;
        const std::uint32_t* const entries_ahead = candidates_.entries(ahead).data();
        const std::uint32_t count_ahead = candidates_.owned_count(ahead);
        for (std::uint32_t i = 0; i < count_ahead; ++i) {
            const auto* line = reinterpret_cast<const char*>(&lines[CandidateLists::slot_of(entries_ahead[i])]);
            __builtin_prefetch(line);
        }
        const std::uint32_t count = candidates_.owned_count(slot);
        if (count == 0) continue;
        make_reach(lines_[slot], reach);
        const std::uint32_t* const entries = candidates_.entries(slot).data();
        for (std::uint32_t i = 0; i < count; ++i) {
            const bool now = overlaps(lines[CandidateLists::slot_of(entries[i])], reach);
            if (now != CandidateLists::overlaps(entries[i])) [[unlikely]] {
                report(slot, i, update);
            }
        }
    }
    update.counts.candidates_filtered += candidates_.size();
}

ECODS_FOR_EACH_INSTRUCTION_SET
void KeptCandidates::filter_movers(Update& update) {
    BoxReach reach;
    std::uint64_t filtered = 0;
    for (const SlotIndex slot : movers_) {
        make_reach(lines_[slot], reach);
        const auto entries = candidates_.entries(slot);
        const std::uint32_t owned = candidates_.owned_count(slot);
        filtered += entries.size();
        for (std::uint32_t i = 0; i < entries.size(); ++i) {
            const SlotIndex partner = CandidateLists::slot_of(entries[i]);
            const bool now = overlaps(lines_[partner], reach);
            if (now == CandidateLists::overlaps(entries[i])) [[likely]] {
                continue;
            }
            // Of two that moved, the owner reports; the partner would turn the bit back.
            if (i >= owned && (flags_[partner] & is_mover) != 0) continue;
            report(slot, i, update);
        }
    }
    update.counts.candidates_filtered += filtered;
    for (const SlotIndex slot : movers_) flags_[slot] = 0;
    movers_.clear();
}

}  // namespace ecods
