// close_features() finds the pairs of features within a distance d from the pairs of triangles within d.
//
// The distance of two triangles is at most the distance of any two of their features. So if two features are within d,
// every pair of triangles that has these features is within d, too, and is found. Hence the triangles found include all
// triangles that can name one of these features, and the rest of the mesh need not be read.
#include <algorithm>
#include <cstdint>

#include "base/limits.hpp"
#include "geometry/feature_key.hpp"
#include "query/distance/distance_search.hpp"
#include "query/distance/least_names.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/asking.hpp"

namespace ecods {
namespace {

Feature feature_on(const Mesh& mesh, std::uint32_t triangle, const FeatureKey& key) {
    return feature_of(key, triangle, mesh.triangles()[triangle]);
}

std::vector<FeatureNames> find_features(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d,
                                        DistanceSearch& search) {
    std::vector<FeatureNames> result;
    search.visit_within(d, [&](const TrianglePair& pair, const DistanceInterval& interval) {
        if (interval.is_certain) {
            result.push_back({interval.kind, feature_on(a.what->mesh(), pair.a, interval.a),
                              feature_on(b.what->mesh(), pair.b, interval.b)});
        } else {
            search.exact_pair().add_features(pair.a, pair.b, result);
        }
    });
    return result;
}

LeastNames least_names(const Mesh& mesh, const std::vector<FeatureNames>& found, Feature FeatureNames::*side) {
    std::vector<std::uint32_t> triangles;
    triangles.reserve(found.size());
    for (const FeatureNames& features : found) triangles.push_back((features.*side).triangle);
    return {mesh, std::move(triangles)};
}

}  // namespace

std::vector<CloseFeatures> surface::close_features(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                   double max_distance, const Ask& ask) {
    require_finite_distance(max_distance);
    Asking asking(ask);
    DistanceSearch search(a, b, asking.memory());
    std::vector<FeatureNames> found = find_features(a, b, max_distance, search);
    const LeastNames names_a = least_names(a.what->mesh(), found, &FeatureNames::a);
    const LeastNames names_b = least_names(b.what->mesh(), found, &FeatureNames::b);
    for (FeatureNames& features : found) {
        features.a = names_a(features.a);
        features.b = names_b(features.b);
    }
    std::ranges::sort(found, {}, rank<FeatureNames>);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<CloseFeatures> result;
    result.reserve(found.size());
    for (const FeatureNames& features : found) result.push_back(search.exact_pair().measure(features));
    return result;
}

}  // namespace ecods
