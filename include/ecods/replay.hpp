// Runs a trace again: every update must have the result that it had when the trace was written.
#pragma once

#include <cstddef>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "ecods/export.hpp"
#include "ecods/trace.hpp"
#include "ecods/world.hpp"

namespace ecods {

struct ReplayOptions {
    std::optional<BroadPhaseKind> broad_phase = {};  // in place of the trace's
    std::shared_ptr<Executor> executor = nullptr;
    bool validates = false;  // World::validate() after each update

    // Called for the new world: the place for tests of the caller's own.
    std::function<void(World&)> set_up = nullptr;

    // Called after each update that has gone as it did: the place for questions about the lists. May throw, which ends
    // the replay.
    std::function<void(const World&)> updated = nullptr;

    // Makes a shape from what TraceOptions::write_shape said. May throw.
    std::function<std::shared_ptr<const Shape>(ShapeKind, std::string_view)> read_shape = nullptr;
};

struct ReplayReport {
    // The first thing that is not as the trace says.
    struct Difference {
        std::size_t update;  // from 0: the update that differs, or that would have been next
        std::size_t call;    // from 0
        std::size_t line;    // from 1
        std::string what;
    };

    // Run so far: all of the trace, or the part up to the difference.
    std::size_t call_count = 0;
    std::size_t update_count = 0;
    std::size_t question_count = 0;
    std::size_t body_count = 0;  // alive at the end
    std::size_t colliding_count = 0;
    std::optional<Difference> difference = {};
};

// Runs a trace until its end, or until something differs: the id of a new body (in a trace that began with an empty
// world), the digest or the number of colliding pairs after an update, events that are not the difference of the lists
// before and after, the answer to a question (in such a trace, too), or what validate() finds. An update without a
// result, or that failed, is run and not compared.
//
// Throws InvalidTrace where the text is no trace, or where a call that it holds is refused; NotSupported for a shape of
// the caller's own without a reader; ExecutorFailed as World::update does. Whatever the text is: memory and time are in
// proportion to its length, and to the work of the updates in it.
ECODS_API ReplayReport replay(std::istream& trace, const ReplayOptions& options = {});

}  // namespace ecods
