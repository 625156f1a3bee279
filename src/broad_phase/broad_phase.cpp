#include "ecods/broad_phase.hpp"

#include <algorithm>
#include <string>

#include "broad_phase/brute_force.hpp"
#include "broad_phase/changes/pair_list.hpp"
#include "broad_phase/overlap_tracker.hpp"
#include "ecods/error.hpp"

namespace ecods {
namespace {

bool is_strictly_ascending(const ProxyPairs& pairs) {
    return std::adjacent_find(pairs.begin(), pairs.end(),
                              [](const ProxyPair& a, const ProxyPair& b) { return !(a < b); }) == pairs.end();
}

std::string text(const ProxyPair& pair) {
    return std::to_string(pair.a) + ", " + std::to_string(pair.b);
}

// Throws BrokenInvariant unless `pairs` equals the result of all_pairs(), all three lists are ascending, each pair that
// began is in `pairs`, and each pair that ended is not in `pairs` or has begun again.
void validate_pairs(const ProxyTable& table, const ProxyPairs& pairs, const ProxyPairs& began,
                    const ProxyPairs& ended) {
    for (const ProxyPairs* list : {&pairs, &began, &ended}) {
        if (!is_strictly_ascending(*list)) throw BrokenInvariant("broad phase: a list of pairs is not ascending");
    }
    ProxyPairs expected;
    all_pairs(table, expected);
    for (std::size_t i = 0; i < std::max(pairs.size(), expected.size()); ++i) {
        if (i == expected.size() || (i < pairs.size() && pairs[i] < expected[i])) {
            throw BrokenInvariant("broad phase: false positive " + text(pairs[i]));
        }
        if (i == pairs.size() || expected[i] < pairs[i]) {
            throw BrokenInvariant("broad phase: false negative " + text(expected[i]));
        }
    }
    if (!std::includes(pairs.begin(), pairs.end(), began.begin(), began.end())) {
        throw BrokenInvariant("broad phase: a pair began that is not here");
    }
    for (const ProxyPair& pair : ended) {
        if (std::binary_search(pairs.begin(), pairs.end(), pair) &&
            !std::binary_search(began.begin(), began.end(), pair)) {
            throw BrokenInvariant("broad phase: pair " + text(pair) + " ended and is here");
        }
    }
}

// Implements the public BroadPhase by an OverlapTracker and a list of the pairs.
class ListingBroadPhase final : public BroadPhase {
  public:
    explicit ListingBroadPhase(BroadPhaseKind kind) : tracker_(kind) {}

    BroadPhaseKind kind() const noexcept override { return tracker_.kind(); }
    void reserve(std::size_t count) override { tracker_.reserve(count); }
    void add(ProxyIndex proxy, const Aabb& box) override { tracker_.add(proxy, box); }
    void move(ProxyIndex proxy, const Aabb& box) override { tracker_.move(proxy, box); }
    void move(std::span<const ProxyIndex> proxies, std::span<const Aabb> boxes) override {
        tracker_.move(proxies, boxes);
    }
    void remove(ProxyIndex proxy) override { tracker_.remove(proxy); }
    Aabb box(ProxyIndex proxy) const override { return tracker_.box(proxy); }
    std::size_t size() const noexcept override { return tracker_.size(); }

    void update() override {
        pairs_.begin_update();
        try {
            tracker_.update(pairs_);
        } catch (...) {
            pairs_.drop_update();
            throw;
        }
        pairs_.end_update();
    }

    const std::vector<ProxyPair>& pairs() override { return pairs_.sorted(); }
    const std::vector<ProxyPair>& began() const noexcept override { return tracker_.events().began; }
    const std::vector<ProxyPair>& ended() const noexcept override { return tracker_.events().ended; }

    std::vector<ProxyIndex> find(const Aabb& box) const override { return tracker_.find(box); }
    std::vector<ProxyIndex> find(const Segment& segment) const override { return tracker_.find(segment); }
    std::vector<ProxyIndex> find(const Ball& ball) const override { return tracker_.find(ball); }
    void visit_near(const Aabb& box, double limit, const std::function<double(ProxyIndex)>& visit) const override {
        tracker_.visit_near(box, limit, visit);
    }
    void visit_near_pairs(double limit, const std::function<double(ProxyPair)>& visit) const override {
        tracker_.visit_near_pairs(limit, visit);
    }
    void visit_along(const Segment& segment, const std::function<double(ProxyIndex)>& visit) const override {
        tracker_.visit_along(segment, visit);
    }
    void visit_along(const Ray& ray, const std::function<double(ProxyIndex)>& visit) const override {
        tracker_.visit_along(ray, visit);
    }
    void visit_along(const Aabb& box, const Vec3& motion, double limit,
                     const std::function<double(ProxyIndex)>& visit) const override {
        tracker_.visit_along(box, motion, limit, visit);
    }
    FindCounts find_counts() const noexcept override { return tracker_.find_counts(); }

    const BroadPhaseCounts& counts() const noexcept override { return tracker_.counts(); }
    std::size_t bytes() const noexcept override { return tracker_.bytes() + pairs_.bytes(); }

    void check_invariants() const override {
        tracker_.validate();
        PairList pairs = pairs_;
        validate_pairs(tracker_.table(), pairs.sorted(), began(), ended());
    }

  private:
    OverlapTracker tracker_;
    PairList pairs_{tracker_.events()};
};

}  // namespace

std::unique_ptr<BroadPhase> make_broad_phase(BroadPhaseKind kind) {
    return std::make_unique<ListingBroadPhase>(kind);
}

}  // namespace ecods
