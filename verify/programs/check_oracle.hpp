// The answers of the library against those of the oracle.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "check_scene.hpp"
#include "oracle/oracle.hpp"

namespace ecods::check {

// What was compared, and where the two differ.
struct OracleReport {
    std::size_t body_pairs = 0;      // all pairs of bodies, in each frame
    std::size_t triangle_pairs = 0;  // touching ones, by either; their lists must be equal
    std::size_t boxes = 0;           // stored boxes, which must contain the exact body
    std::vector<std::string> differences;
};

// Checks frame after frame. For every pair of bodies, candidates or not: whether it is listed as colliding, its
// relation and its complete list of triangle pairs. For the broad phase: the box of every body that moved, and that the
// overlapping pairs are those of all pairs of boxes. Work of the oracle is kept for pairs of which neither body moved.
class OracleJudge {
  public:
    explicit OracleJudge(const scenes::Scene& scene) : scene_(scene) {}

    void check_frame(SceneWorld& world, const FrameAnswer& answer);
    const OracleReport& report() const noexcept { return report_; }

  private:
    void pose_meshes(SceneWorld& world);
    void check_boxes(const SceneWorld& world, const FrameAnswer& answer);
    void check_pair(SceneWorld& world, const FrameAnswer& answer, std::size_t a, std::size_t b);
    const oracle::Verdict& verdict(std::size_t a, std::size_t b);
    void differ(const FrameAnswer& answer, const std::string& bodies, const std::string& text);

    const scenes::Scene& scene_;
    std::vector<std::optional<oracle::OracleMesh>> meshes_;                    // by body
    std::vector<bool> has_moved_;                                              // by body, in this frame
    std::map<std::pair<std::size_t, std::size_t>, oracle::Verdict> verdicts_;  // of pairs whose certified boxes overlap
    OracleReport report_;
};

}  // namespace ecods::check
