// What doubles say of a line and a triangle; what floats say of a line and the leaves of a tree, up to any parameter;
// and which triangles are gathered around a segment.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "bvh/axes/line_axes.hpp"
#include "bvh/walks/near_leaves.hpp"
#include "bvh/walks/walk_line.hpp"
#include "geometry/scaled_line.hpp"
#include "oracle/hits.hpp"
#include "oracle/solid_points.hpp"
#include "property/guesses/soups.hpp"
#include "query/hit/triangle_hits.hpp"

namespace ecods::guesses {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

oracle::ExactLine exact_line(const Line& line) {
    return {line.a, line.b, line.is_ray, line.end};
}

// The hit of each triangle.
struct Hits {
    std::vector<std::optional<oracle::ExactHit>> hits;
    const Line& line;

    Hits(const Line& of, const Mesh& mesh, const Pose& pose) : hits(mesh.triangles().size()), line(of) {
        for (const oracle::ExactHit& hit : oracle::all_hits(exact_line(line), soup_of(mesh, pose))) {
            hits[hit.feature.triangle] = hit;
        }
    }
};

// The sign of a parameter, scaled by 2^exponent, less a double.
int compare(const mpq_class& parameter, int exponent, double x) {
    if (std::isinf(x)) return x > 0 ? -1 : 1;
    mpq_class scaled;
    if (exponent >= 0) {
        mpq_mul_2exp(scaled.get_mpq_t(), parameter.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    } else {
        mpq_div_2exp(scaled.get_mpq_t(), parameter.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    }
    return cmp(scaled, mpq_class(x));
}

bool is_inside_face(const std::optional<oracle::ExactHit>& hit) {
    return hit && (hit->way == oracle::HitWay::front || hit->way == oracle::HitWay::back);
}

// Exact vectors of a triangle and a line: whether it has area, and whether the line is parallel to its plane.
struct Exact {
    using Vector = oracle::RationalPoint;

    static Vector normal(const Mesh& mesh, const Pose& pose, std::uint32_t triangle) {
        const Triangle& t = mesh.triangles()[triangle];
        std::array<Vector, 3> p;
        for (std::size_t i = 0; i < 3; ++i) p[i] = oracle::posed(pose, mesh.vertices()[t[i]]);
        using oracle::operator-;
        return oracle::cross(Vector(p[1] - p[0]), Vector(p[2] - p[0]));
    }
    static bool has_area(const Mesh& mesh, const Pose& pose, std::uint32_t triangle) {
        return std::ranges::any_of(normal(mesh, pose, triangle), [](const mpq_class& x) { return sgn(x) != 0; });
    }
    static bool is_across(const Line& line, const Mesh& mesh, const Pose& pose, std::uint32_t triangle) {
        const Vector n = normal(mesh, pose, triangle);
        mpq_class along = 0;
        for (int k = 0; k < 3; ++k) {
            const mpq_class d = line.is_ray ? mpq_class(line.b[k]) : mpq_class(line.b[k]) - mpq_class(line.a[k]);
            along += n[static_cast<std::size_t>(k)] * d;
        }
        return sgn(along) != 0;
    }
};

}  // namespace

void ask_hits(Case& c) {
    using Verdict = HitEnclosure::Verdict;
    const Bodies bodies = some_bodies(c.random, 3);
    const Mesh& mesh = *bodies.a;
    const Pose& pose = bodies.pose_a;
    const Line line = some_line(c.random, mesh, pose);
    const Hits truth(line, mesh, pose);
    const exact::MeshExtent extent = exact::measure(mesh);
    const exact::BodyRef body{&mesh, &extent, &pose};
    for_each_set_and_mode([&](const environment::FloatMode& mode, const std::string& where) {
        for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
            int exponent = 0;
            const HitEnclosure e = in_mode(mode, [&] {
                const ScaledLine scaled(line);
                exponent = scaled.exponent;
                TriangleHits triangles;
                triangles.prepare(body);
                triangles.bind(line, scaled, body);
                return triangles.enclose(mesh.triangles()[i]);
            });
            const auto& hit = truth.hits[i];
            c.require(e.verdict != Verdict::none || !hit, "a triangle that is hit is said not to be", where);
            c.require(e.verdict != Verdict::face || is_inside_face(hit), "a face is said to be hit, and is not", where);
            c.require(!e.is_crossing || Exact::is_across(line, mesh, pose, i), "a parallel plane is said to be crossed",
                      where);
            c.require(!e.has_area || Exact::has_area(mesh, pose, i), "a triangle without area is said to have one",
                      where);
            if (hit && e.is_crossing && e.verdict != Verdict::none) {
                c.require(compare(hit->enter, exponent, e.lower) >= 0, "a lower end above the parameter", where);
                c.require(compare(hit->enter, exponent, e.upper) <= 0, "an upper end below the parameter", where);
            }
            c.tally.telling += e.verdict != Verdict::open;
        }
    });
}

namespace {

// What the walk says of each triangle.
struct SaidOfTriangle {
    bool is_reached = false, crosses = false, is_inside = false;
    double low = 0, high = infinity;
};

struct Walked {
    const LineAxes& axes;
    float ratio;
    std::vector<SaidOfTriangle> said;

