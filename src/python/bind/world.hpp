// A world as Python holds it: calls from several threads wait for each other where they must.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <ostream>
#include <shared_mutex>
#include <utility>
#include <vector>

#include "ecods/world.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/shapes.hpp"
#include "python/bind/threads.hpp"

namespace ecods::python {

// Each call gives up the interpreter's lock before it waits for the world's, and nothing done to the world needs the
// interpreter, so no two locks can wait for each other.
class SharedWorld {
  public:
    // With `ids` as in WorldOptions.
    SharedWorld(BroadPhaseKind broad_phase, std::size_t threads, std::vector<BodyId> ids = {})
        : broad_phase_(broad_phase),
          threads_(threads),
          world_({.broad_phase = broad_phase, .executor = make_threads(threads), .ids = std::move(ids)}) {}

    BroadPhaseKind broad_phase() const noexcept { return broad_phase_; }
    std::size_t threads() const noexcept { return threads_; }

    // The world alone: for calls that change it.
    template <class Change>
    auto change(Change what) {
        const pybind11::gil_scoped_release release;
        const std::unique_lock lock(mutex_);
        return what(world_);
    }

    // Beside other calls that only read.
    template <class Read>
    auto read(Read what) const {
        const pybind11::gil_scoped_release release;
        const std::shared_lock lock(mutex_);
        return what(world_);
    }

    // question(world, memory...): in the memory of the thread, beside others; or, while a trace is to have questions,
    // in the world's own.
    template <class Question>
    auto ask(Question question) {
        const pybind11::gil_scoped_release release;
        {
            const std::shared_lock lock(mutex_);
            if (!traces_questions_) return question(std::as_const(world_), thread_memory());
        }
        const std::unique_lock lock(mutex_);
        return question(world_);
    }

    // A trace on a stream, which the world keeps until the trace ends. Without a trace, the end gives null.
    void begin_trace(std::unique_ptr<std::ostream> out, bool questions);
    std::unique_ptr<std::ostream> end_trace();

  private:
    mutable std::shared_mutex mutex_;
    std::unique_ptr<std::ostream> trace_;  // before the world, which writes to it until it ends
    bool traces_questions_ = false;
    const BroadPhaseKind broad_phase_;
    const std::size_t threads_;
    World world_;
};

// Functions for pybind11 that make a call of World which changes it, or only reads.
template <class Result, class... Given>
auto changing(Result (World::*call)(Given...)) {
    return [call](SharedWorld& self, Given... given) {
        return self.change([&](World& world) { return (world.*call)(given...); });
    };
}
template <class Result, class... Given>
auto reading(Result (World::*call)(Given...) const) {
    return [call](SharedWorld& self, Given... given) {
        return self.read([&](const World& world) { return (world.*call)(given...); });
    };
}

// One that asks question(world, given..., memory...), as SharedWorld::ask does.
template <class... Given, class Question>
auto asked_of_world(Question question) {
    return [question](SharedWorld& self, const Given&... given) {
        return self.ask([&](auto& world, auto&... memory) { return question(world, given..., memory...); });
    };
}

// The World's function of that name, which has a form with a memory and one without.
#define ECODS_CALL(name) [](auto& world, auto&... given) { return world.name(given...); }

using WorldClass = pybind11::class_<SharedWorld>;

void add_lists(WorldClass& type);
void add_pair_questions(WorldClass& type);
void add_questions_about_everything(WorldClass& type);
void add_trace_calls(WorldClass& type);
void add_copying(WorldClass& type);

}  // namespace ecods::python
