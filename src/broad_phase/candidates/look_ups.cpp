#include "broad_phase/candidates/look_ups.hpp"

#include <algorithm>

#include "base/bytes_of.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

// Prefetches run this number of found boxes ahead.
constexpr std::size_t found_ahead = 8;

// Holds the slots that are looked up, their previous fat boxes, and the flags by which partners are known already.
struct Asked {
    std::span<const SlotIndex> wanted;
    std::span<const PackedBox> old_fats;
    LookUps::Known known;
};

// Writes the new partners among the found boxes to `write`, in the same order, and returns their number. Compacts
// without branches, since which boxes are new is unpredictable.
ECODS_ALWAYS_INLINE std::size_t keep_new(const Asked& asked, const SlotTable& slots, std::span<const FoundBox> found,
                                         LookUps::NewPartner* write) {
    const LookUps::NewPartner* const first = write;
    const std::uint8_t* const flags = slots.flags().data();
    const PackedBox* const lines = slots.lines().data();
    const PackedBox* const fat_lines = slots.fat_lines().data();
    BoxLanes reach, reach_before;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const SlotIndex ahead = found[std::min(i + found_ahead, found.size() - 1)].slot;
        __builtin_prefetch(&flags[ahead]);
        __builtin_prefetch(&lines[ahead]);
        __builtin_prefetch(&fat_lines[ahead]);
        const auto [query, partner] = found[i];
        const SlotIndex slot = asked.wanted[query];
        make_reach(lines[slot], reach);
        make_reach(asked.old_fats[query], reach_before);
        const bool is_looked_up = (flags[partner] & asked.known.looked_up) != 0;
        const bool may_be_known = (flags[partner] & asked.known.has) == asked.known.has;
        const bool was_candidate = may_be_known & overlaps(fat_lines[partner], reach_before);
        const bool is_new = is_looked_up ? slot < partner : !was_candidate & (slot != partner);
        *write = {query, partner, overlaps(lines[partner], reach)};
        write += is_new ? 1 : 0;
    }
    return static_cast<std::size_t>(write - first);
}

}  // namespace

std::uint64_t LookUps::find(std::span<const SlotIndex> wanted, std::span<const PackedBox> old_fats, const Known& known,
                            const SlotTable& slots, const BoxForest& fat_boxes) {
    reaches_.resize(wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) make_reach(slots.fat_lines()[wanted[i]], reaches_[i]);
    found_.clear();
    const std::uint64_t tests = fat_boxes.find_each(reaches_, visits_, found_) + found_.size();
    if (partners_.size() < found_.size() + 1) partners_.resize(found_.size() + 1);
    partner_count_ = dispatch<keep_new>(Asked{wanted, old_fats, known}, slots, found_, partners_.data());
    return tests;
}

std::size_t LookUps::bytes() const noexcept {
    return bytes_of(reaches_) + bytes_of(visits_.level, visits_.next) + bytes_of(found_) + bytes_of(partners_);
}

}  // namespace ecods
