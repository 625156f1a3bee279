// The answers of the library against those of the oracle. In a program that was built without it (check_no_oracle.cpp),
// each function says so by an exception.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "check_scene.hpp"
#include "scenes/io/hard_case_file.hpp"

namespace ecods::oracle {
class MeshDistances;
struct Soup;
struct TurningSoup;
}  // namespace ecods::oracle

namespace ecods::check {

// What was compared, and where the two differ.
struct OracleReport {
    std::size_t body_pairs = 0;      // all pairs of bodies, in each frame
    std::size_t triangle_pairs = 0;  // touching ones, by either; their lists must be equal
    std::size_t boxes = 0;           // stored boxes, which must contain the exact body
    std::size_t distances = 0;       // of two bodies, with features and points
    std::size_t clearances = 0;      // pairs of bodies that must be listed as close, or must not
    std::size_t moves = 0;  // pairs of bodies that must be listed as meeting on the way, or must not; and casts
    std::size_t rays = 0;   // with everything that they hit, in the exact order
    std::vector<std::string> differences;
};

// Checks frame after frame. For every pair of bodies, candidates or not: whether it is listed as colliding, its
// relation and, of two surfaces, its complete list of triangle pairs. For the broad phase: the box of every body that
// moved, and that the overlapping pairs are those of all pairs of boxes. Distances that the answer has, with their
// points; and with a clearance, for every pair of bodies whether it is listed as close; with moves, whether it meets on
// the way, and with casts what each body with a motion or a turn meets; and everything that rays hit: these of surfaces
// alone. Work of the oracle is kept for pairs of surfaces of which neither body moved, but for distances, moves and
// rays.
class OracleJudge {
  public:
    explicit OracleJudge(const scenes::Scene& scene);
    ~OracleJudge();

    void check_frame(SceneWorld& world, const FrameAnswer& answer);
    const OracleReport& report() const noexcept { return report_; }

  private:
    struct State;  // what the oracle keeps from frame to frame

    void pose_meshes(SceneWorld& world);
    void check_boxes(const SceneWorld& world, const FrameAnswer& answer);
    void check_pair(SceneWorld& world, const FrameAnswer& answer, std::size_t a, std::size_t b);
    void check_triangles(const FrameAnswer& answer, const std::string& bodies,
                         const std::vector<TrianglePair>& triangles, const std::vector<TrianglePair>& exact);
    oracle::MeshDistances distances(const SceneWorld& world, std::size_t a, std::size_t b) const;
    void check_distance(const oracle::MeshDistances& exact, const FrameAnswer& answer, const DistanceAnswer& pair);
    void check_close(const SceneWorld& world, const FrameAnswer& answer);
    void check_meetings(const SceneWorld& world, const FrameAnswer& answer);
    void check_meeting(const SceneWorld& world, const FrameAnswer& answer, std::size_t a, std::size_t b);
    std::optional<FirstContact> exact_cast(const SceneWorld& world, const FrameAnswer& answer, std::size_t a,
                                           std::size_t b);
    template <class Other>
    std::optional<FirstContact> exact_turn(const FrameAnswer& answer, const oracle::TurningSoup& a, const Other& b,
                                           const std::string& bodies);
    void check_casts(const SceneWorld& world, const FrameAnswer& answer);
    void check_hits(const SceneWorld& world, const FrameAnswer& answer);
    void differ(const FrameAnswer& answer, const std::string& bodies, const std::string& text);

    const scenes::Scene& scene_;
    std::unique_ptr<State> state_;
    OracleReport report_;
};

// Whether the oracle has the same answer for the bodies of a known case.
bool oracle_agrees(const scenes::HardCase& hard, Relation relation, const std::vector<TrianglePair>& triangles);

}  // namespace ecods::check
