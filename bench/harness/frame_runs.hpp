// Turns of engines that run frames, each in a process of its own with everything set up again.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engines/engine.hpp"
#include "harness/stopwatch.hpp"
#include "scenes/moving_boxes.hpp"
#include "scenes/scene.hpp"

namespace ecods::bench {

inline const std::vector<scenes::Move>& moves_of(const scenes::Frame& frame) {
    return frame.moves;
}
inline const std::vector<scenes::BoxMove>& moves_of(const std::vector<scenes::BoxMove>& frame) {
    return frame;
}

// Runs some frames untimed (harness/stopwatch.hpp says why), by an engine that is thrown away.
template <class Q>
void warm_up(const Maker<Q>& maker, const typename Q::Workload& workload) {
    const auto engine = maker.set_up(workload);
    engine->run_frame({});
    const Stopwatch watch;
    for (const auto& frame : workload.frames) {
        if (watch.nanoseconds() > warm_up_ns) break;
        engine->run_frame(moves_of(frame));
    }
}

// Reads a byte of each page. A child process is given the pages of its parent one at a time, when it first looks at
// them; that costs as much as some engines need for all that is in a page, and is no work of theirs.
template <class T>
void touch_pages(std::span<const T> values) {
    constexpr std::size_t page_size = 4096;
    const auto bytes = std::as_bytes(values);
    for (std::size_t i = 0; i < bytes.size(); i += page_size) {
        [[maybe_unused]] const volatile std::byte seen = bytes[i];
    }
    if (!bytes.empty()) {
        [[maybe_unused]] const volatile std::byte seen = bytes.back();
    }
}

// The processor time of a frame.
template <class Engine, class Move>
double nanoseconds_of_frame(Engine& engine, std::span<const Move> moves) {
    touch_pages(moves);
    const Stopwatch watch;
    engine.run_frame(moves);
    return watch.nanoseconds();
}

}  // namespace ecods::bench
