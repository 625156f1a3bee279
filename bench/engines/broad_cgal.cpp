// CGAL's intersection of a sequence of boxes with itself, from scratch in each frame; it keeps nothing between frames.
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>

#include "engines/broad_engine.hpp"

namespace ecods::bench {

namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, ProxyIndex>;

// The constructor takes pointers to what is not const.
Box to_cgal(const Aabb& box, std::size_t index) {
    std::array<double, 3> low{box.min.x(), box.min.y(), box.min.z()};
    std::array<double, 3> high{box.max.x(), box.max.y(), box.max.z()};
    return {low.data(), high.data(), static_cast<ProxyIndex>(index)};
}

// The boxes are passed by pointers, which the manual advises for boxes that are larger than these.
void find_pairs(const std::vector<Box>& boxes, std::vector<const Box*>& order, std::vector<ProxyPair>& pairs) {
    order.clear();
    for (const Box& box : boxes) order.push_back(&box);
    pairs.clear();
    CGAL::box_self_intersection_d(order.begin(), order.end(), [&](const Box* a, const Box* b) {
        const auto [low, high] = std::minmax({a->info(), b->info()});
        pairs.push_back({low, high});
    });
}

class BroadCgal final : public BroadEngine {
  public:
    explicit BroadCgal(const scenes::MovingBoxes& boxes) {
        for (const Aabb& box : boxes.boxes) boxes_.push_back(to_cgal(box, boxes_.size()));
    }

    void run_frame(std::span<const scenes::BoxMove> moves) override {
        for (const scenes::BoxMove& move : moves) boxes_[move.index] = to_cgal(move.box, move.index);
        find_pairs(boxes_, order_, pairs_);
    }

    std::vector<ProxyPair> pairs() const override { return pairs_; }

  private:
    std::vector<Box> boxes_;
    std::vector<const Box*> order_;
    std::vector<ProxyPair> pairs_;
};

}  // namespace

std::vector<BroadMaker> cgal_broad() {
    return {{.name = "CGAL box_self_intersection_d",
             .use = "closed boxes, from scratch each frame; double",
             .traits = {.count_max = 1000},
             .set_up = makes<BroadCgal>()}};
}

std::vector<ProxyPair> overlapping_pairs_by_cgal(std::span<const Aabb> boxes) {
    std::vector<Box> made;
    for (const Aabb& box : boxes) made.push_back(to_cgal(box, made.size()));
    std::vector<const Box*> order;
    std::vector<ProxyPair> pairs;
    find_pairs(made, order, pairs);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace ecods::bench
