// Defines a world as Python holds it, which makes calls from several threads wait for each other if they must.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <optional>
#include <ostream>
#include <shared_mutex>
#include <utility>
#include <variant>
#include <vector>

#include "ecods/world.hpp"
#include "python/bind/shapes.hpp"
#include "python/bind/threads.hpp"

namespace ecods::python {

// Guards a world by a lock. Each call releases the interpreter's lock before it waits for the world's lock, and no
// operation on the world uses the interpreter, so there is no deadlock.
class SharedWorld {
  public:
    // Makes a world that this object guards. `ids` becomes WorldOptions::ids.
    SharedWorld(BroadPhaseKind broad_phase, std::size_t threads, std::vector<BodyId> ids = {})
        : broad_phase_(broad_phase),
          threads_(threads),
          world_({.broad_phase = broad_phase, .executor = make_threads(threads), .ids = std::move(ids)}) {}

    BroadPhaseKind broad_phase() const noexcept { return broad_phase_; }
    std::size_t threads() const noexcept { return threads_; }

    // Calls what(world) with exclusive access, for calls that change the world.
    template <class Change>
    auto change(Change what) {
        const pybind11::gil_scoped_release release;
        const std::unique_lock lock(mutex_);
        return what(world_);
    }

    // Calls what(world) with shared access, for questions and other calls that only read.
    template <class Read>
    auto read(Read what) const {
        const pybind11::gil_scoped_release release;
        const std::shared_lock lock(mutex_);
        return what(world_);
    }

    // begin_trace() begins a trace on a stream, which this object owns until the trace ends. end_trace() ends the trace
    // and returns the stream, or null if there was no trace.
    void begin_trace(std::unique_ptr<std::ostream> out, bool questions);
    std::unique_ptr<std::ostream> end_trace();

  private:
    mutable std::shared_mutex mutex_;
    std::unique_ptr<std::ostream> trace_;  // declared before the world, whose destructor may write to it
    const BroadPhaseKind broad_phase_;
    const std::size_t threads_;
    World world_;
};

// Return functions that pybind11 can bind and that make a call of World: changing() for a call that changes the world,
// reading() for a call that only reads.
template <class Result, class... Given>
auto changing(Result (World::*call)(Given...)) {
    return [call](SharedWorld& self, Given... given) {
        return self.change([&](World& world) { return (world.*call)(given...); });
    };
}
template <class Result, class... Given>
auto reading(Result (World::*call)(Given...) const) {
    return [call](const SharedWorld& self, Given... given) {
        return self.read([&](const World& world) { return (world.*call)(given...); });
    };
}

// A Subject is what a question is about: a body of the world, or a posed shape.
using Subject = std::variant<BodyId, PosedMesh, PosedRounded, PosedHalfSpace>;

inline Asked to_asked(const Subject& subject, const std::optional<CollisionFilter>& filter = {}) {
    Asked asked = std::visit([](const auto& what) { return Asked(what); }, subject);
    return filter ? Asked(std::move(asked), *filter) : asked;
}

// Return functions for pybind11 to bind. The function of asked_of_world() returns question(world, given...). The
// function of asked_of_pair() returns question(world, a, b, given...) for two subjects.
template <class... Given, class Question>
auto asked_of_world(Question question) {
    return [question](const SharedWorld& self, const Given&... given) {
        return self.read([&](const World& world) { return question(world, given...); });
    };
}
template <class... Given, class Question>
auto asked_of_pair(Question question) {
    return asked_of_world<Subject, Subject, Given...>(
        [question](const World& world, const Subject& a, const Subject& b, const Given&... given) {
            return question(world, to_asked(a), to_asked(b), given...);
        });
}

// Makes a callable that calls the member function `name` of World; the arguments select the overload.
#define ECODS_CALL(name) [](const World& world, const auto&... given) { return world.name(given...); }

using WorldClass = pybind11::class_<SharedWorld>;

void add_lists(WorldClass& type);
void add_pair_questions(WorldClass& type);
void add_questions_about_everything(WorldClass& type);
void add_trace_calls(WorldClass& type);
void add_copying(WorldClass& type);

}  // namespace ecods::python
