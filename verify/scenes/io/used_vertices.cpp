#include "scenes/io/used_vertices.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ecods::scenes {

UsedVertices::UsedVertices(std::vector<std::uint32_t> corners) {
    if (corners.empty()) return;
    const auto [least, greatest] = std::minmax_element(corners.begin(), corners.end());
    const std::uint32_t first = *least;
    const std::size_t span = std::size_t{*greatest} - first + 1;
    if (span / 4 > corners.size()) {
        std::sort(corners.begin(), corners.end());
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        old_numbers_ = std::move(corners);
        return;
    }
    table_.resize(span);
    for (const std::uint32_t corner : corners) table_[corner - first] = 1;
    for (std::size_t i = 0; i < span; ++i) {
        if (table_[i] == 0) continue;
        table_[i] = static_cast<std::uint32_t>(old_numbers_.size());
        old_numbers_.push_back(first + static_cast<std::uint32_t>(i));
    }
}

std::uint32_t UsedVertices::new_number(std::uint32_t old_number) const {
    if (!table_.empty()) return table_[old_number - old_numbers_.front()];
    const auto place = std::lower_bound(old_numbers_.begin(), old_numbers_.end(), old_number);
    return static_cast<std::uint32_t>(place - old_numbers_.begin());
}

}  // namespace ecods::scenes
