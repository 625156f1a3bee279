#include "check_cases.hpp"

#include <algorithm>
#include <memory>

#include "ecods/error.hpp"
#include "ecods/two_body.hpp"
#include "oracle/oracle.hpp"
#include "scenes/io/json_place.hpp"

namespace ecods::check {
namespace {

using scenes::JsonPlace;

struct Body {
    std::shared_ptr<const Mesh> mesh;
    Pose pose;
};

Body read_body(const std::filesystem::path& file, const JsonPlace& place, const char* name) {
    return {scenes::read_inline_mesh(file, place.at("shapes").at(name)),
            scenes::read_pose(place.at("transforms").at(name))};
}

// Every way of asking the library about the pair.
struct Answer {
    bool intersects;
    Relation relation;
    std::vector<TrianglePair> triangles;

    bool is_consistent() const {
        return intersects == (relation != Relation::disjoint) && intersects == !triangles.empty();
    }
};

Answer ask(const Body& a, const Body& b) {
    const MeshShape shape_a(a.mesh);
    const MeshShape shape_b(b.mesh);
    const PosedMesh posed_a{shape_a, a.pose};
    const PosedMesh posed_b{shape_b, b.pose};
    QueryMemory memory;
    return {intersects(posed_a, posed_b, memory), relation(posed_a, posed_b, memory),
            touching_triangles(posed_a, posed_b, memory)};
}

bool is_mirrored(const Answer& answer, const Answer& other) {
    std::vector<TrianglePair> swapped;
    for (const TrianglePair& pair : other.triangles) swapped.push_back({pair.b, pair.a});
    std::sort(swapped.begin(), swapped.end());
    return answer.intersects == other.intersects && answer.relation == other.relation && answer.triangles == swapped;
}

bool oracle_agrees(const Body& a, const Body& b, const Answer& answer) {
    const oracle::OracleMesh mesh_a(a.mesh, a.pose);
    const oracle::OracleMesh mesh_b(b.mesh, b.pose);
    return oracle::relation(mesh_a, mesh_b) == answer.relation &&
           oracle::touching_triangles(mesh_a, mesh_b) == answer.triangles;
}

CaseAnswer run_case(const std::filesystem::path& file, const JsonPlace& place, bool with_oracle) {
    const Body a = read_body(file, place, "A");
    const Body b = read_body(file, place, "B");
    const JsonPlace expected = place.at("expected_true_answer");
    const bool expected_intersects = expected.at("surfaces_intersect_exact_affine").boolean();
    const std::size_t expected_pairs = expected.at("n_pairs_exact_affine").index();

    const Answer answer = ask(a, b);
    CaseAnswer result{place.at("id").text(), answer.intersects, answer.triangles.size(), false};
    result.is_ok = answer.intersects == expected_intersects && answer.triangles.size() == expected_pairs &&
                   answer.is_consistent() && is_mirrored(answer, ask(b, a)) &&
                   (!with_oracle || oracle_agrees(a, b, answer));
    return result;
}

}  // namespace

CasesReport run_cases(const std::filesystem::path& file, bool with_oracle) {
    const nlohmann::json document = scenes::read_json(file);
    CasesReport report;
    for (const JsonPlace& place : JsonPlace(file, document).at("cases").elements()) {
        if (place.at("shapes").find("A")) {
            report.cases.push_back(run_case(file, place, with_oracle));
        } else {
            ++report.skipped;
        }
    }
    return report;
}

}  // namespace ecods::check
