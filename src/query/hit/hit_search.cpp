#include "query/hit/hit_search.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>

#include "base/double_key.hpp"
#include "base/next.hpp"
#include "query/hit/triangle_hits.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

using namespace exact;

namespace {

BodyRef body_of(const Posed<MeshShape>& body) {
    return {&body.what->mesh(), &MeshShapeAccess::tree(*body.what).extent, &body.pose};
}

HitKind kind_of(const LineHit& hit) noexcept {
    if (hit.is_along) return HitKind::along;
    if (hit.feature == Feature::Kind::vertex) return HitKind::vertex;
    if (hit.feature == Feature::Kind::edge) return HitKind::edge;
    return hit.facing < 0 ? HitKind::front : hit.facing > 0 ? HitKind::back : HitKind::face;
}

// Fills in what is not rounded.
Hit hit_of(const LineHit& hit, std::uint32_t triangle) noexcept {
    Hit result;
    result.kind = kind_of(hit);
    result.feature = {hit.feature, triangle, hit.corner};
    return result;
}

void round_into(Hit& hit, const Line& line, const FractionRef& enter, const FractionRef& leave) noexcept {
    hit.parameter = hit.leave_parameter = round_fraction(enter);
    hit.point = hit.leave_point = round_point_between(line.a, line.b, line.is_ray, enter);
    if (hit.kind != HitKind::along) return;
    hit.leave_parameter = round_fraction(leave);
    hit.leave_point = round_point_between(line.a, line.b, line.is_ray, leave);
}

}  // namespace

struct FirstHit::State {
    const Line& line;
    QueryMemory& memory;
    TriangleHits triangles{};
    LineHit best{}, other{};
    bool found = false;
    bool is_rounded = false;  // by whoever offered it
    KeyedHit least{};

    bool is_before_best(const Fraction& at, std::uint64_t key, std::uint32_t triangle) const noexcept {
        if (!found) return true;
        const int order = compare(at.ref(), best.enter.ref());
        return order != 0 ? order < 0 : std::tuple(key, triangle) < std::tuple(least.key, least.hit.feature.triangle);
    }
};

FirstHit::FirstHit(const Line& line, QueryMemory& memory) : state_(new State{line, memory}) {}
FirstHit::~FirstHit() = default;

void FirstHit::ask(const Posed<MeshShape>& body, std::uint64_t key, PairWitness& witness) {
    State& s = *state_;
    s.triangles.bind(s.line, body_of(body));
    for (std::uint32_t i = 0; i < body.what->mesh().triangles().size(); ++i) {
        if (!s.triangles.find(i, s.other) || !s.is_before_best(s.other.enter, key, i)) continue;
        s.best = s.other;
        s.least = {key, hit_of(s.best, i)};
        s.found = true;
        s.is_rounded = false;
        witness.b = i;
    }
}

void FirstHit::ask(const Posed<MeshShape>& body, std::uint64_t key) {
    PairWitness witness;
    ask(body, key, witness);
}

void FirstHit::offer(const Hit& hit, std::uint64_t key) {
    State& s = *state_;
    const Fraction at = fraction_of(hit.parameter);
    if (!s.is_before_best(at, key, hit.feature.triangle)) return;
    s.best.enter = at;
    s.least = {key, hit};
    s.found = true;
    s.is_rounded = true;
}

double FirstHit::limit() const noexcept {
    if (!state_->found) return state_->line.end;
    return next_up(round_fraction(state_->best.enter.ref()));
}

bool FirstHit::found() const noexcept {
    return state_->found;
}

KeyedHit FirstHit::get() const {
    const State& s = *state_;
    KeyedHit result = s.least;
    if (!s.is_rounded) round_into(result.hit, s.line, s.best.enter.ref(), s.best.leave.ref());
    result.hit.rank = 0;
    return result;
}

struct AllHits::State {
    // Where a parameter's limbs are.
    struct Place {
        std::size_t begin, num_size, den_size;
    };
    struct Item {
        KeyedHit hit;
        Place enter;
    };

    const Line& line;
    QueryMemory& memory;
    TriangleHits triangles{};
    std::vector<Item> items{};
    std::vector<std::uint64_t> limbs{};

    Place keep(const Fraction& x) {
        const NaturalSpan num = x.num.limbs(), den = x.den.limbs();
        const Place place{limbs.size(), num.size(), den.size()};
        limbs.insert(limbs.end(), num.begin(), num.end());
        limbs.insert(limbs.end(), den.begin(), den.end());
        return place;
    }
    FractionRef at(const Place& place) const noexcept {
        const NaturalSpan all = limbs;
        return {all.subspan(place.begin, place.num_size), all.subspan(place.begin + place.num_size, place.den_size)};
    }
};

AllHits::AllHits(const Line& line, QueryMemory& memory) : state_(new State{line, memory}) {}
AllHits::~AllHits() = default;

void AllHits::ask(const Posed<MeshShape>& body, std::uint64_t key) {
    State& s = *state_;
    s.triangles.bind(s.line, body_of(body));
    LineHit found;
    for (std::uint32_t i = 0; i < body.what->mesh().triangles().size(); ++i) {
        if (!s.triangles.find(i, found)) continue;
        KeyedHit keyed{key, hit_of(found, i)};
        round_into(keyed.hit, s.line, found.enter.ref(), found.leave.ref());
        const auto place = s.keep(found.enter);
        s.items.push_back({keyed, place});
    }
}

void AllHits::offer(const Hit& hit, std::uint64_t key) {
    const auto place = state_->keep(fraction_of(hit.parameter));
    state_->items.push_back({{key, hit}, place});
}

// Rounding is monotone: parameters that round to different doubles are in the order of these.
std::vector<KeyedHit> AllHits::get() {
    State& s = *state_;
    const auto order = [&](const State::Item& a, const State::Item& b) {
        const double x = a.hit.hit.parameter, y = b.hit.hit.parameter;
        if (key_of(x) != key_of(y)) return key_of(x) < key_of(y) ? -1 : 1;
        return compare(s.at(a.enter), s.at(b.enter));
    };
    std::ranges::sort(s.items, [&](const State::Item& a, const State::Item& b) {
        const int sign = order(a, b);
        return sign != 0 ? sign < 0
                         : std::tuple(a.hit.key, a.hit.hit.feature.triangle) <
                               std::tuple(b.hit.key, b.hit.hit.feature.triangle);
    });
    std::vector<KeyedHit> result;
    result.reserve(s.items.size());
    std::uint32_t rank = 0;
    for (std::size_t i = 0; i < s.items.size(); ++i) {
        if (i > 0 && order(s.items[i - 1], s.items[i]) != 0) ++rank;
        result.push_back(s.items[i].hit);
        result.back().hit.rank = rank;
    }
    return result;
}

}  // namespace ecods
