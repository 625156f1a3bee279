#include "fuzz/script/script.hpp"

#include <algorithm>

namespace ecods::fuzz {

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

Script repaired(const Script& script) {
    Script result;
    Model model;
    const auto is_here = [&](Label label) { return model.bodies.contains(label); };
    for (Call call : script) {
        const bool is_kept =
            std::visit(Overloaded{[&](const Create& c) { return !is_here(c.body); },
                                  [&](SetPoses& c) {
                                      SetPoses kept;
                                      for (std::size_t i = 0; i < c.bodies.size(); ++i) {
                                          if (!is_here(c.bodies[i])) continue;
                                          kept.bodies.push_back(c.bodies[i]);
                                          kept.poses.push_back(c.poses[i]);
                                      }
                                      c = std::move(kept);
                                      return !c.bodies.empty();
                                  },
                                  [&](const SetPairEnabled& c) { return is_here(c.a) && is_here(c.b) && c.a != c.b; },
                                  [](const SetTests&) { return true; }, [](const Update&) { return true; },
                                  [&](const auto& c) { return is_here(c.body); }},
                       call);
        if (!is_kept) continue;
        model.apply(call);
        result.push_back(std::move(call));
    }
    return result;
}

}  // namespace ecods::fuzz
