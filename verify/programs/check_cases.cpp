#include "check_cases.hpp"

#include <algorithm>
#include <sstream>

#include "check_certificates.hpp"
#include "check_oracle.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "ecods/shape.hpp"
#include "scenes/io/hard_case_file.hpp"

namespace ecods::check {
namespace {

using scenes::HardCase;
using Body = HardCase::Body;

// Every way of asking the library about the pair.
struct Answer {
    bool intersects;
    Relation relation;
    std::vector<TrianglePair> triangles;

    bool is_consistent() const {
        return intersects == (relation != Relation::apart) && intersects == !triangles.empty();
    }
};

Answer ask(const Body& a, const Body& b) {
    const MeshShape shape_a(a.mesh);
    const MeshShape shape_b(b.mesh);
    const Posed<MeshShape> posed_a{shape_a, a.pose};
    const Posed<MeshShape> posed_b{shape_b, b.pose};
    QueryMemory memory;
    return {intersects(posed_a, posed_b, memory), relation(posed_a, posed_b, memory),
            intersecting_triangles(posed_a, posed_b, memory)};
}

bool is_mirrored(const Answer& answer, const Answer& other) {
    std::vector<TrianglePair> swapped;
    for (const TrianglePair& pair : other.triangles) swapped.push_back({pair.b, pair.a});
    std::sort(swapped.begin(), swapped.end());
    return answer.intersects == other.intersects && answer.relation == other.relation && answer.triangles == swapped;
}

// Whether solids of the meshes are to each other as is known, in both orders.
bool has_solid_relation(const HardCase& hard) {
    const auto is = [](const Body& first, const Body& second, const std::string& expected) {
        const Solid a(first.mesh), b(second.mesh);
        QueryMemory memory;
        std::ostringstream relation;
        relation << ecods::relation({a, first.pose}, {b, second.pose}, memory);
        return relation.str() == expected;
    };
    const std::string& expected = *hard.solid_relation;
    const std::string mirrored = expected == "inside" ? "contains" : expected == "contains" ? "inside" : expected;
    return is(hard.a, hard.b, expected) && is(hard.b, hard.a, mirrored);
}

CaseAnswer run_case(const HardCase& hard, bool with_oracle) {
    const Answer answer = ask(hard.a, hard.b);
    CaseAnswer result{hard.id, answer.intersects, answer.triangles.size(), false};
    result.is_ok = answer.intersects == hard.intersects && answer.triangles.size() == hard.triangle_pair_count &&
                   answer.is_consistent() && is_mirrored(answer, ask(hard.b, hard.a)) &&
                   (!hard.solid_relation || has_solid_relation(hard)) &&
                   (!with_oracle || oracle_agrees(hard, answer.relation, answer.triangles));
    return result;
}

}  // namespace

CasesReport run_cases(const std::filesystem::path& file, bool with_oracle, certificates::CertificateFolder* folder) {
    const scenes::HardCases known = scenes::read_hard_cases(file);
    CasesReport report{.cases = {}, .skipped = known.skipped};
    for (const HardCase& hard : known.cases) {
        report.cases.push_back(run_case(hard, with_oracle));
        if (folder != nullptr) certify_case(hard, *folder);
    }
    return report;
}

}  // namespace ecods::check
