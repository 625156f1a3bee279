#include "check_scene.hpp"

#include <algorithm>
#include <numeric>

namespace ecods::check {

SceneWorld::SceneWorld(const scenes::Scene& scene, BroadPhaseKind broad_phase, const SceneQuestions& questions)
    : scene_(scene), questions_(questions), world_(WorldOptions{.broad_phase = broad_phase}) {
    world_.set_clearance(questions.clearance);
    world_.set_relations(true);
    const std::vector<std::shared_ptr<const MeshShape>> shapes = make_shapes();
    for (const scenes::SceneBody& body : scene.bodies) {
        ids_.push_back(world_.create_body(shapes[body.mesh_index], body.pose));
    }
}

namespace {

// Null where the mesh is not convex, or bounds no solid.
std::shared_ptr<const MeshShape> convex_of(const std::shared_ptr<const Mesh>& mesh) {
    try {
        return std::make_shared<const ConvexSolid>(mesh);
    } catch (const NotSolid&) {
    }
    return nullptr;
}

}  // namespace

// By mesh: where that is asked about, a ConvexSolid or a Solid, if it bounds one.
std::vector<std::shared_ptr<const MeshShape>> SceneWorld::make_shapes() {
    std::vector<std::shared_ptr<const MeshShape>> shapes;
    for (const scenes::NamedMesh& named : scene_.meshes) {
        std::shared_ptr<const MeshShape> shape = questions_.has_depths ? convex_of(named.mesh) : nullptr;
        std::string why;
        try {
            if (!shape && questions_.has_solids) shape = std::make_shared<const Solid>(named.mesh);
        } catch (const NotSolid& error) {
            why = error.what();
        }
        shapes.push_back(shape ? shape : std::make_shared<const MeshShape>(named.mesh));
        no_solid_since_.push_back(why);
    }
    return shapes;
}

bool SceneWorld::next_frame() {
    if (frame_count_ > scene_.frames.size()) return false;
    moved_.clear();
    if (frame_count_ == 0) {
        moved_.resize(ids_.size());
        std::iota(moved_.begin(), moved_.end(), std::size_t{0});
    } else {
        const scenes::Frame& frame = scene_.frames[frame_count_ - 1];
        if (questions_.has_moves) find_meetings(frame);
        for (const scenes::Move& move : frame.moves) {
            world_.set_pose(ids_[move.body_index], move.pose);
            moved_.push_back(move.body_index);
        }
        std::sort(moved_.begin(), moved_.end());
    }
    world_.update();
    ++frame_count_;
    return true;
}

std::vector<HitAnswer> SceneWorld::hits() {
    std::vector<HitAnswer> hits;
    for (std::size_t ray = 0; ray < questions_.rays.size(); ++ray) {
        for (const BodyHit& hit : world_.all_hits(questions_.rays[ray]))
            hits.push_back({ray, body_of(hit.body), hit.hit});
    }
    return hits;
}

FrameAnswer SceneWorld::answer() {
    FrameAnswer answer;
    answer.frame = frame_count_ - 1;
    for (const BodyPair& pair : world_.overlapping_pairs()) {
        answer.overlapping.emplace_back(body_of(pair.a), body_of(pair.b));
    }
    for (const auto& [pair, relation] : world_.relations()) {
        answer.colliding.push_back(
            {body_of(pair.a), body_of(pair.b), relation, world_.intersecting_triangles(pair.a, pair.b)});
    }
    for (std::size_t a = 0; questions_.has_distances && a < ids_.size(); ++a) {
        for (std::size_t b = a + 1; b < ids_.size(); ++b) {
            answer.distances.push_back(distance(a, b));
        }
    }
    answer.clearance = world_.clearance();
    for (const BodyPair& pair : world_.close_pairs()) {
        answer.close.push_back(distance(body_of(pair.a), body_of(pair.b)));
    }
    answer.meetings = meetings_;
    if (questions_.has_casts) answer.casts = casts();
    answer.hits = hits();
    if (questions_.has_depths) find_depths(answer);
    return answer;
}

bool SceneWorld::is_convex(BodyId body) const {
    return dynamic_cast<const ConvexSolid*>(world_.shape(body).get()) != nullptr;
}

void SceneWorld::find_depths(FrameAnswer& answer) {
    for (const BodyDepth& pair : world_.depths()) {
        answer.depths.push_back({body_of(pair.bodies.a), body_of(pair.bodies.b), pair.depth});
    }
    for (const PairDistance& pair : world_.signed_distances(World::no_limit)) {
        const bool are_convex = is_convex(pair.bodies.a) && is_convex(pair.bodies.b);
        if (pair.distance > 0 && are_convex)
            answer.gaps.push_back({body_of(pair.bodies.a), body_of(pair.bodies.b), pair.distance});
    }
}

DistanceAnswer SceneWorld::distance(std::size_t a, std::size_t b) {
    return {a, b, closest(posed(a), posed(b), memory_)};
}

Posed<MeshShape> SceneWorld::posed(std::size_t body) const {
    return {dynamic_cast<const MeshShape&>(*world_.shape(ids_[body])), pose(body)};
}

std::size_t SceneWorld::body_of(BodyId id) const {
    return static_cast<std::size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
}

}  // namespace ecods::check
