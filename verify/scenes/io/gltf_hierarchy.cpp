#include <fmt/format.h>

#include "ecods/error.hpp"
#include "scenes/io/gltf_model.hpp"

namespace ecods::scenes {
namespace {

std::vector<JsonPlace> members(const JsonPlace& place, const char* list) {
    const auto found = place.find(list);
    return found ? found->elements() : std::vector<JsonPlace>();
}

// A node that is to be visited: where its index is written, and the pose of its parent.
struct Step {
    std::uint32_t node;
    JsonPlace place;
    Pose parent;
};

// The roots of the default scene; without scenes, the nodes that are nobody's children.
std::vector<Step> first_steps(const GltfModel& model, const std::vector<JsonPlace>& nodes) {
    const JsonPlace root = model.root();
    std::vector<Step> steps;
    const auto scene = root.find("scene");
    if (scene || !members(root, "scenes").empty()) {
        const JsonPlace chosen = scene ? model.target(*scene, "scenes") : root.at("scenes").element(0);
        for (const JsonPlace& node : members(chosen, "nodes")) steps.push_back({node.index(), node, {}});
        return steps;
    }
    std::vector<bool> is_child(nodes.size());
    for (const JsonPlace& node : nodes) {
        for (const JsonPlace& child : members(node, "children")) {
            if (child.index() < nodes.size()) is_child[child.index()] = true;
        }
    }
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        if (!is_child[i]) steps.push_back({i, nodes[i], {}});
    }
    return steps;
}

}  // namespace

Pose product(const Pose& parent, const Pose& child) {
    return {parent.R * child.R, parent.R * child.t + parent.t};
}

std::vector<std::optional<Pose>> world_poses(const GltfModel& model) {
    const std::vector<JsonPlace> nodes = members(model.root(), "nodes");
    std::vector<std::optional<Pose>> poses(nodes.size());
    std::vector<Step> stack = first_steps(model, nodes);
    while (!stack.empty()) {
        const Step step = stack.back();
        stack.pop_back();
        if (step.node >= nodes.size()) step.place.fail(fmt::format("nodes[{}] does not exist", step.node));
        const JsonPlace& node = nodes[step.node];
        if (poses[step.node]) node.fail("this node is reached twice: the hierarchy is not a tree");
        poses[step.node] = product(step.parent, local_pose(node));
        for (const JsonPlace& child : members(node, "children")) {
            stack.push_back({child.index(), child, *poses[step.node]});
        }
    }
    if (model.root().find("scenes") && model.root().at("scenes").size() > 0) return poses;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!poses[i]) nodes[i].fail("this node is below itself: the hierarchy is not a tree");
    }
    return poses;
}

}  // namespace ecods::scenes
