// Finds which boxes a box, a segment or a ball meets.
#include <algorithm>

#include "bounds/ball_bounds.hpp"
#include "bounds/segment_bounds.hpp"
#include "broad_phase/overlap_tracker.hpp"
#include "geometry/find_invalid.hpp"
#include "geometry/key_box.hpp"

namespace ecods {
namespace {

// Holds the box of a query and tests other boxes against it, with the interface of SegmentBounds and BallBounds.
class BoxBounds {
  public:
    explicit BoxBounds(const Aabb& box) : keys_(key_box(box)) { make_reach(packed_box(keys_), reach_); }

    const BoxReach& reach() const noexcept { return reach_; }
    bool meets(const Aabb& box) const noexcept { return overlap(keys_, key_box(box)); }

  private:
    KeyBox keys_;
    BoxReach reach_;
};

const BoxReach& for_trees(const BoxBounds& bounds) {
    return bounds.reach();
}
template <class Bounds>
const Bounds& for_trees(const Bounds& bounds) {
    return bounds;
}

// Up to this number of boxes, testing each box costs no more than searching trees.
constexpr std::size_t scanned_max = 64;

}  // namespace

bool OverlapTracker::has_trees() const noexcept {
    return (kind_ == BroadPhaseKind::kept_candidates || kind_ == BroadPhaseKind::automatic) &&
           table_.size() > scanned_max;
}

// Returns true if queries about near boxes use trees. More kinds use trees here than in has_trees(): without trees, a
// query for near boxes costs more than find(), and a query for near pairs far more.
bool OverlapTracker::has_near_trees() const noexcept {
    return kind_ != BroadPhaseKind::brute_force && table_.size() > scanned_max;
}

const BoxIndex& OverlapTracker::current_index() const {
    if (index_is_current_.load(std::memory_order_acquire)) return *index_;
    const std::lock_guard lock(index_mutex_);
    if (!index_is_current_.load(std::memory_order_relaxed)) {
        if (!index_) index_ = std::make_unique<BoxIndex>();
        find_refreshed_.fetch_add(index_->refresh(table_), std::memory_order_relaxed);
        index_is_current_.store(true, std::memory_order_release);
    }
    return *index_;
}

template <class Bounds>
std::vector<ProxyIndex> OverlapTracker::find_all(const Bounds& bounds) const {
    std::vector<ProxyIndex> found;
    std::uint64_t tests = 0;
    if (has_trees()) {
        tests = current_index().find(for_trees(bounds), found) + found.size();
        std::erase_if(found, [&](ProxyIndex proxy) { return !bounds.meets(table_.boxes()[proxy]); });
        std::sort(found.begin(), found.end());
    } else {
        tests = table_.size();
        for (ProxyIndex proxy = 0; proxy < table_.end(); ++proxy) {
            if (table_.is_present(proxy) && bounds.meets(table_.boxes()[proxy])) found.push_back(proxy);
        }
    }
    count_find(tests);
    return found;
}

void OverlapTracker::count_find(std::uint64_t tests) const noexcept {
    find_calls_.fetch_add(1, std::memory_order_relaxed);
    find_tests_.fetch_add(tests, std::memory_order_relaxed);
}

std::vector<ProxyIndex> OverlapTracker::find(const Aabb& box) const {
    ecods::validate(box);
    return find_all(BoxBounds(box));
}

std::vector<ProxyIndex> OverlapTracker::find(const Segment& segment) const {
    ecods::validate(segment);
    return find_all(SegmentBounds(segment));
}

std::vector<ProxyIndex> OverlapTracker::find(const Ball& ball) const {
    ecods::validate(ball);
    return find_all(BallBounds(ball));
}

FindCounts OverlapTracker::find_counts() const noexcept {
    return {.calls = find_calls_.load(std::memory_order_relaxed),
            .box_tests = find_tests_.load(std::memory_order_relaxed),
            .refreshed = find_refreshed_.load(std::memory_order_relaxed)};
}

}  // namespace ecods
