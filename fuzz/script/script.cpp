#include "fuzz/script/script.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace ecods::fuzz {

const char* name_of(const Call& call) {
    // By their places in the variant.
    constexpr std::array<const char*, std::variant_size_v<Call>> names = {
        "create_body",      "destroy_body",  "set_pose", "set_poses", "set_shape", "set_filter",
        "set_pair_enabled", "set_user_data", "reserve",  "set_test",  "refused",   "update"};
    return names[call.index()];
}

void Model::apply(const Call& call) {
    const auto with = [&](Label label, auto act) {
        const auto found = bodies.find(label);
        if (found != bodies.end()) act(found->second);
    };
    std::visit(
        Overloaded{[&](const Create& c) {
                       bodies[c.body] = {.part = c.part, .pose = c.pose};
                       next_label = std::max(next_label, c.body + 1);
                   },
                   [&](const Destroy& c) { bodies.erase(c.body); },
                   [&](const SetPose& c) { with(c.body, [&](ModelBody& body) { body.pose = c.pose; }); },
                   [&](const SetPoses& c) {
                       for (std::size_t i = 0; i < c.bodies.size(); ++i) {
                           with(c.bodies[i], [&](ModelBody& body) { body.pose = c.poses[i]; });
                       }
                   },
                   [&](const SetShape& c) { with(c.body, [&](ModelBody& body) { body.part = c.part; }); },
                   [&](const SetFilter& c) { with(c.body, [&](ModelBody& body) { body.filter = c.filter; }); },
                   [&](const SetUserData& c) { with(c.body, [&](ModelBody& body) { body.user_data = c.data; }); },
                   [](const auto&) {}},
        call);
}

namespace {

// Gives the bodies of calls, one after the other, their new labels. Whether a call is kept.
class Renamer {
  public:
    bool operator()(Create& call) {
        if (!labels_.emplace(call.body, next_).second) return false;
        call.body = next_++;
        return true;
    }
    bool operator()(Destroy& call) {
        const Label old = call.body;
        return rename(call.body) && labels_.erase(old) == 1;
    }
    bool operator()(SetPoses& call) {
        SetPoses kept;
        for (std::size_t i = 0; i < call.bodies.size(); ++i) {
            if (!rename(call.bodies[i])) continue;
            kept.bodies.push_back(call.bodies[i]);
            kept.poses.push_back(call.poses[i]);
        }
        const bool is_kept = call.bodies.empty() || !kept.bodies.empty();
        call = std::move(kept);
        return is_kept;
    }
    bool operator()(SetPairEnabled& call) { return call.a != call.b && rename(call.a) && rename(call.b); }
    bool operator()(Reserve&) { return true; }
    bool operator()(SetTests&) { return true; }
    bool operator()(Update&) { return true; }
    bool operator()(auto& call) { return rename(call.body); }

  private:
    bool rename(Label& label) const {
        const auto found = labels_.find(label);
        if (found == labels_.end()) return false;
        label = found->second;
        return true;
    }

    std::map<Label, Label> labels_;  // of bodies that are there, to their new ones
    Label next_ = 0;
};

}  // namespace

Script repaired(const Script& script) {
    Script result;
    Renamer renamer;
    for (Call call : script) {
        if (std::visit(renamer, call)) result.push_back(std::move(call));
    }
    return result;
}

}  // namespace ecods::fuzz
