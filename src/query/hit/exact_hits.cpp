#include "query/hit/exact_hits.hpp"

#include <algorithm>

#include "base/double_key.hpp"
#include "query/hit/hit_collector.hpp"

namespace ecods {
namespace {

LongFraction long_fraction(const exact::Fraction& x) {
    return {{x.num.limbs(), false}, {x.den.limbs(), false}};
}

// Returns the order of the real parameters of hits x and y. Compares rounded parameters first: rounding is monotone, so
// if the rounded parameters differ, the real ones have the same order.
int compare_enter(const ExactHit& x, const ExactHit& y) {
    const std::int64_t a = key_of(x.hit.parameter), b = key_of(y.hit.parameter);
    return a != b ? (a < b ? -1 : 1) : compare(x.enter, y.enter);
}

}  // namespace

std::vector<ExactHit> exact_hits(const Line& line, const Posed<MeshShape>& body, QueryMemory& memory) {
    std::vector<ExactHit> hits;
    const ScaledLine scaled(line);
    collect_hits(line, scaled, body, HitMemory::of(memory), QueryMemoryAccess::state(memory).counts,
                 [&](std::uint32_t triangle, const exact::LineHit& hit) {
                     hits.push_back({rounded(line, hit, triangle), long_fraction(hit.enter),
                                     long_fraction(hit.is_along ? hit.leave : hit.enter)});
                 });
    std::ranges::sort(hits, [](const ExactHit& x, const ExactHit& y) {
        const int order = compare_enter(x, y);
        return order != 0 ? order < 0 : x.hit.triangle() < y.hit.triangle();
    });
    std::uint32_t rank = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (i > 0 && compare_enter(hits[i - 1], hits[i]) != 0) ++rank;
        hits[i].hit.rank = rank;
    }
    return hits;
}

}  // namespace ecods
