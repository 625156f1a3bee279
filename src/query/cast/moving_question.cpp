#include "query/cast/moving_question.hpp"

#include <algorithm>
#include <limits>

#include "base/double_key.hpp"
#include "base/next.hpp"
#include "base/outward.hpp"
#include "exact/measure/distance/name_features.hpp"

namespace ecods {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Returns a node with a single child box, the root's.
BvhNode root_of(const MeshBvh& tree) {
    BvhNode node{};
    for (std::size_t k = 0; k < 3; ++k) {
        node.center[k].fill(tree.root_center[k]);
        node.half[k].fill(tree.root_half[k]);
    }
    node.count = 1;
    return node;
}

}  // namespace

void MovingQuestion::bind_boxes(const Moving<MeshShape>& a, const Moving<MeshShape>& b) {
    trees_ = {&MeshShapeAccess::tree(*a.what).boxes, &MeshShapeAccess::tree(*b.what).boxes};
    axes_.bind({*trees_[0], a.from.R, a.to.R}, {*trees_[1], b.from.R, b.to.R}, b.from.t - a.from.t, b.to.t - a.to.t);
}

std::optional<float> MovingQuestion::first_of_boxes() {
    alignas(32) LaneBounds times;
    if (meeting_mask(axes_.sets(), 1, root_of(*trees_[0]), root_of(*trees_[1]), times) == 0) return std::nullopt;
    return times[0];
}

void MovingQuestion::bind_pairs(const Moving<MeshShape>& a, const Moving<MeshShape>& b, double at_most,
                                CastCounts& counts) {
    pairs_.bind(a, b, counts);
    waiting_.clear();
    order_ = 0;
    at_most_ = at_most;
    is_by_then_ = false;
}

float MovingQuestion::limit_above(double time) const noexcept {
    return round_up(time);
}

// Returns true if the triangles may share a point from `from` to `latest`; then sets span_ to an interval that contains
// the first such time. Searches up to the double above `latest`, because a time above `latest` may round to it.
bool MovingQuestion::narrow(const TrianglePair& triangles, double from, double latest, exact::Effort effort) {
    to_ = std::min(next_up(latest), 1.0);
    if (key_of(from) > key_of(to_)) return false;
    const auto span = pairs_.bound(triangles, from, to_, effort);
    if (!span || key_of(span->from) > key_of(latest)) return false;
    span_ = *span;
    return true;
}

ContactInterval MovingQuestion::enclose(const TrianglePair& triangles, double latest) {
    ContactInterval interval;
    interval.lower = narrow(triangles, 0, latest, exact::Effort::fine) ? span_.from : infinity;
    return interval;
}

bool MovingQuestion::complete(const TrianglePair& triangles, ContactInterval& interval,
                              std::optional<FirstContact>& contact) {
    const auto meeting = pairs_.decide(triangles, span_, to_);
    if (!meeting || key_of(meeting->time) > key_of(at_most_)) return false;
    is_by_then_ = is_by_then_ || !meeting->is_late || key_of(meeting->time) < key_of(at_most_);
    contact.emplace();
    contact->time = interval.lower = interval.upper = meeting->time;
    exact::name_features(*contact, meeting->features, triangles);
    return true;
}

void MovingQuestion::wait(double time, Candidate::Known known, const TrianglePair& triangles) {
    waiting_.push({key_of(time), order_++, known, triangles});
}

void MovingQuestion::gather(Search&, const TreeLeaf& x, const TreeLeaf& y, LanePairs lanes, const LaneBounds& times) {
    for (; lanes.more(); lanes.next()) {
        const std::size_t i = lanes.i(), j = lanes.j();
        wait(static_cast<double>(times[tree_width * i + j]), Candidate::Known::boxes, {x.triangle[i], y.triangle[j]});
    }
}

void MovingQuestion::advance(Search& search, float time) {
    while (!waiting_.is_empty() && waiting_.front().time <= key_of(static_cast<double>(time))) {
        const Candidate next = waiting_.pop();
        if (!search.sieve().counts(double_of(next.time))) return waiting_.clear();  // all others are later
        refine(search, next, time);
    }
}

// Refines the bound of the candidate. Then gives it to the search, which decides it exactly, unless a waiting candidate
// or a node (these begin at time `next`) may be earlier. In that case puts it back into the queue.
void MovingQuestion::refine(Search& search, const Candidate& candidate, float next) {
    using Known = Candidate::Known;
    const double latest = search.sieve().bound();
    double from = double_of(candidate.time);
    const auto is_after_others = [&] {
        const std::int64_t time = key_of(span_.from);
        return time > key_of(static_cast<double>(next)) || (!waiting_.is_empty() && time > waiting_.front().time);
    };
    if (candidate.known == Known::boxes) {
        if (!narrow(candidate.triangles, from, latest, exact::Effort::coarse)) return;
        if (is_after_others()) return wait(span_.from, Known::coarse, candidate.triangles);
        from = span_.from;
    }
    if (!narrow(candidate.triangles, from, latest, exact::Effort::fine)) return;
    if (candidate.known != Known::fine && is_after_others()) return wait(span_.from, Known::fine, candidate.triangles);
    ContactInterval interval;
    interval.lower = span_.from;
    search.take(candidate.triangles, interval);
}

}  // namespace ecods
