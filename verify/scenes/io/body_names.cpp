#include "scenes/io/body_names.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

namespace ecods::scenes {
namespace {

std::string printable(std::string name) {
    for (char& c : name) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
    }
    return name;
}

}  // namespace

std::vector<std::vector<std::size_t>> bodies_of_one_name(const Scene& scene) {
    // Names are compared where hashes are equal, which sorts a million short names without looking at them again.
    std::vector<std::pair<std::size_t, std::size_t>> order;  // hash, body
    order.reserve(scene.bodies.size());
    for (const SceneBody& body : scene.bodies) order.emplace_back(std::hash<std::string>()(body.name), order.size());
    const auto name_of = [&](const auto& item) -> const std::string& { return scene.bodies[item.second].name; };
    std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
        if (a.first != b.first) return a.first < b.first;
        const int names = name_of(a).compare(name_of(b));
        return names != 0 ? names < 0 : a.second < b.second;
    });
    std::vector<std::vector<std::size_t>> groups;
    bool is_open = false;
    for (std::size_t i = 1; i < order.size(); ++i) {
        const bool is_equal = order[i].first == order[i - 1].first && name_of(order[i]) == name_of(order[i - 1]);
        if (is_equal && !is_open) groups.push_back({order[i - 1].second});
        if (is_equal) groups.back().push_back(order[i].second);
        is_open = is_equal;
    }
    return groups;
}

void make_names_unique(Scene& scene, const std::vector<BodyOrigin>& origins) {
    for (SceneBody& body : scene.bodies) body.name = printable(std::move(body.name));
    const std::vector<std::vector<std::size_t>> groups_before = bodies_of_one_name(scene);
    if (groups_before.empty()) return;
    for (const std::vector<std::size_t>& group : groups_before) {
        const auto is_elsewhere = [&](std::size_t i) { return origins[i].path != origins[group.front()].path; };
        if (std::none_of(group.begin(), group.end(), is_elsewhere)) continue;
        for (const std::size_t i : group) {
            const std::string path = printable(origins[i].path);
            scene.bodies[i].name = origins[i].is_file ? path : path + ": " + scene.bodies[i].name;
        }
    }
    const std::vector<std::vector<std::size_t>> groups = bodies_of_one_name(scene);
    std::set<std::string> names;
    for (const SceneBody& body : scene.bodies) names.insert(body.name);
    for (const std::vector<std::size_t>& group : groups) {
        const std::string name = scene.bodies[group.front()].name;
        int number = 2;
        for (std::size_t i = 1; i < group.size(); ++i, ++number) {
            while (!names.insert(name + " (" + std::to_string(number) + ")").second) ++number;
            scene.bodies[group[i]].name = name + " (" + std::to_string(number) + ")";
        }
    }
}

}  // namespace ecods::scenes
