#include "ecods/ask.hpp"

#include <memory>
#include <utility>
#include <vector>

#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {

QueryMemory::QueryMemory() : state_(std::make_unique<State>()) {}
QueryMemory::~QueryMemory() = default;
QueryMemory::QueryMemory(QueryMemory&&) noexcept = default;
QueryMemory& QueryMemory::operator=(QueryMemory&&) noexcept = default;

const QueryCounts& QueryMemory::counts() const noexcept {
    return state_->counts;
}
void QueryMemory::reset_counts() noexcept {
    state_->counts = {};
}

// ---- counts

namespace {

struct Plus {
    void operator()(std::uint64_t& to, std::uint64_t by) const noexcept { to += by; }
};
struct Minus {
    void operator()(std::uint64_t& to, std::uint64_t by) const noexcept { to -= by; }
};

// Applies `op` (Plus or Minus) to each count of `to`, with the same count of `by`.
template <class Change>
void change(StageCounts& to, const StageCounts& by, Change op) noexcept {
    op(to.triangle_tests, by.triangle_tests);
    for (const Stage& stage : stages) op(to.*stage.count, by.*stage.count);
}
template <class Change>
void change(DistanceCounts& to, const DistanceCounts& by, Change op) noexcept {
    op(to.triangle_bounds, by.triangle_bounds);
    op(to.enclosures, by.enclosures);
    op(to.exact, by.exact);
}
template <class Change>
void change(HitCounts& to, const HitCounts& by, Change op) noexcept {
    op(to.triangle_tests, by.triangle_tests);
    op(to.enclosures, by.enclosures);
    op(to.exact, by.exact);
}
template <class Change>
void change(CastCounts& to, const CastCounts& by, Change op) noexcept {
    op(to.enclosures, by.enclosures);
    op(to.exact, by.exact);
}
template <class Change>
void change(QueryCounts& to, const QueryCounts& by, Change op) noexcept {
    op(to.queries, by.queries);
    op(to.witness_hits, by.witness_hits);
    op(to.box_tests, by.box_tests);
    change(to.stages, by.stages, op);
    change(to.distances, by.distances, op);
    change(to.hits, by.hits, op);
    change(to.casts, by.casts, op);
}

template <class Counts>
Counts& add(Counts& to, const Counts& by) noexcept {
    change(to, by, Plus());
    return to;
}

}  // namespace

StageCounts& StageCounts::operator+=(const StageCounts& other) noexcept {
    return add(*this, other);
}
DistanceCounts& DistanceCounts::operator+=(const DistanceCounts& other) noexcept {
    return add(*this, other);
}
HitCounts& HitCounts::operator+=(const HitCounts& other) noexcept {
    return add(*this, other);
}
CastCounts& CastCounts::operator+=(const CastCounts& other) noexcept {
    return add(*this, other);
}
QueryCounts& QueryCounts::operator+=(const QueryCounts& other) noexcept {
    return add(*this, other);
}

// ---- questions under way

namespace {

// SpareMemories holds the memories of a thread that no query is using. There may be several, because a caller's test
// may start a query within another one, which needs a memory of its own.
struct SpareMemories {
    std::vector<std::unique_ptr<QueryMemory>> list;
    std::size_t made_count = 0;

    ~SpareMemories();
};

// are_spares_gone is set when the thread's `spares` are destroyed: destructors of other objects may still start queries
// later.
thread_local bool are_spares_gone = false;
thread_local SpareMemories spares;

SpareMemories::~SpareMemories() {
    are_spares_gone = true;
}

}  // namespace

OwnMemory::OwnMemory() {
    if (are_spares_gone) {
        memory_ = std::make_unique<QueryMemory>();
    } else if (spares.list.empty()) {
        memory_ = std::make_unique<QueryMemory>();
        spares.list.reserve(spares.made_count + 1);  // so that the destructor, which gives the memory back, cannot fail
        ++spares.made_count;
    } else {
        memory_ = std::move(spares.list.back());
        spares.list.pop_back();
    }
}

OwnMemory::~OwnMemory() {
    if (!are_spares_gone && spares.list.size() < spares.made_count) spares.list.push_back(std::move(memory_));
}

void Asking::add_counts() noexcept {
    QueryCounts work = memory().counts();
    change(work, *before_, Minus());
    *ask_.counts += work;
}

}  // namespace ecods
