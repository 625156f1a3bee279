// Options of a World, its bodies, the subjects of its questions, and its trace (world.hpp).
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

#include "ecods/broad_phase.hpp"
#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// The caller's threads, behind two functions: a thread pool, a task system or OpenMP fits in a few lines. The library
// starts no thread. An executor may serve other users between two calls of the library.
class ECODS_API Executor {
  public:
    virtual ~Executor() = default;

    // Returns how many calls may be under way at once; at least 1, and always the same.
    virtual std::size_t worker_count() const noexcept = 0;

    // Calls task(i, worker) once for each i below task_count, in any order, on any threads, with worker below
    // worker_count() and no two calls at once with the same worker; returns when all have ended, and their writes are
    // visible to the caller. The library's tasks do not throw. An executor that breaks this is found out
    // (ExecutorFailed): an answer that was not computed is never taken for one.
    virtual void run(std::size_t task_count, const std::function<void(std::size_t task, std::size_t worker)>& task) = 0;
};

struct WorldOptions {
    BroadPhaseKind broad_phase = BroadPhaseKind::automatic;

    // Runs the two-body tests of update(), depths() and solid_distances(); null: the thread that calls. Answers, lists,
    // events, digests and counts are the same for any executor and number of workers. Several threads call tests of the
    // caller's own, each with its own QueryMemory. Questions about a pair stay on the caller's thread.
    std::shared_ptr<Executor> executor = nullptr;

    // The ids of the first bodies, in this order; later bodies get ids that no body had. Pass World::bodies() followed
    // by World::next_ids() of another world to make a copy in which every id, valid or stale, means the same. The two
    // worlds then cannot distinguish each other's ids from their own. Empty: new ids.
    //
    // World() throws StaleBody, with the index of the entry, for a null id, for a second id of a slot, and for an id of
    // another world than the first one's. Memory: in proportion to the greatest slot.
    std::vector<BodyId> ids = {};
};

// A body to be. Either a mesh or a shape is needed.
struct BodyOptions {
    std::shared_ptr<const Mesh> mesh = nullptr;  // bodies given the same Mesh share its tree
    std::shared_ptr<const Shape> shape = nullptr;
    Pose pose = {};
    CollisionFilter filter = {};
    std::uint64_t user_data = 0;
};

// The subject of a question to a World: one of its bodies, a shape at a pose, or a mesh at a pose.
//
//     world.nearest(body);
//     world.nearest({shape, pose});
//     world.nearest({mesh, pose});
//     world.nearest({{mesh, pose}, filter});
//
// If the subject is a body, bodies filtered out with it are passed over. Otherwise no body is passed over, unless the
// subject has a filter of its own. A Mesh that no body has gets a new tree each time: keep a MeshShape to ask with it
// again. A shape given by reference must outlive the Asked; one given by a shared pointer is kept.
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
    // Writes a shape of the caller's own as one line, from which ReplayOptions::read_shape makes it again. Without it,
    // or where it returns more than a line, a call that brings such a shape in throws NotSupported and changes nothing.
    std::function<std::string(const Shape&)> write_shape = nullptr;

    // True to write questions, too (trace.hpp names them), if they are asked without memory of the caller's; nearest()
    // and cast() for bodies without a filter only. A question that throws is not written. A replay asks them again and
    // compares the answers.
    bool questions = false;
};

}  // namespace ecods
