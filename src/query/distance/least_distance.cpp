#include "query/distance/least_distance.hpp"

#include <algorithm>
#include <tuple>

#include "base/assert.hpp"
#include "base/double_key.hpp"

namespace ecods {
namespace {

auto features_of(const OpenPair& open) {
    const DistanceInterval& i = open.interval;
    return std::tuple(i.kind, i.a, i.b);
}

bool have_same_distance(const OpenPair& x, const OpenPair& y) {
    return x.triangles == y.triangles ||
           (x.interval.is_certain && y.interval.is_certain && features_of(x) == features_of(y));
}

}  // namespace

std::vector<OpenPair>& group_by_features(std::vector<OpenPair>& open) {
    if (open.size() < 2) return open;
    std::ranges::sort(open, [](const OpenPair& x, const OpenPair& y) {
        if (x.interval.is_certain != y.interval.is_certain) return x.interval.is_certain;
        if (x.interval.is_certain && features_of(x) != features_of(y)) return features_of(x) < features_of(y);
        return x.triangles < y.triangles;
    });
    open.erase(std::unique(open.begin(), open.end(), have_same_distance), open.end());
    std::ranges::sort(open, {}, [](const OpenPair& x) { return key_of(x.interval.upper); });
    return open;
}

double round_least(DistanceSearch& search, PairWitness& nearest) {
    const std::vector<OpenPair>& open = group_by_features(search.open_pairs());
    ECODS_ASSERT(!open.empty());
    double least = std::numeric_limits<double>::infinity();
    for (const OpenPair& pair : open) {
        // Rounding is monotone: it takes no number below one that is a double.
        if (key_of(pair.interval.lower) >= key_of(least)) continue;
        const double d = search.exact_pair().distance(pair.triangles.a, pair.triangles.b);
        if (key_of(d) >= key_of(least) && &pair != &open.front()) continue;
        least = d;
        nearest = {pair.triangles.a, pair.triangles.b};
    }
    return least;
}

bool is_least_within(DistanceSearch& search, double d, PairWitness& nearest) {
    for (const OpenPair& pair : group_by_features(search.open_pairs())) {
        if (key_of(pair.interval.lower) > key_of(d)) continue;
        if (key_of(pair.interval.upper) <= key_of(d) ||
            search.exact_pair().compare(pair.triangles.a, pair.triangles.b, d) <= 0) {
            nearest = {pair.triangles.a, pair.triangles.b};
            return true;
        }
    }
    return false;
}

std::vector<OpenPair>& find_least(DistanceSearch& search) {
    std::vector<OpenPair>& open = group_by_features(search.open_pairs());
    ECODS_ASSERT(!open.empty());
    // Those that may be the least are moved to the front, over those that have been judged.
    std::size_t count = 1;
    for (std::size_t at = 1; at < open.size(); ++at) {
        const OpenPair pair = open[at];
        if (key_of(pair.interval.lower) > key_of(open[0].interval.upper)) continue;
        const int sign = key_of(pair.interval.upper) < key_of(open[0].interval.lower)
                             ? -1
                             : search.exact_pair().compare(pair.triangles, open[0].triangles);
        if (sign < 0) count = 0;
        if (sign <= 0) open[count++] = pair;
    }
    open.resize(count);
    return open;
}

}  // namespace ecods
