// In place of check_oracle.cpp where the oracle is not built: --oracle is refused, never passed over.
#include <stdexcept>

#include "check_oracle.hpp"

namespace ecods::check {
namespace {

[[noreturn]] void refuse() {
    throw std::runtime_error(
        "--oracle: this program was built without the oracle (CMake's ECODS_ORACLE, which needs CGAL)");
}

}  // namespace

struct OracleJudge::State {};

OracleJudge::OracleJudge(const scenes::Scene& scene) : scene_(scene) {}

OracleJudge::~OracleJudge() = default;

void OracleJudge::check_frame(SceneWorld&, const FrameAnswer&) {
    refuse();
}

bool oracle_agrees(const scenes::HardCase&, Relation, const std::vector<TrianglePair>&) {
    refuse();
}

}  // namespace ecods::check
