#include "broad_phase/box_index.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "base/bytes_of.hpp"
#include "ecods/error.hpp"

namespace ecods {
namespace {

// Returns a fat box that contains `box`; `line` is `box`, packed. On all sides the margin is an eighth of the greatest
// extent. In the direction of the last move, up to half of the extent is added; the move is estimated from `old`, the
// previous fat box, unless that is empty. Small margins avoid false positives of queries; any margins are correct.
PackedBox fatten(const Aabb& box, const PackedBox& line, const PackedBox& old) {
    constexpr double margin = 0.125, steps_ahead = 4;
    const double extent = (box.max - box.min).maxCoeff();
    PackedBox fat = line;
    if (!(extent <= std::numeric_limits<double>::max())) return fat;
    Aabb enlarged{box.min - Vec3::Constant(margin * extent), box.max + Vec3::Constant(margin * extent)};
    if (!old.is_empty()) {
        const Aabb before = box_of(old);
        for (int k = 0; k < 3; ++k) {
            const double step = 0.5 * ((box.min[k] - before.min[k]) + (box.max[k] - before.max[k]));
            if (step < 0) enlarged.min[k] -= std::min(-steps_ahead * step, 0.5 * extent);
            if (step > 0) enlarged.max[k] += std::min(steps_ahead * step, 0.5 * extent);
        }
    }
    make_packed_box(enlarged, fat);
    enlarge(fat, line);  // keeps the box inside, in any rounding mode
    return fat;
}

}  // namespace

void BoxIndex::note(ProxyIndex proxy) noexcept {
    if (!is_built_ || (proxy < is_noted_.size() && is_noted_[proxy] != 0)) return;
    try {
        if (proxy >= is_noted_.size()) is_noted_.resize(std::size_t{proxy} + 1);
        noted_.push_back(proxy);
        is_noted_[proxy] = 1;
    } catch (...) {
        clear();
    }
}

std::uint64_t BoxIndex::refresh(const ProxyTable& table) {
    try {
        if (is_built_) {
            const std::size_t count = noted_.size();
            catch_up(table);
            const bool is_degraded =
                4 * forest_.unsorted_count() > table.size() + 64 || escaped_since_build_ > table.size() + 64;
            if (!is_degraded) return count;
        }
        build(table);
        return table.size();
    } catch (...) {
        clear();
        throw;
    }
}

void BoxIndex::build(const ProxyTable& table) {
    clear();
    fat_lines_.resize(table.end());
    is_noted_.resize(table.end());
    std::vector<BoxForest::Item> items;
    items.reserve(table.size());
    table.for_each([&](ProxyIndex proxy, const Aabb& box) {
        PackedBox line;
        make_packed_box(box, line);
        fat_lines_[proxy] = fatten(box, line, {});
        items.push_back(BoxForest::make_item(box, proxy));
    });
    forest_.build(items, fat_lines_);
    is_built_ = true;
}

void BoxIndex::catch_up(const ProxyTable& table) {
    if (fat_lines_.size() < table.end()) fat_lines_.resize(table.end());
    std::vector<BoxForest::Item> unsorted;
    for (const ProxyIndex proxy : noted_) {
        is_noted_[proxy] = 0;
        PackedBox& fat = fat_lines_[proxy];
        if (!table.is_present(proxy)) {
            forest_.remove(proxy);
            fat = {};
            continue;
        }
        const Aabb& box = table.boxes()[proxy];
        PackedBox line;
        make_packed_box(box, line);
        if (contains(fat, line)) continue;
        const PackedBox old = fat;
        fat = fatten(box, line, old);
        ++escaped_since_build_;
        if (old.is_empty() || !overlap(old, fat)) {
            forest_.remove(proxy);
            unsorted.push_back(BoxForest::make_item(box, proxy));
        } else {
            forest_.set(proxy, fat);
        }
    }
    noted_.clear();
    if (!unsorted.empty()) forest_.add(unsorted, fat_lines_);
}

void BoxIndex::clear() noexcept {
    is_built_ = false;
    forest_ = {};
    fat_lines_.clear();
    noted_.clear();
    is_noted_.clear();
    escaped_since_build_ = 0;
}

std::size_t BoxIndex::bytes() const noexcept {
    return bytes_of(fat_lines_, noted_, is_noted_) + forest_.bytes();
}

void BoxIndex::validate(const ProxyTable& table) const {
    if (!is_built_) return;
    forest_.validate(fat_lines_);
    for (ProxyIndex proxy = 0; proxy < fat_lines_.size(); ++proxy) {
        if (is_noted_[proxy] != 0) continue;
        const bool holds = table.is_present(proxy) ? contains(fat_lines_[proxy], packed_box(key_box(table.box(proxy))))
                                                   : fat_lines_[proxy].is_empty();
        if (!holds) throw BrokenInvariant("box index: the fat box of proxy " + std::to_string(proxy) + " is wrong");
    }
}

}  // namespace ecods
