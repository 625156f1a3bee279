// Keeps boxes and reports the pairs whose overlap began or ended; also finds which boxes a box, a segment or a ball
// meets. An OverlapTracker is a broad phase without a list of pairs: its user keeps the pairs.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "bounds/moving_box.hpp"
#include "broad_phase/box_index.hpp"
#include "broad_phase/changes/pair_events.hpp"
#include "broad_phase/changes/pair_finder.hpp"
#include "broad_phase/changes/proxy_table.hpp"
#include "ecods/broad_phase.hpp"

namespace ecods {

// Functions without a comment promise what the functions of the same names promise in BroadPhase.
class OverlapTracker {
  public:
    explicit OverlapTracker(BroadPhaseKind kind);

    BroadPhaseKind kind() const noexcept { return kind_; }
    void reserve(std::size_t count);
    void add(ProxyIndex proxy, const Aabb& box) {
        table_.add(proxy, box);
        note(proxy);
    }
    void move(ProxyIndex proxy, const Aabb& box) {
        table_.move(proxy, box);
        note(proxy);
    }
    void move(std::span<const ProxyIndex> proxies, std::span<const Aabb> boxes) {
        table_.move(proxies, boxes);
        if (!index_) return;
        for (const ProxyIndex proxy : proxies) note(proxy);
    }
    void remove(ProxyIndex proxy) {
        table_.remove(proxy);
        note(proxy);
    }
    const Aabb& box(ProxyIndex proxy) const { return table_.box(proxy); }
    const ProxyTable& table() const noexcept { return table_; }
    std::size_t size() const noexcept { return table_.size(); }

    // Sets events() to the differences between the pairs that `keeper` has and the pairs that overlap now. If memory
    // runs out, events() is empty, and the next update reports all changes since the last update that succeeded.
    void update(PairKeeper& keeper);

    // Returns the pairs that began and the pairs that ended with the last update: two ascending lists without
    // duplicates.
    const PairEvents& events() const noexcept { return events_; }

    // Clears the events. Call only after the keeper of the pairs has read them.
    void clear_events() noexcept { events_.clear(); }

    std::vector<ProxyIndex> find(const Aabb& box) const;
    std::vector<ProxyIndex> find(const Segment& segment) const;
    std::vector<ProxyIndex> find(const Ball& ball) const;
    void visit_near(const Aabb& box, double limit, const std::function<double(ProxyIndex)>& visit) const;
    void visit_near_pairs(double limit, const std::function<double(ProxyPair)>& visit) const;
    void visit_along(const Segment& segment, const std::function<double(ProxyIndex)>& visit) const;
    void visit_along(const Ray& ray, const std::function<double(ProxyIndex)>& visit) const;
    void visit_along(const Aabb& box, const Vec3& motion, double limit,
                     const std::function<double(ProxyIndex)>& visit) const;

    // Appends to `found` the pairs that would overlap if each proxy in `chosen` had the box at the same place in
    // `boxes`, not its own. Only pairs with at least one chosen proxy are appended, each once, in no order. The chosen
    // proxies must be present, each listed once. Cost: building trees of the chosen boxes, and a query for each chosen
    // box, or for each other box if many are chosen.
    void find_pairs_with(std::span<const ProxyIndex> chosen, std::span<const Aabb> boxes, ProxyPairs& found) const;

    // Appends to `found` the pairs that find_pairs_with() appends, but only pairs of two chosen proxies.
    void find_pairs_among(std::span<const ProxyIndex> chosen, std::span<const Aabb> boxes, ProxyPairs& found) const;
    FindCounts find_counts() const noexcept;

    const BroadPhaseCounts& counts() const noexcept { return counts_; }
    std::size_t bytes() const noexcept;

    // Throws BrokenInvariant if the finder or the index does not fit the boxes. Does not check the pairs.
    void validate() const;

  private:
    bool has_trees() const noexcept;
    bool has_near_trees() const noexcept;
    void count_find(std::uint64_t tests) const noexcept;
    void note(ProxyIndex proxy) noexcept {
        if (!index_) return;
        index_->note(proxy);
        index_is_current_.store(false, std::memory_order_relaxed);
    }
    const BoxIndex& current_index() const;
    template <class Bounds>
    std::vector<ProxyIndex> find_all(const Bounds& bounds) const;
    void visit_along(const MovingBox& moving, double limit, const std::function<double(ProxyIndex)>& visit) const;

    void begin();
    void choose() noexcept;
    void build_finder() noexcept;

    BroadPhaseKind kind_;
    BroadPhaseKind running_;  // kind of finder in use; differs from kind_ only if kind_ is automatic
    ProxyTable table_;
    PairEvents events_;
    std::unique_ptr<PairFinder> finder_;  // null after a failure
    BroadPhaseCounts counts_;

    // Queries, which are const, build the index and bring it up to date while they hold the mutex. Only queries read
    // the index, and no non-const function runs at the same time as a query. So a query may read the index without the
    // mutex if index_is_current_ is set.
    mutable std::mutex index_mutex_;
    mutable std::unique_ptr<BoxIndex> index_;
    mutable std::atomic<bool> index_is_current_ = false;
    mutable std::atomic<std::uint64_t> find_calls_ = 0, find_tests_ = 0, find_refreshed_ = 0;
};

}  // namespace ecods
