// A call is made again and again in fresh copies of one scene, each time with another allocation that fails.
#pragma once

#include <cstdint>
#include <functional>
#include <new>
#include <string>
#include <utility>

#include "allocation/failing_allocations.hpp"

namespace ecods::allocation {

struct Failures {
    std::uint64_t allocations = 0;  // that failed
    std::uint64_t defects = 0;
    std::string first = {};  // of the defects

    void add(std::uint64_t number, const std::string& defect) {
        if (defects++ == 0) first = "allocation " + std::to_string(number) + ": " + defect;
    }
};

// Of one kind of scene: `make` makes it, always the same; `difference` says in what one differs from another, and is
// empty if in nothing; `after_failure` likewise, if a failure leaves something unspecified; `go_on` works with it
// afterwards, as a program would.
template <class Scene>
struct Trial {
    std::function<Scene()> make;
    std::function<void(Scene&)> call;
    std::function<std::string(Scene& expected, Scene& got)> difference;
    std::function<void(Scene&)> go_on = [](Scene&) {};
    std::function<std::string(Scene& expected, Scene& got)> after_failure = difference;
};

// Whether the call threw. Anything but std::bad_alloc is a defect.
template <class Scene>
bool runs_out_of_memory(const Trial<Scene>& trial, Scene& scene, std::uint64_t number, Shortage shortage,
                        Failures& failures) {
    const FailingAllocation failing(number, shortage);
    try {
        trial.call(scene);
    } catch (const std::bad_alloc&) {
        return true;
    } catch (const std::exception& error) {
        failures.add(number, std::string("another error: ") + error.what());
        return true;
    }
    return false;
}

// A scene in which the call failed, and is not made again, has the future of one in which it was never made.
template <class Scene>
void go_on_without(const Trial<Scene>& trial, Scene before, std::uint64_t number, Shortage shortage,
                   Failures& failures) {
    Scene scene = trial.make();
    // With threads, allocations are counted in another order each time: another one fails, or none.
    if (!runs_out_of_memory(trial, scene, number, shortage, failures)) return;
    trial.go_on(before);
    trial.go_on(scene);
    const std::string found = trial.difference(before, scene);
    if (!found.empty()) failures.add(number, "later, without the call: " + found);
}

// Returns a stride for fail_each_allocation() with which about so many allocations of the call fail.
template <class Scene>
std::uint64_t stride_of(const Trial<Scene>& trial, std::uint64_t failing_count) {
    Scene scene = trial.make();
    const CountedAllocations counted;
    trial.call(scene);
    return counted.count() / failing_count + 1;
}

// For each allocation of the call: it fails once, and it and all after it fail. Each time the scene is then as one in
// which nothing was called, and so is its future; the same call succeeds; and both that scene and its future are those
// of one in which nothing failed. A call may also succeed in spite of the failure, with the same consequences.
// With a stride, only every so manieth allocation: the first, and in a lasting shortage the second, and so on.
template <class Scene>
void fail_each_allocation(const Trial<Scene>& trial, Failures& failures, std::uint64_t stride = 1) {
    std::uint64_t count = 0;
    Scene after = trial.make();
    {
        const CountedAllocations counted;
        trial.call(after);
        count = counted.count();
    }
    Scene future = trial.make();
    trial.call(future);
    trial.go_on(future);
    for (const Shortage shortage : {Shortage::once, Shortage::lasting}) {
        const std::uint64_t first = shortage == Shortage::once ? 0 : 1 % stride;
        for (std::uint64_t number = first; number < count; number += stride) {
            ++failures.allocations;
            try {
                Scene scene = trial.make();
                Scene before = trial.make();
                const auto require_same = [&](const auto& difference, Scene& expected, const char* when) {
                    const std::string found = difference(expected, scene);
                    if (!found.empty()) failures.add(number, std::string(when) + ": " + found);
                };
                if (runs_out_of_memory(trial, scene, number, shortage, failures)) {
                    require_same(trial.after_failure, before, "after the failure");
                    go_on_without(trial, std::move(before), number, shortage, failures);
                    trial.call(scene);
                }
                require_same(trial.difference, after, "after the call");
                trial.go_on(scene);
                require_same(trial.difference, future, "later");
            } catch (const std::exception& error) {
                failures.add(number, std::string("later: ") + error.what());
            }
        }
    }
}

}  // namespace ecods::allocation
