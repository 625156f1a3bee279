#include "scenes/cells.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace ecods::scenes {

Cells sorted(Cells cells) {
    std::ranges::sort(cells);
    cells.erase(std::ranges::unique(cells).begin(), cells.end());
    return cells;
}

Cells shifted(const Cells& cells, const LatticePoint& by) {
    Cells result;
    for (const LatticePoint& cell : cells) result.push_back({cell[0] + by[0], cell[1] + by[1], cell[2] + by[2]});
    return result;
}

bool contains(const Cells& cells, const LatticePoint& cell) {
    return std::ranges::binary_search(cells, cell);
}

Relation relation(const Cells& a, const Cells& b) {
    if (a == b) return Relation::equal;
    if (std::ranges::includes(b, a)) return Relation::inside;
    if (std::ranges::includes(a, b)) return Relation::contains;
    if (std::ranges::any_of(a, [&](const LatticePoint& cell) { return contains(b, cell); })) {
        return Relation::overlapping;
    }
    for (const LatticePoint& x : a) {
        for (const LatticePoint& y : b) {
            if (std::abs(x[0] - y[0]) <= 1 && std::abs(x[1] - y[1]) <= 1 && std::abs(x[2] - y[2]) <= 1) {
                return Relation::touching;
            }
        }
    }
    return Relation::apart;
}

Side side_of(const LatticePoint& doubled, const Cells& cells) {
    int around = 0, taken = 0;
    for (int corner = 0; corner < 8; ++corner) {
        LatticePoint cell{};
        bool is_new = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const bool is_lower = (corner >> k & 1) != 0;
            const bool is_even = doubled[k] % 2 == 0;
            cell[k] = is_even ? doubled[k] / 2 - (is_lower ? 1 : 0) : (doubled[k] - (doubled[k] < 0 ? 1 : 0)) / 2;
            is_new = is_new && (is_even || !is_lower);
        }
        if (!is_new) continue;
        ++around;
        taken += contains(cells, cell) ? 1 : 0;
    }
    return taken == 0 ? Side::outside : taken == around ? Side::inside : Side::on;
}

std::vector<Cells> polycubes(std::size_t size_max) {
    std::set<Cells> last{{LatticePoint{0, 0, 0}}};
    std::vector<Cells> all(last.begin(), last.end());
    for (std::size_t size = 2; size <= size_max; ++size) {
        std::set<Cells> next;
        for (const Cells& cells : last) {
            for (const LatticePoint& cell : cells) {
                for (std::size_t k = 0; k < 6; ++k) {
                    LatticePoint neighbour = cell;
                    neighbour[k / 2] += k % 2 == 0 ? 1 : -1;
                    Cells grown = cells;
                    grown.push_back(neighbour);
                    grown = sorted(std::move(grown));
                    if (grown.size() < size) continue;
                    LatticePoint least = grown.front();
                    for (const LatticePoint& each : grown) {
                        for (std::size_t i = 0; i < 3; ++i) least[i] = std::min(least[i], each[i]);
                    }
                    next.insert(shifted(grown, {-least[0], -least[1], -least[2]}));
                }
            }
        }
        all.insert(all.end(), next.begin(), next.end());
        last = std::move(next);
    }
    return all;
}

}  // namespace ecods::scenes
