#include "scenes/io/body_names.hpp"

#include <map>
#include <set>

namespace ecods::scenes {
namespace {

std::string printable(std::string name) {
    for (char& c : name) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
    }
    return name;
}

}  // namespace

void make_names_unique(Scene& scene, const std::vector<BodyOrigin>& origins) {
    std::map<std::string, std::set<std::string>> paths_of;  // by name
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        std::string& name = scene.bodies[i].name;
        name = printable(std::move(name));
        paths_of[name].insert(origins[i].path);
    }
    std::set<std::string> names;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        std::string& name = scene.bodies[i].name;
        const std::string path = printable(origins[i].path);
        if (paths_of.at(name).size() > 1) name = origins[i].is_file ? path : path + ": " + name;
        names.insert(name);
    }
    std::map<std::string, int> numbers;  // by name: that of its newest body
    for (SceneBody& body : scene.bodies) {
        const std::string name = body.name;
        int& number = numbers[name];
        if (++number == 1) continue;
        while (!names.insert(name + " (" + std::to_string(number) + ")").second) ++number;
        body.name = name + " (" + std::to_string(number) + ")";
    }
}

}  // namespace ecods::scenes
