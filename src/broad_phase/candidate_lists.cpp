#include "broad_phase/candidate_lists.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "broad_phase/bytes_of.hpp"
#include "ecods/error.hpp"

namespace ecods {
namespace {

constexpr std::uint32_t spare_entries = 2;  // a list's room to grow in place

}  // namespace

void CandidateLists::build(std::size_t count, std::span<const std::array<SlotIndex, 2>> pairs) {
    lists_.assign(count, {});
    for (const auto& [owner, other] : pairs) {
        ++lists_[owner].owned;
        ++lists_[other].count;  // those of others, until the next loop
    }
    std::size_t end = 0;
    for (List& list : lists_) {
        list.begin = end;
        list.capacity = list.owned + list.count + spare_entries;
        list.count = list.owned;
        list.owned = 0;
        end += list.capacity;
    }
    partners_.resize(end);
    mirrors_.resize(end);
    for (const auto& [owner, other] : pairs) {
        const std::uint32_t index = lists_[owner].owned++;
        const std::uint32_t mirror = lists_[other].count++;
        put(owner, index, other, mirror);
        put(other, mirror, owner, index);
    }
    size_ = pairs.size();
}

void CandidateLists::renumber(std::span<const SlotIndex> old_slots) {
    std::vector<SlotIndex> new_slots(lists_.size());
    std::vector<List> lists(old_slots.size());
    for (SlotIndex slot = 0; slot < old_slots.size(); ++slot) {
        new_slots[old_slots[slot]] = slot;
        lists[slot] = lists_[old_slots[slot]];
    }
    lists_ = std::move(lists);
    for (const List& list : lists_) {
        for (std::size_t at = list.begin; at < list.begin + list.count; ++at) {
            partners_[at] = new_slots[slot_of(partners_[at])] | (partners_[at] & overlap_bit);
        }
    }
}

void CandidateLists::put(SlotIndex slot, std::uint32_t index, std::uint32_t entry, std::uint32_t mirror) {
    partners_[lists_[slot].begin + index] = entry;
    mirrors_[lists_[slot].begin + index] = mirror;
}

void CandidateLists::move_entry(SlotIndex slot, std::uint32_t from, std::uint32_t to) {
    if (from == to) return;
    const std::size_t at = lists_[slot].begin + from;
    put(slot, to, partners_[at], mirrors_[at]);
    mirrors_[lists_[slot_of(partners_[at])].begin + mirrors_[at]] = to;
}

void CandidateLists::grow(SlotIndex slot) {
    if (partners_.size() > 4 * (size_ + lists_.size()) + 1024) compact();
    List& list = lists_[slot];
    if (list.count < list.capacity) return;
    const std::size_t begin = partners_.size();
    list.capacity = 2 * list.count + 2 * spare_entries;
    partners_.resize(begin + list.capacity);
    mirrors_.resize(begin + list.capacity);
    std::copy_n(partners_.begin() + static_cast<std::ptrdiff_t>(list.begin), list.count,
                partners_.begin() + static_cast<std::ptrdiff_t>(begin));
    std::copy_n(mirrors_.begin() + static_cast<std::ptrdiff_t>(list.begin), list.count,
                mirrors_.begin() + static_cast<std::ptrdiff_t>(begin));
    list.begin = begin;
}

// Lists that grew have left gaps, and some have more room than they need.
void CandidateLists::compact() {
    std::vector<std::uint32_t> partners, mirrors;
    partners.reserve(2 * size_ + spare_entries * lists_.size());
    mirrors.reserve(2 * size_ + spare_entries * lists_.size());
    for (List& list : lists_) {
        const auto begin = static_cast<std::ptrdiff_t>(list.begin);
        list.begin = partners.size();
        list.capacity = list.count + spare_entries;
        partners.insert(partners.end(), partners_.begin() + begin, partners_.begin() + begin + list.count);
        mirrors.insert(mirrors.end(), mirrors_.begin() + begin, mirrors_.begin() + begin + list.count);
        partners.resize(partners.size() + spare_entries);
        mirrors.resize(mirrors.size() + spare_entries);
    }
    partners_ = std::move(partners);
    mirrors_ = std::move(mirrors);
}

// The index of a free entry in its part of the list, which now is one longer.
std::uint32_t CandidateLists::make_room(SlotIndex slot, bool is_owned) {
    if (lists_[slot].count == lists_[slot].capacity) grow(slot);
    List& list = lists_[slot];
    std::uint32_t index = list.count++;
    if (is_owned) {
        move_entry(slot, list.owned, index);
        index = list.owned++;
    }
    return index;
}

void CandidateLists::add(SlotIndex owner, SlotIndex other, bool overlap) {
    const std::uint32_t bit = overlap ? overlap_bit : 0;
    const std::uint32_t mirror = make_room(other, false);
    put(other, mirror, owner, 0);
    const std::uint32_t index = make_room(owner, true);
    put(owner, index, other | bit, mirror);
    put(other, mirror, owner | bit, index);
    ++size_;
}

void CandidateLists::remove(SlotIndex slot, std::uint32_t index) {
    const std::size_t at = lists_[slot].begin + index;
    const std::pair<SlotIndex, std::uint32_t> ends[] = {{slot, index}, {slot_of(partners_[at]), mirrors_[at]}};
    for (auto [end, gap] : ends) {
        List& list = lists_[end];
        if (gap < list.owned) {
            move_entry(end, --list.owned, gap);
            gap = list.owned;
        }
        move_entry(end, --list.count, gap);
    }
    --size_;
}

std::size_t CandidateLists::bytes() const noexcept {
    return bytes_of(lists_, partners_, mirrors_);
}

void CandidateLists::validate() const {
    const auto require = [](bool holds, SlotIndex slot, const char* what) {
        if (!holds) throw BrokenInvariant("candidates of slot " + std::to_string(slot) + ": " + what);
    };
    std::vector<std::pair<std::size_t, std::size_t>> ranges;
    std::size_t entry_count = 0;
    for (SlotIndex slot = 0; slot < lists_.size(); ++slot) {
        const List& list = lists_[slot];
        require(list.owned <= list.count && list.count <= list.capacity, slot, "a count is wrong");
        require(list.begin + list.capacity <= partners_.size(), slot, "the list is out of range");
        if (list.capacity > 0) ranges.emplace_back(list.begin, list.begin + list.capacity);
        entry_count += list.count;
        std::vector<SlotIndex> partners;
        for (std::uint32_t i = 0; i < list.count; ++i) {
            const std::uint32_t entry = partners_[list.begin + i];
            const SlotIndex partner = slot_of(entry);
            partners.push_back(partner);
            require(partner < lists_.size() && partner != slot, slot, "a partner is none");
            const List& other = lists_[partner];
            const std::uint32_t mirror = mirrors_[list.begin + i];
            require(mirror < other.count && mirrors_[other.begin + mirror] == i &&
                        partners_[other.begin + mirror] == (slot | (entry & overlap_bit)),
                    slot, "a mirror does not mirror");
            require((i < list.owned) != (mirror < other.owned), slot, "a candidate has two owners, or none");
        }
        std::sort(partners.begin(), partners.end());
        require(std::adjacent_find(partners.begin(), partners.end()) == partners.end(), slot,
                "a candidate is there twice");
    }
    std::sort(ranges.begin(), ranges.end());
    for (std::size_t i = 1; i < ranges.size(); ++i)
        require(ranges[i - 1].second <= ranges[i].first, 0, "lists overlap");
    if (entry_count != 2 * size_) throw BrokenInvariant("the number of candidates is wrong");
}

}  // namespace ecods
