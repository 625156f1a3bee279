// Options configure a World, its bodies and its trace; an Asked is the subject of a question to a World (world.hpp).
//
// Example: verify/examples/how_do_i, mesh_that_is_no_body().
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/broad_phase.hpp"
#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// An Executor runs the library's tasks in the caller's threads: those of a thread pool, a task system or OpenMP. The
// library starts no thread. Between two calls of the library, an executor may serve other users.
class ECODS_API Executor {
  public:
    virtual ~Executor() = default;

    // Returns the number of calls that may run at the same time; at least 1, and always the same.
    virtual std::size_t worker_count() const noexcept = 0;

    // Calls task(i, worker) once for each i below task_count, in any order and on any threads. `worker` must be below
    // worker_count(), and different for calls that run at the same time. Returns when all calls have ended, and their
    // writes are visible to the caller. The library's tasks do not throw. If an executor breaks these rules, the
    // library throws ExecutorFailed: it never uses an answer that was not computed.
    virtual void run(std::size_t task_count, const std::function<void(std::size_t task, std::size_t worker)>& task) = 0;
};

struct WorldOptions {
    BroadPhaseKind broad_phase = BroadPhaseKind::automatic;

    // Runs the two-body tests of update(), closest_pairs(), depths() and signed_distances(). If it is null, the calling
    // thread runs them. Answers, lists, events, digests and counts are the same for any executor and number of workers.
    // Several threads may call a caller's own tests at the same time, each with its own QueryMemory. Questions about
    // one pair run in the calling thread.
    std::shared_ptr<Executor> executor = nullptr;

    // Lists the ids of the first bodies, in order; later bodies get ids that no body had. Empty: all ids are new. To
    // make a copy of another world in which every id, valid or stale, means the same, pass its World::bodies() followed
    // by its World::next_ids(). The two worlds then cannot distinguish each other's ids from their own.
    //
    // World() throws StaleBody, with the index of the entry, for a null id, for a second id of a slot, and for an id of
    // another world than the first id's. Memory: proportional to the greatest slot.
    std::vector<BodyId> ids = {};
};

// BodyOptions describes a body to be created. It must have either a mesh or a shape.
struct BodyOptions {
    std::shared_ptr<const Mesh> mesh = nullptr;  // bodies with the same Mesh share its tree
    std::shared_ptr<const Shape> shape = nullptr;
    Pose pose = {};
    CollisionFilter filter = {};
    std::uint64_t user_data = 0;
};

// An Asked is the subject of a question to a World: one of its bodies, a shape at a pose, or a mesh at a pose.
//
//     world.nearest(body);
//     world.nearest({shape, pose});
//     world.nearest({mesh, pose});
//     world.nearest({{mesh, pose}, filter});
//
// If the subject is a body, bodies whose pair with it is filtered out are skipped. Otherwise no body is skipped, unless
// the subject has a filter of its own. If no body has the Mesh, each question builds a new tree; to ask again with the
// same mesh, keep a MeshShape. A shape given by reference must outlive the Asked; a shape given by shared pointer is
// kept alive.
class Asked {
  public:
    struct MeshAt {
        std::shared_ptr<const Mesh> mesh;
        Pose pose;
    };

    Asked(BodyId body) : what_(body) {}
    template <std::derived_from<Shape> S>
    Asked(const Posed<S>& posed, std::optional<CollisionFilter> filter = {})
        : what_(Posed<Shape>(posed)), filter_(filter) {}
    template <std::derived_from<Shape> S>
    Asked(const S& shape, const Pose& pose) : what_(Posed<Shape>(shape, pose)) {}
    template <std::derived_from<Shape> S>
    Asked(std::shared_ptr<S> shape, const Pose& pose) : what_(Posed<Shape>(std::move(shape), pose)) {}
    Asked(std::shared_ptr<const Mesh> mesh, const Pose& pose) : what_(MeshAt{std::move(mesh), pose}) {}
    Asked(Asked subject, const CollisionFilter& filter) : what_(std::move(subject.what_)), filter_(filter) {}

    const std::variant<BodyId, Posed<Shape>, MeshAt>& what() const noexcept { return what_; }
    const std::optional<CollisionFilter>& filter() const noexcept { return filter_; }

  private:
    std::variant<BodyId, Posed<Shape>, MeshAt> what_;
    std::optional<CollisionFilter> filter_;
};

struct TraceOptions {
    // Writes a caller's own shape as one line, from which ReplayOptions::read_shape makes it again. If there is no such
    // function, or it returns more than a line, a call that adds such a shape throws NotSupported.
    std::function<std::string(const Shape&)> write_shape = nullptr;

    // If true, questions are written, too (trace.hpp names them), unless the caller gives a memory; those about a
    // subject (nearest, cast, cast_to_distance, entering) are written only if it is a body without a filter. A question
    // that throws is not written. A replay asks the questions again and compares the answers.
    bool questions = false;
};

// ---- counts

// Statistics count the work of a World.
//
// Memory of a world: 165 bytes a body; 55 to 66 bytes a pair of overlapping boxes, 16 for each list that contains the
// pair, and 4 while it is tested; spare capacity for growth; and the broad phase's own memory. An update before which
// nothing changed has constant cost. A pair at rest costs nothing at any update: the work is that of the broad phase
// for the boxes that moved, and one two-body test for each candidate pair with a body that moved. If a collision begins
// or ends, the list of colliding pairs is shifted from that pair on. A clearance costs all of this a second time, for
// larger boxes and the pairs within the clearance; without a clearance there is no such cost.
//
// Example: verify/examples/how_do_i, count_the_work().

// Counts the work for the clearance. The clearance has candidate pairs of its own: pairs whose boxes overlap after each
// box is enlarged by half the clearance on all sides. `two_body_tests` to `visited_pairs` are sums over the world's
// life; `broad_phase` counts since there was last no clearance; the other members are as of the last update.
struct ClearanceStatistics {
    std::uint64_t two_body_tests = 0;  // tests of whether a pair is within the clearance; colliding pairs need none
    std::uint64_t cache_hits = 0;
    std::uint64_t visited_pairs = 0;
    BroadPhaseCounts broad_phase;

    std::size_t candidate_count = 0;
    std::size_t filtered_count = 0;
    std::size_t close_count = 0;
};

// Counts the work of a world. `updates` to `visited_pairs` are sums over the world's life; the others are present
// values.
struct Statistics {
    std::uint64_t updates = 0;
    std::uint64_t moved_bodies = 0;    // bodies that were new, moved or reshaped at an update
    std::uint64_t two_body_tests = 0;  // candidate pairs tested at updates
    std::uint64_t cache_hits = 0;      // candidate pairs whose verdict was still valid at updates
    std::uint64_t visited_pairs = 0;   // pairs that updates processed: they began, ended, or have a body that changed
    BroadPhaseCounts broad_phase;
    QueryCounts queries;  // of mesh pairs, at updates; questions are counted by Ask::counts
    ClearanceStatistics clearance;

    std::size_t body_count = 0;
    std::size_t overlapping_count = 0;  // as of the last update
    std::size_t filtered_count = 0;     // pairs whose boxes overlap and that are filtered out
    std::size_t colliding_count = 0;

    // Counts the bytes that the world holds for bodies and pairs, spare capacity included, without meshes and broad
    // phase.
    std::size_t memory_bytes = 0;
};

}  // namespace ecods
