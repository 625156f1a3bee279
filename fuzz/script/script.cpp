#include "fuzz/script/script.hpp"

#include <algorithm>
#include <utility>

namespace ecods::fuzz {

Part rounded_part(Part part, double radius) {
    const bool is_convex = part.form == MeshForm::convex || part.mesh->triangles().size() == 1;
    part.kind = is_convex ? ShapeKind::rounded_convex() : ShapeKind::rounded();
    part.radius = radius;
    return part;
}

using CreateWith = calls::CreateWith<InScript>;

std::string_view name_of(const Call& call) {
    return std::visit([](const auto& row) { return row.name; }, call);
}

std::optional<Label> created_body(const Call& call) {
    struct Created : NoField {
        std::optional<Label> label = {};
        void created(const Label& body) { label = body; }
    } created;
    std::visit([&](const auto& row) { row.fields(created, row); }, call);
    return created.label;
}

namespace {

// The part itself, however the body came to it.
Part whole(Part part) {
    part.refits = false;
    return part;
}

}  // namespace

void Model::apply(const Call& call) {
    const auto with = [&](Label label, auto act) {
        const auto found = bodies.find(label);
        if (found != bodies.end()) act(found->second);
    };
    std::visit(
        Overloaded{[&](const Create& c) {
                       bodies[c.body] = {.part = whole(c.shape), .pose = c.pose};
                       next_label = std::max(next_label, c.body + 1);
                   },
                   [&](const CreateWith& c) {
                       bodies[c.body] = {
                           .part = whole(c.shape), .pose = c.pose, .filter = c.filter, .user_data = c.user_data};
                       next_label = std::max(next_label, c.body + 1);
                   },
                   [&](const Destroy& c) {
                       bodies.erase(c.body);
                       std::erase_if(switched_off,
                                     [&](const auto& pair) { return pair.first == c.body || pair.second == c.body; });
                   },
                   [&](const SetPose& c) { with(c.body, [&](ModelBody& body) { body.pose = c.pose; }); },
                   [&](const SetPoses& c) {
                       for (std::size_t i = 0; i < c.bodies.size(); ++i) {
                           with(c.bodies[i], [&](ModelBody& body) { body.pose = c.poses[i]; });
                       }
                   },
                   [&](const SetShape& c) { with(c.body, [&](ModelBody& body) { body.part = whole(c.shape); }); },
                   [&](const SetFilter& c) { with(c.body, [&](ModelBody& body) { body.filter = c.filter; }); },
                   [&](const SetUserData& c) { with(c.body, [&](ModelBody& body) { body.user_data = c.data; }); },
                   [&](const SetPairEnabled& c) {
                       const std::pair pair = std::minmax({c.a, c.b});
                       if (c.is_enabled) switched_off.erase(pair);
                       if (!c.is_enabled && bodies.contains(c.a) && bodies.contains(c.b)) switched_off.insert(pair);
                   },
                   [&](const SetClearance& c) { clearance = c.clearance; },
                   [&](const SetRelations& c) { relations = c.are_listed; },
                   // No body is another afterwards.
                   [](const Reserve&) {}, [](const SetTests&) {}, [](const MakeAgain&) {}, [](const BadCall&) {},
                   [](const Manner&) {}, [](const Update&) {}},
        call);
}

namespace {

// The visitor that gives the bodies of calls, one call after the other, their new labels.
class Renamer : public NoField {
  public:
    bool is_kept = true;  // the call, so far

    void created(Label& label) {
        is_kept = is_kept && labels_.emplace(label, next_).second;
        if (is_kept) label = next_++;
    }
    void destroyed(Label& label) {
        const Label old = label;
        body(label);
        labels_.erase(old);
    }
    void body(Label& label) {
        last_ = label;
        const auto found = labels_.find(label);
        is_kept = is_kept && found != labels_.end();
        if (is_kept) label = found->second;
    }
    void other_body(Label& label) {
        is_kept = is_kept && label != last_;
        body(label);
    }
    void posed_bodies(std::vector<Label>& bodies, std::vector<Pose>& poses) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const auto found = labels_.find(bodies[i]);
            if (found == labels_.end()) continue;
            bodies[count] = found->second;
            poses[count++] = poses[i];
        }
        is_kept = is_kept && (count > 0 || bodies.empty());
        bodies.resize(count);
        poses.resize(count);
    }

  private:
    std::map<Label, Label> labels_;  // of bodies that are there, to their new ones
    Label next_ = 0;
    Label last_ = 0;  // before it was renamed
};

}  // namespace

Script repaired(const Script& script) {
    Script result;
    Renamer renamer;
    for (Call call : script) {
        renamer.is_kept = true;
        std::visit([&](auto& row) { row.fields(renamer, row); }, call);
        if (renamer.is_kept) result.push_back(std::move(call));
    }
    return result;
}

}  // namespace ecods::fuzz
