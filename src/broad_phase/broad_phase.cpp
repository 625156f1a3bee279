#include "ecods/broad_phase.hpp"

#include "broad_phase/changes/pair_list.hpp"
#include "broad_phase/overlap_tracker.hpp"
#include "broad_phase/validate_pairs.hpp"

namespace ecods {
namespace {

// For those who use a broad phase alone: the tracker, and a list of the pairs.
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

    void validate() const override {
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
