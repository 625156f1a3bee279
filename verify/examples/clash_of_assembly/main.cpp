// What clashes in an assembly: parts whose meshes bound solids are judged as such, the others as surfaces.
//
// usage: ecods_clash_of_assembly FILE [PICTURE.pov]      (glTF, OBJ, STL, PLY, OFF)
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <exception>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "ecods/world.hpp"
#include "examples/stage.hpp"
#include "scenes/io/scene_file.hpp"

namespace {

using namespace ecods;

// The shape of a mesh: a solid if it bounds one. Otherwise says which edge or triangles are in the way.
std::shared_ptr<const Shape> shape_of(const scenes::NamedMesh& mesh, std::size_t& reason_count) {
    try {
        return std::make_shared<Solid>(mesh.mesh);
    } catch (const Error& error) {
        if (++reason_count <= 3) fmt::print("  {} is no solid: {}\n", mesh.name, error.what());
        return std::make_shared<MeshShape>(mesh.mesh);
    }
}

void draw(const World& world, const std::set<BodyId>& clashing, const std::string& file) {
    examples::Stage stage({480, -800, 510}, {0, 0, 0});
    for (const BodyId body : world.bodies()) {
        const auto shape = std::static_pointer_cast<const MeshShape>(world.shape(body));
        stage.add(shape->mesh(), world.pose(body),
                  clashing.contains(body) ? examples::red : examples::glassy(examples::gray, 0.8));
    }
    stage.write(file);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 2) throw std::runtime_error("a file is expected");
    const scenes::Scene scene = scenes::read_file(argv[1]);
    World world;
    world.set_relations(true);
    std::vector<std::shared_ptr<const Shape>> shapes;
    std::size_t reason_count = 0;
    for (const scenes::NamedMesh& mesh : scene.meshes) shapes.push_back(shape_of(mesh, reason_count));
    std::map<BodyId, std::string> names;
    for (const scenes::SceneBody& body : scene.bodies)
        names[world.create_body(shapes[body.mesh_index], body.pose)] = body.name;
    world.update();
    fmt::print("{} parts, {} meshes of which {} bound no solid\n", names.size(), shapes.size(), reason_count);

    std::set<BodyId> clashing;
    std::map<Relation, std::size_t> counts;
    for (const PairRelation& pair : world.relations()) {
        ++counts[pair.relation];
        if (pair.relation <= Relation::crossing) continue;
        fmt::print("  {} {} {}\n", names[pair.bodies.a], fmt::streamed(pair.relation), names[pair.bodies.b]);
        clashing.insert({pair.bodies.a, pair.bodies.b});
    }
    fmt::print("{} pairs share a point:\n", world.relations().size());
    for (const auto& [relation, count] : counts) fmt::print("  {} {}\n", count, fmt::streamed(relation));
    if (argc > 2) draw(world, clashing, argv[2]);
} catch (const std::exception& error) {
    fmt::print(stderr, "ecods_clash_of_assembly: {}\n", error.what());
    return 1;
}
