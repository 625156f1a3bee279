#include <algorithm>
#include <tuple>

#include "base/double_key.hpp"
#include "query/hit/hit_collector.hpp"
#include "query/hit/hit_search.hpp"

namespace ecods {

struct AllHits::State {
    // An Item is a hit, the hit's rank among the hits of the same body with the same parameter, and the position of the
    // exact parameter in `limbs`: from `begin` on, the numerator and then the denominator.
    struct Item {
        KeyedHit hit;
        std::size_t place;
        std::size_t begin, num_size, den_size;
    };

    State(const Line& of, QueryMemory& query_memory)
        : line(of),
          scaled(of),
          memory(HitMemory::of(query_memory)),
          counts(QueryMemoryAccess::state(query_memory).counts) {}

    void add(const KeyedHit& hit, std::size_t place, const exact::Fraction& at) {
        const exact::NaturalSpan num = at.num.limbs(), den = at.den.limbs();
        const std::size_t begin = limbs.size();
        limbs.insert(limbs.end(), num.begin(), num.end());
        limbs.insert(limbs.end(), den.begin(), den.end());
        items.push_back({hit, place, begin, num.size(), den.size()});
    }
    exact::FractionRef parameter(const Item& item) const noexcept {
        const exact::NaturalSpan all = limbs;
        return {all.subspan(item.begin, item.num_size), all.subspan(item.begin + item.num_size, item.den_size)};
    }
    // Returns the order of the real parameters of a and b. Compares rounded parameters first: rounding is monotone, so
    // if the rounded parameters differ, the real parameters have the same order.
    int compare(const Item& a, const Item& b) const noexcept {
        const std::int64_t x = key_of(a.hit.hit.parameter), y = key_of(b.hit.hit.parameter);
        if (x != y) return x < y ? -1 : 1;
        return exact::compare(parameter(a), parameter(b));
    }

    const Line& line;
    ScaledLine scaled;
    HitMemory& memory;
    QueryCounts& counts;
    std::vector<Item> items;
    std::vector<std::uint64_t> limbs;
};

AllHits::AllHits(const Line& line, QueryMemory& memory) : state_(std::make_unique<State>(line, memory)) {}
AllHits::~AllHits() = default;

void AllHits::ask(const Posed<MeshShape>& body, std::uint64_t key) {
    State& s = *state_;
    collect_hits(s.line, s.scaled, body, s.memory, s.counts, [&](std::uint32_t triangle, const exact::LineHit& hit) {
        s.add({key, rounded(s.line, hit, triangle)}, triangle, hit.enter);
    });
}

void AllHits::offer(const Hit& hit, std::uint64_t key) {
    state_->add({key, hit}, state_->items.size(), exact::fraction_of(hit.parameter));
}

std::vector<KeyedHit> AllHits::get() {
    State& s = *state_;
    const auto name = [](const State::Item& item) { return std::tuple(item.hit.key, item.place); };
    std::ranges::sort(s.items, [&](const State::Item& a, const State::Item& b) {
        const int order = s.compare(a, b);
        return order != 0 ? order < 0 : name(a) < name(b);
    });
    std::vector<KeyedHit> result;
    result.reserve(s.items.size());
    std::uint32_t rank = 0;
    for (std::size_t i = 0; i < s.items.size(); ++i) {
        if (i > 0 && s.compare(s.items[i - 1], s.items[i]) != 0) ++rank;
        result.push_back(s.items[i].hit);
        result.back().hit.rank = rank;
    }
    return result;
}

}  // namespace ecods
