#include "fuzz/shrink/shrink.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <utility>
#include <vector>

#include "fuzz/shrink/simpler.hpp"

namespace ecods::fuzz {
namespace {

class Shrinker {
  public:
    Shrinker(const Script& script, const ShrinkOptions& options) : options_(options), best_(script) {}
    Script run();

  private:
    using Clock = std::chrono::steady_clock;

    bool accept(const Script& candidate);
    bool is_out_of_time() const {
        return std::chrono::duration<double>(Clock::now() - start_).count() > options_.seconds_max;
    }

    // Drops the first half of the items, the second, the first quarter, ..., each alone; keeps each result that still
    // fails. Both functions look at the best script so far.
    template <class Count, class Without>
    void drop(Count count, Without without);

    void drop_bodies();
    void drop_calls();
    void drop_poses();
    void drop_triangles();
    void share_meshes();
    void move_to_creation();
    void simplify_calls();
    void simplify_matrices();
    void round_all(int roundness);
    void round_each(int roundness);

    const ShrinkOptions& options_;
    Script best_;
    bool has_changed_ = false;
    Clock::time_point start_ = Clock::now();
};

bool Shrinker::accept(const Script& candidate) {
    if (is_out_of_time()) return false;
    Script repaired_one = repaired(candidate);
    if (!have_their_forms(repaired_one) || !options_.fails(repaired_one)) return false;
    best_ = std::move(repaired_one);
    has_changed_ = true;
    return true;
}

template <class Count, class Without>
void Shrinker::drop(Count count, Without without) {
    for (std::size_t chunk = (count() + 1) / 2; chunk > 0 && !is_out_of_time();
         chunk = chunk == 1 ? 0 : (chunk + 1) / 2) {
        for (std::size_t i = 0; i < count();) {
            if (!accept(without(i, chunk))) i += chunk;
        }
    }
}

void Shrinker::drop_bodies() {
    const auto is_create = [](const Call& call) { return created_body(call).has_value(); };
    drop([&] { return static_cast<std::size_t>(std::ranges::count_if(best_, is_create)); },
         [&](std::size_t begin, std::size_t count) {
             Script candidate = best_;
             std::size_t i = 0;
             std::erase_if(candidate, [&](const Call& call) {
                 if (!is_create(call)) return false;
                 const std::size_t index = i++;
                 return index >= begin && index < begin + count;
             });
             return candidate;
         });
}

void Shrinker::drop_calls() {
    drop([&] { return best_.size(); },
         [&](std::size_t begin, std::size_t count) {
             Script candidate = best_;
             const auto at = candidate.begin() + static_cast<std::ptrdiff_t>(begin);
             candidate.erase(at, at + static_cast<std::ptrdiff_t>(std::min(count, best_.size() - begin)));
             return candidate;
         });
}

void Shrinker::drop_poses() {
    for (std::size_t call = 0; call < best_.size(); ++call) {
        const auto moves = [&]() { return std::get_if<SetPoses>(&best_[call]); };
        if (moves() == nullptr) continue;
        // One pose is left at least, and then it may be a call of its own.
        drop([&] { return moves()->bodies.size() > 1 ? moves()->bodies.size() : 0; },
             [&](std::size_t begin, std::size_t count) {
                 Script candidate = best_;
                 auto& [bodies, poses] = std::get<SetPoses>(candidate[call]);
                 const auto from = static_cast<std::ptrdiff_t>(begin);
                 const auto to = static_cast<std::ptrdiff_t>(std::min(begin + count, bodies.size()));
                 if (from == 0 && to == static_cast<std::ptrdiff_t>(bodies.size())) return Script();
                 bodies.erase(bodies.begin() + from, bodies.begin() + to);
                 poses.erase(poses.begin() + from, poses.begin() + to);
                 return candidate;
             });
        if (moves()->bodies.size() != 1) continue;
        Script candidate = best_;
        candidate[call] = SetPose{moves()->bodies[0], moves()->poses[0]};
        accept(candidate);
    }
}

void Shrinker::drop_triangles() {
    for (std::size_t m = 0; m < meshes_of(best_).size(); ++m) {
        const auto mesh = [&] { return meshes_of(best_)[m]; };
        drop([&] { return mesh()->triangles().size() > 1 ? mesh()->triangles().size() : 0; },
             [&](std::size_t begin, std::size_t count) {
                 Script candidate = best_;
                 const auto smaller = without_triangles(*mesh(), begin, count);
                 if (!smaller) return Script();
                 replace_mesh(candidate, mesh().get(), smaller);
                 return candidate;
             });
    }
}

void Shrinker::share_meshes() {
    for (std::size_t m = 1; m < meshes_of(best_).size();) {
        Script candidate = best_;
        const auto meshes = meshes_of(best_);
        replace_mesh(candidate, meshes[m].get(), meshes[0]);
        if (!accept(candidate)) ++m;
    }
}

// A body is created where it goes, and as what it becomes.
void Shrinker::move_to_creation() {
    for (std::size_t i = best_.size(); i-- > 0 && !is_out_of_time();) {
        if (i >= best_.size()) continue;
        Script candidate = best_;
        if (fields_to_creation(candidate, i)) accept(candidate);
    }
}

void Shrinker::simplify_calls() {
    for (std::size_t call = 0; call < best_.size() && !is_out_of_time(); ++call) {
        for (std::size_t field = 0;;) {
            Script candidate = best_;
            if (!simplify_field(candidate[call], field)) break;
            if (!accept(candidate)) ++field;
            if (call >= best_.size()) return;
        }
    }
}

void Shrinker::simplify_matrices() {
    std::size_t count = 0;
    for_each_pose(best_, [&](Pose&) { ++count; });
    for (std::size_t i = 0; i < count; ++i) {
        Script candidate = best_;
        std::size_t at = 0;
        bool is_simpler = false;
        for_each_pose(candidate, [&](Pose& pose) {
            // A matrix that was made zero is left alone, lest it goes back and forth.
            if (at++ != i || pose.R.isIdentity(0) || pose.R.isZero(0)) return;
            pose.R.setIdentity();
            is_simpler = true;
        });
        if (is_simpler) accept(candidate);
    }
}

void Shrinker::round_all(int roundness) {
    Script candidate = best_;
    bool is_rounder = false;
    for_each_number(candidate, [&](double& x) {
        const double y = rounder(x, roundness);
        is_rounder = is_rounder || y != x;
        x = y;
    });
    if (is_rounder) accept(candidate);
}

void Shrinker::round_each(int roundness) {
    std::size_t count = 0;
    for_each_number(best_, [&](double&) { ++count; });
    for (std::size_t i = 0; i < count && !is_out_of_time(); ++i) {
        Script candidate = best_;
        std::size_t at = 0;
        bool is_rounder = false;
        for_each_number(candidate, [&](double& x) {
            if (at++ != i) return;
            const double y = rounder(x, roundness);
            is_rounder = y != x;
            x = y;
        });
        if (is_rounder) accept(candidate);
    }
}

Script Shrinker::run() {
    // Large things first, while each attempt is slow.
    do {
        has_changed_ = false;
        drop_bodies();
        drop_calls();
        drop_poses();
        move_to_creation();
        share_meshes();
        drop_triangles();
        simplify_calls();
        simplify_matrices();
        for (int roundness = 0; roundness < roundness_count; ++roundness) round_all(roundness);
        for (int roundness = 0; roundness < roundness_count; ++roundness) round_each(roundness);
    } while (has_changed_ && !is_out_of_time());
    return std::move(best_);
}

}  // namespace

Script shrink(const Script& script, const ShrinkOptions& options) {
    return Shrinker(script, options).run();
}

}  // namespace ecods::fuzz
