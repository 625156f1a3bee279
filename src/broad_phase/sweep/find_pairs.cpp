#include "broad_phase/sweep/find_pairs.hpp"

#include "broad_phase/scratch/grid_sweep.hpp"

namespace ecods {
namespace {

using SlotPairs = std::vector<std::array<SlotIndex, 2>>;

void append_pairs(const SlotPairs& among, std::span<const ProxyIndex> chosen, ProxyPairs& found) {
    for (const auto& [a, b] : among) found.push_back(ordered_pair(chosen[a], chosen[b]));
}

}  // namespace

ChosenBoxes::ChosenBoxes(std::span<const ProxyIndex> chosen, std::span<const Aabb> boxes) : chosen_(chosen) {
    std::vector<PackedBox> lines(boxes.size());
    for (SlotIndex slot = 0; slot < boxes.size(); ++slot) make_packed_box(boxes[slot], lines[slot]);
    forest_.build(lines);
}

std::uint64_t ChosenBoxes::find_pairs_among(ProxyPairs& found) const {
    SlotPairs among;
    const std::uint64_t tests = forest_.find_pairs(among);
    append_pairs(among, chosen_, found);
    return tests;
}

std::uint64_t ChosenBoxes::find_pairs_with_others(const ProxyTable& table, ProxyPairs& found) const {
    const std::vector<std::uint8_t> is_chosen = marks(table.end());
    std::uint64_t tests = 0;
    std::vector<SlotIndex> overlapping;
    PackedBox line;
    BoxReach reach;
    table.for_each([&](ProxyIndex proxy, const Aabb& box) {
        if (is_chosen[proxy] != 0) return;
        make_packed_box(box, line);
        make_reach(line, reach);
        overlapping.clear();
        tests += forest_.find(reach, overlapping);
        for (const SlotIndex slot : overlapping) found.push_back(ordered_pair(proxy, chosen_[slot]));
    });
    return tests;
}

std::vector<std::uint8_t> ChosenBoxes::marks(ProxyIndex end) const {
    std::vector<std::uint8_t> is_chosen(end);
    for (const ProxyIndex proxy : chosen_) is_chosen[proxy] = 1;
    return is_chosen;
}

std::uint64_t find_pairs_of(std::span<const ProxyIndex> chosen, const ProxyTable& table, ProxyPairs& found) {
    if (chosen.size() == table.size()) {
        std::vector<PackedBox> lines(chosen.size());
        for (SlotIndex slot = 0; slot < chosen.size(); ++slot) {
            make_packed_box(table.boxes()[chosen[slot]], lines[slot]);
        }
        SlotPairs among;
        const std::uint64_t tests = GridSweep().find_pairs(lines, among);
        append_pairs(among, chosen, found);
        return tests;
    }
    std::vector<Aabb> boxes;
    boxes.reserve(chosen.size());
    for (const ProxyIndex proxy : chosen) boxes.push_back(table.boxes()[proxy]);
    const ChosenBoxes trees(chosen, boxes);
    const std::uint64_t tests = trees.find_pairs_among(found);
    return tests + trees.find_pairs_with_others(table, found);
}

void update_from_scratch(const FindingUpdate& update) {
    const auto& [table, changes, keeper, events, counts] = update;
    ProxyPairs found;
    counts.box_tests += find_pairs_of(table.present_proxies(), table, found);
    sort_pairs(found);
    keeper.compare(table, changes, found, events);
}

}  // namespace ecods
