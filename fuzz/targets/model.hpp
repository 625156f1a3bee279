// What a world must say, found in the most naive way: each pair of bodies is asked of the oracle.
#pragma once

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "ecods/world.hpp"
#include "oracle/oracle.hpp"

namespace ecods::fuzz {

struct ModelBody {
    BodyId id;
    std::shared_ptr<const Mesh> mesh;
    Pose pose;
    CollisionFilter filter = {};
    std::optional<oracle::OracleMesh> known = {};  // forgotten when the body changes

    void move_to(const Pose& to) {
        pose = to;
        known.reset();
    }
    void set_mesh(std::shared_ptr<const Mesh> to) {
        mesh = std::move(to);
        known.reset();
    }
    const oracle::OracleMesh& exact() {
        if (!known) known.emplace(mesh, pose);
        return *known;
    }
};

class Model {
  public:
    using Pairs = std::vector<BodyPair>;

    void forget(std::size_t index) {
        const BodyId id = bodies[index].id;
        std::erase_if(disabled_, [&](const BodyPair& pair) { return pair.a == id || pair.b == id; });
        bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(index));
    }

    void set_enabled(BodyId a, BodyId b, bool on) {
        const BodyPair pair = {std::min(a, b), std::max(a, b)};
        if (on) {
            disabled_.erase(pair);
        } else {
            disabled_.insert(pair);
        }
    }

    void update() {
        Pairs now = pairs([](ModelBody& a, ModelBody& b) { return oracle::intersects(a.exact(), b.exact()); });
        began_.clear();
        ended_.clear();
        std::ranges::set_difference(now, colliding_, std::back_inserter(began_));
        std::ranges::set_difference(colliding_, now, std::back_inserter(ended_));
        colliding_ = std::move(now);
    }

    // Of the boxes that the world has.
    Pairs overlapping(const World& world) {
        return pairs([&](const ModelBody& a, const ModelBody& b) {
            return oracle::boxes_overlap(world.box(a.id), world.box(b.id));
        });
    }

    const Pairs& colliding() const { return colliding_; }
    const Pairs& began() const { return began_; }
    const Pairs& ended() const { return ended_; }

    std::vector<ModelBody> bodies;

  private:
    // Ascending, without those that are filtered out.
    template <class Meet>
    Pairs pairs(Meet meet) {
        Pairs result;
        for (ModelBody& a : bodies) {
            for (ModelBody& b : bodies) {
                const BodyPair pair = {a.id, b.id};
                if (!(a.id < b.id) || !may_meet(a.filter, b.filter) || disabled_.contains(pair)) continue;
                if (meet(a, b)) result.push_back(pair);
            }
        }
        std::ranges::sort(result);
        return result;
    }

    std::set<BodyPair> disabled_;
    Pairs colliding_, began_, ended_;
};

}  // namespace ecods::fuzz
