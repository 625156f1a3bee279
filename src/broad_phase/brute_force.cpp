#include "broad_phase/brute_force.hpp"

#include "base/bytes_of.hpp"
#include "geometry/key_box.hpp"

namespace ecods {

std::uint64_t all_pairs(const ProxyTable& table, ProxyPairs& found) {
    found.clear();
    std::vector<ProxyIndex> proxies;
    std::vector<KeyBox> boxes;
    table.for_each([&](ProxyIndex proxy, const Aabb& box) {
        proxies.push_back(proxy);
        boxes.push_back(key_box(box));
    });
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            if (overlap(boxes[i], boxes[j])) found.push_back({proxies[i], proxies[j]});
        }
    }
    const std::uint64_t count = boxes.size();
    return count == 0 ? 0 : count * (count - 1) / 2;
}

void BruteForce::update(const FindingUpdate& update) {
    update.counts.box_tests += all_pairs(update.table, found_);
    update.keeper.compare(update.table, update.changes, found_, update.events);
}

std::size_t BruteForce::bytes() const noexcept {
    return bytes_of(found_);
}

}  // namespace ecods
