#include "broad_phase/sweep/find_pairs.hpp"

#include <vector>

#include "broad_phase/boxes/box_forest.hpp"
#include "broad_phase/scratch/grid_sweep.hpp"

namespace ecods {

std::uint64_t find_pairs_of(std::span<const ProxyIndex> chosen, const ProxyTable& table, ProxyPairs& found) {
    std::vector<PackedBox> lines(chosen.size());  // slots are places in `chosen`
    std::vector<std::array<SlotIndex, 2>> among;
    if (chosen.size() == table.size()) {
        for (SlotIndex slot = 0; slot < chosen.size(); ++slot)
            make_packed_box(table.boxes()[chosen[slot]], lines[slot]);
        const std::uint64_t tests = GridSweep().find_pairs(lines, among);
        for (const auto& [a, b] : among) found.push_back(ordered_pair(chosen[a], chosen[b]));
        return tests;
    }
    std::vector<BoxForest::Item> items(chosen.size());
    for (SlotIndex slot = 0; slot < chosen.size(); ++slot) {
        const Aabb& box = table.boxes()[chosen[slot]];
        make_packed_box(box, lines[slot]);
        items[slot] = BoxForest::make_item(box, slot);
    }
    BoxForest forest;
    forest.build(items, lines);

    std::uint64_t tests = forest.find_pairs(among);
    for (const auto& [a, b] : among) found.push_back(ordered_pair(chosen[a], chosen[b]));

    std::vector<std::uint8_t> is_chosen(table.end());
    for (const ProxyIndex proxy : chosen) is_chosen[proxy] = 1;
    std::vector<SlotIndex> overlapping;
    PackedBox line;
    BoxReach reach;
    for (ProxyIndex proxy = 0; proxy < table.end(); ++proxy) {
        if (is_chosen[proxy] != 0 || !table.is_present(proxy)) continue;
        make_packed_box(table.boxes()[proxy], line);
        make_reach(line, reach);
        overlapping.clear();
        tests += forest.find(reach, overlapping);
        for (const SlotIndex slot : overlapping) found.push_back(ordered_pair(proxy, chosen[slot]));
    }
    return tests;
}

}  // namespace ecods
