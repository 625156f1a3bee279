// usage: digest_main CORPUS     prints a digest of the answers on the corpus, for each rounding mode with and without
//                               flush-to-zero
//
// Built by verify/environment/check in many ways, from the sources of the exact layer, without any other library.

#include <array>
#include <bit>
#include <cfenv>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "base/hash.hpp"
#include "ecods/mesh.hpp"
#include "ecods/predicates.hpp"
#include "environment/corpus.hpp"
#include "query/distance/triangle_distances.hpp"
#include "query/intersection/triangle_relations.hpp"

namespace {

using namespace ecods;

struct Body {
    Pose pose;
    std::array<Vec3, 3> corners;
    std::shared_ptr<const Mesh> mesh;
};

Body read_body(const double* in) {
    Body body;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) body.pose.R(row, column) = *in++;
    }
    for (int row = 0; row < 3; ++row) body.pose.t[row] = *in++;
    for (Vec3& v : body.corners) {
        for (int k = 0; k < 3; ++k) v[k] = *in++;
    }
    body.mesh = Mesh::create({body.corners.begin(), body.corners.end()}, {{0, 1, 2}});
    return body;
}

// Distance, features and points, and comparisons next to where they turn; all features that are closest, with their
// directions, and what the triangles share.
std::uint64_t digest(std::uint64_t result, TriangleDistances& distances) {
    const auto add = [&](auto number) { result = combine(result, std::bit_cast<std::uint64_t>(number)); };
    const auto add_point = [&](const Vec3& p) {
        for (int k = 0; k < 3; ++k) add(p[k]);
    };
    const auto add_closest = [&](const ClosestPoints& closest) {
        add(closest.distance);
        for (const Feature& feature : {closest.a, closest.b}) {
            add(std::uint64_t{feature.corner} << 8 | static_cast<std::uint64_t>(feature.kind));
        }
        add_point(closest.point_a);
        add_point(closest.point_b);
        add(static_cast<std::uint64_t>(closest.kind));
    };
    const ClosestPoints closest = distances.closest(0, 0);
    add(distances.distance(0, 0));
    add_closest(closest);
    add(std::uint64_t{distances.compare(0, 0, closest.distance) > 0});
    add(std::uint64_t{distances.compare(0, 0, closest.distance) < 0});
    std::vector<FeatureNames> names;
    distances.add_features(0, 0, names);
    for (const FeatureNames& features : names) {
        const CloseFeatures close = distances.measure(features);
        add_closest(close.closest);
        if (close.direction) add_point(*close.direction);
    }
    const SharedSet shared = distances.intersection(0, 0);
    for (const Vec3& corner : shared.corners()) add_point(corner);
    if (shared.normal) add_point(*shared.normal);
    return result;
}

std::uint64_t digest(const std::vector<std::array<Body, 2>>& pairs) {
    std::uint64_t result = 0;
    TriangleRelations bodies;
    TriangleDistances distances;
    std::size_t count = 0;
    for (const auto& [a, b] : pairs) {
        const exact::MeshExtent extent_a = exact::measure(*a.mesh), extent_b = exact::measure(*b.mesh);
        const exact::BodyRef first{a.mesh.get(), &extent_a, &a.pose}, second{b.mesh.get(), &extent_b, &b.pose};
        bodies.bind(first, second);
        distances.bind(first, second);
        const auto add = [&](auto answer) { result = combine(result, static_cast<std::uint64_t>(answer) & 0xff); };
        add(bodies.relation(0, 0));
        add(triangle_triangle({a.pose, a.corners}, {b.pose, b.corners}));
        add(triangle_triangle(a.corners, b.corners));
        add(orient3d(a.corners[0], a.corners[1], b.corners[0], b.corners[1]));
        const PosedPoint p{a.pose, a.corners[0]}, q{a.pose, a.corners[1]}, r{b.pose, b.corners[0]},
            s{b.pose, b.corners[2]};
        add(orient3d(p, q, r, s));
        for (int axis = 0; axis < 3; ++axis) add(orient2d(p, q, r, axis));
        // Of every fourth pair: without optimisation these take ten times as long as all the rest.
        if (count++ % 4 == 0) result = digest(result, distances);
    }
    return result;
}

void print_digests(const std::vector<std::array<Body, 2>>& pairs) {
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        for (const bool flush : {false, true}) {
#if defined(__SSE2__)
            const unsigned saved = _mm_getcsr();
            if (flush) _mm_setcsr(saved | 0x8040);  // flush-to-zero and denormals-are-zero
#else
            if (flush) continue;
#endif
            std::fesetround(mode);
            const std::uint64_t result = digest(pairs);
            std::fesetround(FE_TONEAREST);
#if defined(__SSE2__)
            _mm_setcsr(saved);
#endif
            std::printf("%016llx\n", static_cast<unsigned long long>(result));
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::ifstream file(argc == 2 ? argv[1] : "", std::ios::binary);
    std::vector<std::array<Body, 2>> pairs;
    environment::PairRecord record;
    while (file.read(reinterpret_cast<char*>(record.data()), sizeof record)) {
        pairs.push_back({read_body(record.data()), read_body(record.data() + environment::doubles_per_body)});
    }
    if (pairs.empty()) {
        std::fputs("usage: digest_main CORPUS\n", stderr);
        return 2;
    }
    print_digests(pairs);
}
