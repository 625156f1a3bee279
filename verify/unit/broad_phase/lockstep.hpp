// A model of a broad phase, written from the header's promises alone, and all broad phases run beside it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <tuple>
#include <vector>

#include "ecods/broad_phase.hpp"

namespace ecods {

inline std::ostream& operator<<(std::ostream& out, const ProxyPair& pair) {
    return out << "(" << pair.a << ", " << pair.b << ")";
}

}  // namespace ecods

namespace ecods::test {

constexpr BroadPhaseKind all_kinds[] = {BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                                        BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic};

inline Aabb make_box(double x0, double x1, double y0, double y1, double z0, double z1) {
    return {.min = Vec3(x0, y0, z0), .max = Vec3(x1, y1, z1)};
}

// An interval on one axis; the others are the same for all boxes.
inline Aabb make_interval(int axis, double from, double to) {
    Aabb box = make_box(0, 1, 0, 1, 0, 1);
    box.min[axis] = from;
    box.max[axis] = to;
    return box;
}

inline Aabb make_cube(double x, double y, double z, double size = 1) {
    const Vec3 half = Vec3::Constant(size / 2);
    return {.min = Vec3(x, y, z) - half, .max = Vec3(x, y, z) + half};
}

// Each box has a birth number, so that a number that is used again is another box.
class Model {
  public:
    void add(ProxyIndex proxy, const Aabb& box) { boxes_[proxy] = {box, births_++}; }
    void move(ProxyIndex proxy, const Aabb& box) { boxes_.at(proxy).box = box; }
    void remove(ProxyIndex proxy) { boxes_.erase(proxy); }
    bool has(ProxyIndex proxy) const { return boxes_.contains(proxy); }
    const Aabb& box(ProxyIndex proxy) const { return boxes_.at(proxy).box; }
    std::size_t size() const { return boxes_.size(); }

    void update() {
        std::set<Born> now;
        pairs.clear();
        for (auto a = boxes_.begin(); a != boxes_.end(); ++a) {
            for (auto b = std::next(a); b != boxes_.end(); ++b) {
                if (!share_a_point(a->second.box, b->second.box)) continue;
                pairs.push_back({a->first, b->first});
                now.insert({{a->first, b->first}, a->second.birth, b->second.birth});
            }
        }
        began = only_in_first(now, last_);
        ended = only_in_first(last_, now);
        last_ = std::move(now);
    }

    std::vector<ProxyPair> pairs, began, ended;

  private:
    struct Box {
        Aabb box;
        std::uint64_t birth = 0;
    };
    struct Born {
        ProxyPair pair;
        std::uint64_t birth_a, birth_b;
        auto operator<=>(const Born&) const = default;
    };

    static bool share_a_point(const Aabb& a, const Aabb& b) {
        return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
    }
    static std::vector<ProxyPair> only_in_first(const std::set<Born>& first, const std::set<Born>& second) {
        std::vector<ProxyPair> result;
        for (const Born& born : first) {
            if (!second.contains(born)) result.push_back(born.pair);
        }
        return result;
    }

    std::map<ProxyIndex, Box> boxes_;
    std::set<Born> last_;
    std::uint64_t births_ = 0;
};

// Forwards each call to the model and to every broad phase; update() compares all that they answer. kept_candidates
// is called as for many boxes.
class Lockstep {
  public:
    enum class Checks { answers, invariants_too };

    void add(ProxyIndex proxy, const Aabb& box) {
        model.add(proxy, box);
        for (const auto& engine : engines) engine->add(proxy, box);
    }
    void move(ProxyIndex proxy, const Aabb& box) {
        model.move(proxy, box);
        for (const auto& engine : engines) {
            if (engine->kind() == BroadPhaseKind::kept_candidates) {
                engine->move(std::span(&proxy, 1), std::span(&box, 1));
            } else {
                engine->move(proxy, box);
            }
        }
    }
    void remove(ProxyIndex proxy) {
        model.remove(proxy);
        for (const auto& engine : engines) engine->remove(proxy);
    }
    void set(ProxyIndex proxy, const Aabb& box) { model.has(proxy) ? move(proxy, box) : add(proxy, box); }

    // False, with the reason recorded, when something differs.
    [[nodiscard]] bool update(Checks checks = Checks::invariants_too) {
        model.update();
        for (const auto& engine : engines) {
            engine->update();
            EXPECT_EQ(engine->pairs(), model.pairs) << name(*engine);
            EXPECT_EQ(engine->began(), model.began) << name(*engine);
            EXPECT_EQ(engine->ended(), model.ended) << name(*engine);
            EXPECT_EQ(engine->size(), model.size()) << name(*engine);
            if (checks == Checks::invariants_too) {
                EXPECT_NO_THROW(engine->check_invariants()) << name(*engine);
            }
        }
        for (const auto& engine : engines)
            EXPECT_EQ(engine->counts().moved, engines[0]->counts().moved) << name(*engine);
        return !::testing::Test::HasFailure();
    }

    static const char* name(const BroadPhase& engine) {
        static constexpr const char* names[] = {"brute_force", "sweep_and_prune", "kept_candidates", "automatic"};
        return names[static_cast<std::size_t>(engine.kind())];
    }

    const BroadPhaseCounts& counts(BroadPhaseKind kind) const {
        return engines[static_cast<std::size_t>(kind)]->counts();
    }
    const BroadPhaseCounts& sweep_counts() const { return counts(BroadPhaseKind::sweep_and_prune); }

    Model model;
    std::array<std::unique_ptr<BroadPhase>, 4> engines = {
        make_broad_phase(BroadPhaseKind::brute_force), make_broad_phase(BroadPhaseKind::sweep_and_prune),
        make_broad_phase(BroadPhaseKind::kept_candidates), make_broad_phase(BroadPhaseKind::automatic)};
};

using Pairs = std::vector<ProxyPair>;

}  // namespace ecods::test
