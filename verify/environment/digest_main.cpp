// usage: digest_main CORPUS [N]     prints a digest of the answers on the corpus, or on every Nth record of it, for
// each
//                                   rounding mode with and without flush-to-zero
//
// Built in many ways (digest.cmake), each from the sources of the exact layer, without any other library.

#include <array>
#include <bit>
#include <cfenv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "base/hash.hpp"
#include "ecods/mesh.hpp"
#include "ecods/primitives.hpp"
#include "environment/corpus.hpp"
#include "environment/digest_ways.hpp"
#include "environment/float_mode.hpp"
#include "query/distance/triangle_distances.hpp"
#include "query/intersection/triangle_relations.hpp"

namespace {

using namespace ecods;
using environment::Asked;

struct Body {
    Pose pose, to;
    std::array<Vec3, 3> corners;
    std::shared_ptr<const Mesh> mesh;
};

struct Case {
    Asked asked;
    Body a, b;
    Vec3 first, second;
    double limit;
};

class Reader {
  public:
    explicit Reader(const environment::Record& record) : in_(record.data()) {}

    Case read() {
        Case read;
        read.asked = static_cast<Asked>(*in_++);
        read.a = body();
        read.b = body();
        read.first = vector();
        read.second = vector();
        read.limit = *in_++;
        return read;
    }

  private:
    Vec3 vector() {
        const Vec3 v(in_[0], in_[1], in_[2]);
        in_ += 3;
        return v;
    }
    Pose pose() {
        Pose pose;
        for (int row = 0; row < 3; ++row) pose.R.row(row) = vector();
        pose.t = vector();
        return pose;
    }
    Body body() {
        Body body;
        body.pose = pose();
        for (Vec3& v : body.corners) v = vector();
        body.to = pose();
        body.mesh = Mesh::create({body.corners.begin(), body.corners.end()}, {{0, 1, 2}});
        return body;
    }

    const double* in_;
};

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

// Subnormal numbers may count as zero.
bool is_zero(const Vec3& v) {
    std::uint64_t bits = 0;
    for (int k = 0; k < 3; ++k) bits |= std::bit_cast<std::uint64_t>(v[k]) << 1;
    return bits == 0;
}

// A share of the pairs is asked about distances: without optimisation these take ten times as long as all the rest.
constexpr std::size_t distances_every = 6;

std::uint64_t digest(const std::vector<Case>& cases) {
    std::uint64_t result = 0;
    TriangleRelations bodies;
    TriangleDistances distances;
    std::size_t count = 0;
    const auto add = [&](auto answer) { result = combine(result, static_cast<std::uint64_t>(answer) & 0xff); };
    for (const Case& one : cases) {
        const Body &a = one.a, &b = one.b;
        const exact::MeshExtent extent_a = exact::measure(*a.mesh), extent_b = exact::measure(*b.mesh);
        const exact::BodyRef first{a.mesh.get(), &extent_a, &a.pose}, second{b.mesh.get(), &extent_b, &b.pose};
        if (one.asked == Asked::segment || one.asked == Asked::ray) {
            const Line line = one.asked == Asked::segment ? Line(Segment{one.first, one.second})
                                                          : Line(Ray{one.first, one.second, one.limit});
            result = environment::digest_of_hit(result, line, first);
            continue;
        }
        bodies.bind(first, second);
        const Relation relation = bodies.relation(0, 0);
        add(relation);
        if (one.asked == Asked::translation) {
            if (!is_zero(one.first)) {
                result = environment::digest_of_translation(result, first, one.first, second);
            }
            continue;
        }
        if (one.asked == Asked::motion) {
            if (relation == Relation::apart) {
                result = environment::digest_of_motion(result, first, a.to, second, b.to);
            }
            continue;
        }
        add(triangle_triangle({a.pose, a.corners}, {b.pose, b.corners}));
        add(triangle_triangle(a.corners, b.corners));
        add(orient3d(a.corners[0], a.corners[1], b.corners[0], b.corners[1]));
        const PosedPoint p{a.pose, a.corners[0]}, q{a.pose, a.corners[1]}, r{b.pose, b.corners[0]},
            s{b.pose, b.corners[2]};
        add(orient3d(p, q, r, s));
        for (int axis = 0; axis < 3; ++axis) add(orient2d(p, q, r, axis));
        if (count++ % distances_every != 0) continue;
        distances.bind(first, second);
        result = digest(result, distances);
    }
    return result;
}

void print_digests(const std::vector<Case>& cases) {
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        for (const bool flush : {false, true}) {
#if !defined(__SSE2__)
            if (flush) continue;
#endif
            std::uint64_t result = 0;
            {
                const environment::InFloatMode in_mode({"", mode, flush});
                result = digest(cases);
            }
            std::printf("%016llx\n", static_cast<unsigned long long>(result));
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    const int every = argc > 2 ? std::atoi(argv[2]) : 1;
    std::ifstream file(argc > 1 ? argv[1] : "", std::ios::binary);
    std::vector<Case> cases;
    environment::Record record;
    for (int i = 0; file.read(reinterpret_cast<char*>(record.data()), sizeof record); ++i) {
        if (i % every == 0) cases.push_back(Reader(record).read());
    }
    if (cases.empty()) {
        std::fputs("usage: digest_main CORPUS [N]\n", stderr);
        return 2;
    }
    print_digests(cases);
}
