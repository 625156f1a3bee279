// A scene run by the library, frame by frame.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/world.hpp"
#include "scenes/scene.hpp"

namespace ecods::check {

// Two bodies that collide, by their indices in the scene, a < b, and the triangles that share a point.
struct PairAnswer {
    std::size_t a = 0;
    std::size_t b = 0;
    Relation relation = Relation::apart;
    std::vector<TrianglePair> triangles;
};

// How far two bodies are from each other, and where they are nearest.
struct DistanceAnswer {
    std::size_t a = 0;
    std::size_t b = 0;
    ClosestPoints closest;
};

// Two bodies that meet on the way from the frame before, a < b, or a turns and b does not; or the body a that is cast,
// and the first that it meets.
struct MeetingAnswer {
    std::size_t a = 0;
    std::size_t b = 0;
    FirstContact contact;
    std::optional<double> angle = {};  // in radians, by which a has turned, if it turns
};

// What the ray of this index in the questions hits.
struct HitAnswer {
    std::size_t ray = 0;
    std::size_t body = 0;
    Hit hit;
};

// Two convex solids that share a point, a < b: the shortest way out of the second; and two that do not.
struct DepthAnswer {
    std::size_t a = 0;
    std::size_t b = 0;
    Depth depth;
};
struct GapAnswer {
    std::size_t a = 0;
    std::size_t b = 0;
    double distance = 0;
};

// What is asked of every frame beside collisions.
struct SceneQuestions {
    std::optional<double> clearance = {};
    bool has_distances = false;  // of all pairs
    bool has_moves = false;      // which pairs meet on the way from the frame before
    bool has_casts = false;      // of bodies with a motion: what each meets first
    std::vector<Ray> rays = {};  // what each of them hits, everything
    bool has_solids = false;     // bodies of which the mesh bounds a solid are solids, in every answer
    bool has_depths = false;     // so are those of which it is convex: how deep they are, or how far, of all pairs

    bool may_have_solids() const noexcept { return has_solids || has_depths; }
};

// All answers for one frame; frame 0 is the rest. Lists are ascending.
struct FrameAnswer {
    std::size_t frame = 0;
    std::vector<std::pair<std::size_t, std::size_t>> overlapping;  // pairs of bodies whose boxes overlap
    std::vector<PairAnswer> colliding;
    std::vector<DistanceAnswer> distances;  // of all pairs of bodies, if they are asked for
    std::optional<double> clearance;
    std::vector<DistanceAnswer> close;    // pairs within the clearance, colliding ones included
    std::vector<MeetingAnswer> meetings;  // ascending by time
    std::vector<MeetingAnswer> casts;     // of bodies that meet something, by body
    std::vector<HitAnswer> hits;          // by ray, then as World::all_hits() has them
    std::vector<DepthAnswer> depths;
    std::vector<GapAnswer> gaps;
};

// The World of a scene. The scene must outlive it. Throws InvalidArgument, as World::set_clearance does.
class SceneWorld {
  public:
    SceneWorld(const scenes::Scene& scene, BroadPhaseKind broad_phase, const SceneQuestions& questions = {});

    // Goes to the next frame, the first time to frame 0, and updates the world. False after the last frame.
    bool next_frame();

    FrameAnswer answer();

    World& world() noexcept { return world_; }
    BodyId id(std::size_t body) const { return ids_[body]; }
    Pose pose(std::size_t body) const { return world_.pose(ids_[body]); }
    Aabb box(std::size_t body) const { return world_.box(ids_[body]); }
    const SceneQuestions& questions() const noexcept { return questions_; }

    // Where it was in the frame before, and by which turn it left; with moves, and from frame 1 on.
    const Pose& pose_before(std::size_t body) const { return poses_before_[body]; }
    const std::optional<Turn>& turn(std::size_t body) const { return turns_[body]; }

    // Why the body's mesh bounds no solid, in words; empty if it does. With solids only.
    const std::string& no_solid_since(std::size_t body) const {
        return no_solid_since_[scene_.bodies[body].mesh_index];
    }

    // The bodies that the last next_frame() created or moved, ascending.
    const std::vector<std::size_t>& moved() const noexcept { return moved_; }

    // Of a body's shape, at its pose: all bodies here are meshes. The world must not change while it is used.
    Posed<MeshShape> posed(std::size_t body) const;

  private:
    std::size_t body_of(BodyId id) const;
    DistanceAnswer distance(std::size_t a, std::size_t b);
    Posed<MeshShape> posed_before(std::size_t body) const;
    void find_meetings(const scenes::Frame& frame);
    void find_turn_meetings();
    std::optional<FirstContact> cast_of_turn(std::size_t a, std::size_t b);
    std::vector<MeetingAnswer> casts();
    std::vector<HitAnswer> hits();
    std::vector<std::shared_ptr<const MeshShape>> make_shapes();
    bool is_convex(BodyId body) const;
    void find_depths(FrameAnswer& answer);

    const scenes::Scene& scene_;
    SceneQuestions questions_;
    World world_;
    QueryMemory memory_;
    std::vector<BodyId> ids_;                  // by body; ascending, as they were created in order
    std::vector<std::string> no_solid_since_;  // by mesh
    std::vector<std::size_t> moved_;
    std::vector<Pose> poses_before_, poses_after_;
    std::vector<std::optional<Turn>> turns_;
    std::vector<MeetingAnswer> meetings_;  // on the way to this frame
    std::size_t frame_count_ = 0;          // frames gone to so far
};

}  // namespace ecods::check
