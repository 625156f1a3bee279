#include "world/closeness.hpp"

#include "base/bytes_of.hpp"
#include "base/next.hpp"
#include "world/enlarged.hpp"

namespace ecods {
void Closeness::follow(const OverlapTracker& boxes, const Bodies& bodies, Changes& changes,
                       const PairVerdicts& collisions) {
    if (!wanted_) return;
    follow_boxes(boxes, bodies, changes);
    pairs_.follow(*tracker_, bodies, statistics_.visited_pairs);
    pairs_.collect(bodies, changes, !is_up_to_date(), statistics_.visited_pairs);
    take_collisions(collisions);
    test_count_ = 0;
    for (const VerdictIndex index : pairs_.tests()) test_count_ += pairs_.verdicts()[index].answer == Answer::none;
}

// Puts the enlarged box of each changed body into tracker_; if the clearance changed, the enlarged boxes of all bodies.
// A box is always overwritten, so an update that failed half-way need not be undone.
void Closeness::follow_boxes(const OverlapTracker& boxes, const Bodies& bodies, const Changes& changes) {
    if (!tracker_) tracker_.emplace(kind_);
    generations_.resize(bodies.end());
    const bool all_change = !is_same_clearance(reached_, wanted_);
    reached_.reset();
    if (all_change) {
        tracker_->reserve(bodies.end());
        for (ProxyIndex proxy = 0; proxy < bodies.end(); ++proxy) follow_box(proxy, boxes, bodies[proxy]);
    } else {
        for (const ProxyIndex proxy : changes.bodies()) {
            if (changes.of(proxy) == Change::body) follow_box(proxy, boxes, bodies[proxy]);
        }
    }
    reached_ = wanted_;
}

// Updates the enlarged box of one slot. If the slot now holds another body than at the last update, the old box is
// removed first: so the pairs of the old body end, even if the new box equals the old one.
void Closeness::follow_box(ProxyIndex proxy, const OverlapTracker& boxes, const Slot& slot) {
    bool is_here = tracker_->table().is_present(proxy);
    if (is_here && (!slot.is_alive() || generations_[proxy] != slot.generation)) {
        tracker_->remove(proxy);
        is_here = false;
    }
    if (!slot.is_alive()) return;
    const Aabb box = enlarged(boxes.box(proxy), *wanted_);
    is_here ? tracker_->move(proxy, box) : tracker_->add(proxy, box);
    generations_[proxy] = slot.generation;
}

// Sets the answer `yes` for each pair that this update has found to collide, so that the pair is not tested for
// closeness. A pair that collides and was not tested in this update keeps its cached verdict; but if the clearance has
// changed, it is tested again, at little cost because its witness is tried first.
void Closeness::take_collisions(const PairVerdicts& collisions) {
    for (const VerdictIndex index : collisions.tests()) {
        const Verdict& verdict = collisions.verdicts()[index];
        if (verdict.answer != Answer::yes) continue;
        const VerdictIndex own = pairs_.verdicts().find(verdict.proxies());
        if (own != no_verdict) pairs_.answer(own) = Answer::yes;
    }
}

void Closeness::prepare() {
    if (wanted_) pairs_.prepare();
}

void Closeness::commit() noexcept {
    if (wanted_) {
        const std::size_t answered = pairs_.commit();
        statistics_.two_body_tests += test_count_;
        statistics_.cache_hits += pairs_.verdicts().enabled_count() - answered;
    } else {
        pairs_.end_all();
        tracker_.reset();
        reached_.reset();
    }
    listed_ = wanted_;
}

void Closeness::idle() noexcept {
    pairs_.clear_events();
    statistics_.cache_hits += pairs_.verdicts().enabled_count();
}

ClearanceStatistics Closeness::statistics() const {
    ClearanceStatistics statistics = statistics_;
    if (tracker_) statistics.broad_phase = tracker_->counts();
    statistics.candidate_count = pairs_.verdicts().enabled_count();
    statistics.filtered_count = pairs_.verdicts().size() - statistics.candidate_count;
    statistics.close_count = pairs_.positive().size();
    return statistics;
}

std::size_t Closeness::memory_bytes() const noexcept {
    return pairs_.memory_bytes() + bytes_of(generations_);
}

// Throws BrokenInvariant if the enlarged box `reaching` does not reach half the clearance beyond `box`. Each end may
// fall short by two doubles, because the box may have been enlarged in another rounding mode.
void Closeness::validate_box(const Aabb& box, const Aabb& reaching) const {
    const Aabb expected = enlarged(box, *listed_);
    for (int axis = 0; axis < 3; ++axis) {
        if (reaching.min[axis] <= next_up(next_up(expected.min[axis])) &&
            reaching.max[axis] >= next_down(next_down(expected.max[axis]))) {
            continue;
        }
        throw BrokenInvariant("a box does not reach half the clearance further than its body's");
    }
}

void Closeness::validate(const Bodies& bodies, const OverlapTracker& boxes) const {
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw BrokenInvariant(what);
    };
    pairs_.validate();
    require(tracker_.has_value() == listed_.has_value(), "there is a broad phase of near pairs without a clearance");
    if (!tracker_) return;
    tracker_->validate();
    require(tracker_->size() == bodies.alive_count(), "the broad phase of near pairs has another number of bodies");
    for (ProxyIndex proxy = 0; proxy < bodies.end(); ++proxy) {
        if (!bodies[proxy].is_alive()) continue;
        validate_box(boxes.box(proxy), tracker_->box(proxy));
        require(generations_[proxy] == bodies[proxy].generation, "the box that reaches further is of another body");
    }
}

}  // namespace ecods
