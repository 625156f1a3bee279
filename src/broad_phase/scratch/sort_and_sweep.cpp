#include "broad_phase/scratch/sort_and_sweep.hpp"

#include <string>

#include "base/bytes_of.hpp"
#include "broad_phase/scratch/list_pairs.hpp"
#include "ecods/error.hpp"

namespace ecods {

void SortAndSweep::build(const ProxyTable& table, BroadPhaseCounts&) {
    lines_.assign(table.end(), {});
    for (ProxyIndex proxy = 0; proxy < table.end(); ++proxy) {
        if (table.is_present(proxy)) make_packed_box(table.boxes()[proxy], lines_[proxy]);
    }
}

void SortAndSweep::take(std::span<const ProxyIndex> proxies, const ProxyTable& table) {
    for (const ProxyIndex proxy : proxies) make_packed_box(table.boxes()[proxy], lines_[proxy]);
}

void SortAndSweep::update(const FindingUpdate& update) {
    const auto& [table, changes, keeper, events, counts] = update;
    lines_.resize(table.end());
    for (const ProxyIndex proxy : changes.removed) lines_[proxy] = {};
    take(changes.moved, table);
    take(changes.added, table);
    found_.clear();
    counts.box_tests += search_.find_pairs(lines_, found_);
    list_pairs(found_, lines_.size(), pairs_);
    keeper.compare(table, changes, pairs_, events);
}

std::size_t SortAndSweep::bytes() const noexcept {
    return bytes_of(lines_) + bytes_of(found_) + bytes_of(pairs_) + search_.bytes();
}

void SortAndSweep::validate(const ProxyTable& table) const {
    for (ProxyIndex proxy = 0; proxy < table.end(); ++proxy) {
        const bool is_right = table.is_present(proxy) ? lines_[proxy] == packed_box(key_box(table.boxes()[proxy]))
                                                      : lines_[proxy].is_empty();
        if (!is_right)
            throw BrokenInvariant("sort and sweep: the box of proxy " + std::to_string(proxy) + " is not its");
    }
}

}  // namespace ecods