    float limit() const noexcept { return ratio; }
    void visit_node() noexcept {}
    void visit(const TreeLeaf& leaf, const FoundInLeaf& found) {
        for (std::size_t lane = 0; lane < leaf.count; ++lane) {
            const std::uint32_t bit = 1u << lane;
            SaidOfTriangle& of = said[leaf.triangle[lane]];
            of.is_reached = (found.may_meet & bit) != 0;
            of.crosses = (found.cross & bit) != 0;
            of.is_inside = (found.inside & bit) != 0 && axes.is_within(found.low[lane], found.high[lane]);
            if (!of.is_inside) continue;
            of.low = axes.parameter_below(found.low[lane]);
            of.high = axes.parameter_above(found.high[lane]);
        }
    }
};

// Those that are gathered around the segment, and found from there; nothing if none can be gathered.
std::optional<std::vector<bool>> gathered(Random& random, const Trees& trees, const LineAxes& axes, const Line& line) {
    const Vec3 aside = Vec3::Constant(random.uniform(0, 1) * (line.b - line.a).cwiseAbs().maxCoeff());
    const Vec3 low = line.a.cwiseMin(line.b) - aside, high = line.a.cwiseMax(line.b) + aside;
    NearLeaves leaves;
    std::uint64_t box_tests = 0, tested = 0;
    if (!low.allFinite() || !high.allFinite() || !leaves.gather(trees.a, axes, low, high, box_tests))
        return std::nullopt;
    if (!leaves.holds(line.a, line.b)) return std::nullopt;
    std::vector<bool> result(trees.count_a);
    for (const std::uint32_t triangle : leaves.find(trees.a, axes, line.a, line.b, tested)) result[triangle] = true;
    return result;
}

}  // namespace

void ask_line(Case& c) {
    const Trees trees(c.random, c.random.below(4) == 0 ? 40 : 8);
    const Mesh& mesh = *trees.bodies.a;
    const Pose& pose = trees.bodies.pose_a;
    const Line line = some_line(c.random, mesh, pose);
    const Hits truth(line, mesh, pose);
    // Up to the end of the line, or to the parameter of a hit.
    const auto& some = truth.hits[c.random.below(trees.count_a)];
    const bool is_limited = some && c.random.below(2) == 0;
    const double last = some ? oracle::nearest_parameter(some->enter) : infinity;
    for_each_set_and_mode([&](const environment::FloatMode& mode, const std::string& where) {
        LineAxes axes;
        LineAxes::Place place = LineAxes::Place::unknown;
        double limit = infinity;
        int exponent = 0;
        Walked walked{axes, 1, std::vector<SaidOfTriangle>(trees.count_a)};
        std::optional<std::vector<bool>> around;
        in_mode(mode, [&] {
            const ScaledLine scaled(line);
            exponent = scaled.exponent;
            limit = is_limited ? scaled.scaled_above(last) : scaled.end_high;
            axes.bind(trees.a, pose);
            place = axes.place(scaled, limit);
            if (place == LineAxes::Place::placed) {
                walked.ratio = axes.ratio_above(limit);
                std::vector<OrderedNode> stack;
                walk_line(trees.a, axes.part(), stack, walked);
            }
            if (!line.is_ray) around = gathered(c.random, trees, axes, line);
        });
        for (std::uint32_t i = 0; i < trees.count_a; ++i) {
            const auto& hit = truth.hits[i];
            const bool counts = hit && compare(hit->enter, exponent, limit) <= 0;
            const SaidOfTriangle& said = walked.said[i];
            if (around) {
                c.require((*around)[i] || !hit, "a triangle that is hit is not gathered", where);
                c.tally.telling += !(*around)[i];
            }
            if (place == LineAxes::Place::apart) c.require(!counts, "a body that is hit is said to be apart", where);
            if (place != LineAxes::Place::placed) continue;
            c.require(said.is_reached || !counts, "a triangle that is hit is dropped", where);
            c.require(!said.crosses || Exact::is_across(line, mesh, pose, i), "a parallel plane is said to be crossed",
                      where);
            c.require(!said.is_inside || is_inside_face(hit), "a face is said to be hit, and is not", where);
            if (said.is_inside && hit) {
                c.require(compare(hit->enter, exponent, said.low) >= 0, "a lower end above the parameter", where);
                c.require(compare(hit->enter, exponent, said.high) <= 0, "an upper end below the parameter", where);
            }
            c.tally.telling += !said.is_reached + said.is_inside;
        }
        c.tally.telling += place == LineAxes::Place::apart;
    });
}

}  // namespace ecods::guesses
