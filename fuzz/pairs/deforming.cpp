#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "ecods/cast.hpp"
#include "fuzz/pairs/case_run.hpp"
#include "judge/cast_truth.hpp"
#include "judge/text.hpp"

namespace ecods::fuzz {
namespace {

using scenes::MoveCase;
using Points = std::vector<Vec3>;

Points posed(const Mesh& mesh, const Pose& pose) {
    Points points;
    for (const Vec3& v : mesh.vertices()) points.push_back(pose.R * v + pose.t);
    return points;
}

bool are_finite(const Points& points) {
    return std::ranges::all_of(points, [](const Vec3& v) { return v.allFinite(); });
}

// How the vertices of a mesh go from their places at the start to those at the end, given where a rigid body would be
// then, and a place of the other body.
struct DeformingFamily {
    const char* name;
    Points (*ends)(Points from, Points to, const Vec3& other);
};
constexpr DeformingFamily deforming_families[] = {
    {"as a body moves", [](Points, Points to, const Vec3&) { return to; }},
    {"inside out", [](Points, Points to, const Vec3&) { return Points(to.rbegin(), to.rend()); }},
    {"to a point", [](Points from, Points, const Vec3& other) { return Points(from.size(), other); }},
    {"one vertex",
     [](Points from, Points, const Vec3& other) {
         from.front() = other;
         return from;
     }},
    {"every other vertex",
     [](Points from, Points to, const Vec3&) {
         for (std::size_t i = 0; i < from.size(); i += 2) from[i] = to[i];
         return from;
     }},
    {"flat", [](Points, Points to, const Vec3& other) {
         for (Vec3& v : to) v[2] = other[2];
         return to;
     }}};

oracle::DeformingSoup soup_of(const Deforming& mesh) {
    const Mesh& start = mesh.shape()->mesh();
    return {{start.vertices(), start.triangles(), Pose()}, {mesh.mesh_at_end().vertices(), start.triangles(), Pose()}};
}

class Run : CaseRun {
  public:
    using CaseRun::CaseRun;

    // Families of deforming meshes take turns, and with each of them those of bodies that move.
    void check_one() {
        const auto moves = scenes::move_families();
        const DeformingFamily& family = deforming_families[index_ % std::size(deforming_families)];
        const scenes::Family<MoveCase>& move = moves[index_ / std::size(deforming_families) % moves.size()];
        ++index_;
        const MoveCase made = move.make(random_);
        if (made.a->triangles().size() * made.b->triangles().size() > pairs_max) return;
        const Points from_a = posed(*made.a, made.from_a), from_b = posed(*made.b, made.from_b);
        const Points to_a = posed(*made.a, made.to_a), to_b = posed(*made.b, made.to_b);
        if (!are_finite(from_a) || !are_finite(from_b) || !are_finite(to_a) || !are_finite(to_b)) return;
        family_ = std::string(family.name) + ", " + std::string(move.name);
        const Deforming a(shape(*made.a, from_a), family.ends(from_a, to_a, to_b.front()));
        check_beside_a_body(made, a);
        const DeformingFamily& other = deforming_families[random_.below(std::size(deforming_families))];
        check(made, a, Deforming(shape(*made.b, from_b), other.ends(from_b, to_b, to_a.front())));
    }

  private:
    static constexpr std::size_t pairs_max = 150;

    static std::shared_ptr<const MeshShape> shape(const Mesh& mesh, const Points& points) {
        return std::make_shared<const MeshShape>(
            Mesh::create(points, {mesh.triangles().begin(), mesh.triangles().end()}));
    }

    // The other body moves from pose to pose.
    void check_beside_a_body(const MoveCase& made, const Deforming& a) {
        const MeshShape b(made.b);
        const Moving<MeshShape> other(b, made.from_b, made.to_b);
        const oracle::Soup start{made.b->vertices(), made.b->triangles(), made.from_b},
            end{made.b->vertices(), made.b->triangles(), made.to_b};
        const oracle::DeformingSoup moves{start, end};
        ++counts_.cases;
        require_right(made, "a body", cast(a, other, 1, {memory_, witness_}), oracle::first_contact(soup_of(a), moves));
        require_right(made, "after a body", cast(other, a, 1, {memory_, witness_}),
                      oracle::first_contact(moves, soup_of(a)));
    }

    void check(const MoveCase& made, const Deforming& a, const Deforming& b) {
        const auto exact = oracle::first_contact(soup_of(a), soup_of(b));
        const auto expected = judge::to_first_contact(exact);
        ++counts_.cases;
        ++counts_.kinds[family_][expected ? judge::text(expected->kind) : "nothing"];
        if (lie_ && expected) fail({"cast", "nothing", judge::text(expected)}, made, "a lie");
        require_right(made, "both deform", cast(a, b, 1, {memory_, witness_}), exact);
        require_right(made, "both deform, exchanged", cast(b, a, 1, {memory_, witness_}),
                      oracle::first_contact(soup_of(b), soup_of(a)));
        if (expected && expected->time > 0) {
            require_right(made, "up to a time before it",
                          cast(a, b, std::nextafter(expected->time, 0), {memory_, witness_}), std::nullopt);
        }
        if (random_.below(4) != 0) return;
        require_in_environment(made, [&]() -> std::optional<judge::Wrong> {
            const auto got = cast(a, b, 1, {memory_, witness_});
            if (judge::is_same(got, expected)) return std::nullopt;
            return judge::Wrong{"cast", judge::text(expected), judge::text(got)};
        });
    }

    void require_right(const MoveCase& made, const std::string& how, const std::optional<FirstContact>& got,
                       const std::optional<oracle::ExactContact>& exact) {
        const auto expected = judge::to_first_contact(exact);
        ++counts_.checks[how];
        if (!judge::is_same(got, expected)) fail({"cast", judge::text(expected), judge::text(got)}, made, how);
    }
};

}  // namespace

void run_deforming(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    check_cases(seed, lie, counts, 120, &Run::check_one);
}

}  // namespace ecods::fuzz
