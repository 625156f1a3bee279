#include "broad_phase/candidates/fat_forest.hpp"

#include <algorithm>

#include "base/bytes_of.hpp"

namespace ecods {

void FatForest::forget() noexcept {
    lacking_.clear();
    is_behind_ = is_forgotten_ = true;
}

void FatForest::refresh(std::span<const PackedBox> fat_lines) {
    if (!is_behind_) return;
    if (is_forgotten_) {
        forest_.build(fat_lines);
    } else {
        std::sort(lacking_.begin(), lacking_.end());
        lacking_.erase(std::unique(lacking_.begin(), lacking_.end()), lacking_.end());
        std::vector<BoxForest::Item> items;
        for (const SlotIndex slot : lacking_) BoxForest::append_item(slot, fat_lines, items);
        forest_.refit(fat_lines);
        forest_.add(items, fat_lines);
    }
    lacking_.clear();
    is_behind_ = is_forgotten_ = false;
}

void FatForest::add(std::span<const SlotIndex> slots, std::span<const PackedBox> fat_lines) {
    for (const SlotIndex slot : slots) forest_.remove(slot);
    if (is_behind_) {
        lacking_.insert(lacking_.end(), slots.begin(), slots.end());
        return;
    }
    std::vector<BoxForest::Item> items;
    for (const SlotIndex slot : slots) BoxForest::append_item(slot, fat_lines, items);
    forest_.add(items, fat_lines);
}

std::size_t FatForest::bytes() const noexcept {
    return forest_.bytes() + bytes_of(lacking_);
}

void FatForest::validate(std::span<const PackedBox> fat_lines) const {
    if (!is_behind_) forest_.validate(fat_lines);
}

}  // namespace ecods
