#include <algorithm>
#include <bit>
#include <tuple>

#include "base/double_key.hpp"
#include "query/hit/hit_memory.hpp"
#include "query/hit/hit_search.hpp"

namespace ecods {

struct AllHits::State {
    // Holds a hit, its place among those of its body with the same parameter, and where `limbs` has its exact
    // parameter: from `begin` on, the numerator and then the denominator.
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
    // if these differ, the real parameters have the same order.
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

// Collects the hits of all triangles that the line hits; its limit leaves out no part of the line.
class AllHits::Collector {
  public:
    Collector(State& state, const Mesh& mesh, std::uint64_t key) : state_(state), mesh_(mesh), key_(key) {}

    float limit() const noexcept { return 1; }
    void visit_node() noexcept { ++state_.counts.box_tests; }
    void visit(const TreeLeaf& leaf, const FoundInLeaf& found) {
        state_.counts.hits.triangle_tests += leaf.count;
        for (std::uint32_t lanes = found.may_meet; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            visit(leaf.triangle[lane], leaf.vertices[lane]);
        }
    }
    void visit(std::uint32_t triangle) { visit(triangle, mesh_.triangles()[triangle]); }
    void visit(std::uint32_t triangle, const Triangle& vertices) {
        HitCounts& counts = state_.counts.hits;
        HitMemory& memory = state_.memory;
        ++counts.enclosures;
        const HitEnclosure enclosure = memory.triangles.enclose(vertices);
        if (enclosure.verdict == HitEnclosure::Verdict::none) return;
        ++counts.exact;
        if (enclosure.verdict == HitEnclosure::Verdict::face) {
            memory.triangles.find_crossing(vertices, *memory.other);
        } else if (!memory.triangles.find(vertices, *memory.other)) {
            return;
        }
        state_.add({key_, rounded(state_.line, *memory.other, triangle)}, triangle, memory.other->enter);
    }

  private:
    State& state_;
    const Mesh& mesh_;
    std::uint64_t key_;
};

void AllHits::ask(const Posed<MeshShape>& body, std::uint64_t key) {
    State& s = *state_;
    ++s.counts.queries;
    const LineAxes::Place place = s.memory.bind(s.line, s.scaled, s.scaled.end_high, body);
    Collector collector(s, body.what->mesh(), key);
    s.memory.walk(body, place, collector);
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
