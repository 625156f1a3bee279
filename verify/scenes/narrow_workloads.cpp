#include "scenes/narrow_workloads.hpp"

#include "scenes/fitted_parts.hpp"
#include "scenes/flush_parts.hpp"
#include "scenes/io/mesh_file.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"

namespace ecods::scenes {

namespace {

NamedMesh torus_of(std::uint32_t around, std::uint32_t along, const std::string& size) {
    return {"torus " + size, torus(around, along, 0.4)};
}

void add_near_and_random(std::vector<MeshPairs>& workloads, const NamedMesh& named, std::size_t near_count,
                         std::size_t random_count) {
    workloads.push_back(near_pairs(named.name + ", near", named.mesh, near_count, 1));
    workloads.push_back(random_pairs(named.name + ", random", named.mesh, random_count, 2));
}

}  // namespace

std::filesystem::path models_folder() {
    return "/usr/share/assimp/models";
}

std::vector<NamedMesh> real_meshes() {
    return {{"Wuson", read_mesh_file(models_folder() / "OBJ/WusonOBJ.obj")},
            {"spider", read_mesh_file(models_folder() / "OBJ/spider.obj")}};
}

std::vector<MeshPairs> narrow_workloads(WorkloadSize size) {
    const bool is_tiny = size == WorkloadSize::tiny;
    std::vector<MeshPairs> workloads;
    add_near_and_random(workloads, {"ship", ship()}, is_tiny ? 20 : 400, is_tiny ? 20 : 1000);
    add_near_and_random(workloads, torus_of(100, 50, "10k"), is_tiny ? 4 : 100, is_tiny ? 4 : 200);
    if (!is_tiny) add_near_and_random(workloads, torus_of(400, 125, "100k"), 50, 100);
    if (size == WorkloadSize::large) add_near_and_random(workloads, torus_of(4000, 1250, "10M"), 4, 4);
    for (const NamedMesh& mesh : real_meshes())
        add_near_and_random(workloads, mesh, is_tiny ? 4 : 100, is_tiny ? 4 : 200);
    workloads.push_back(stacked_bricks(is_tiny ? 12 : 400, 3));
    workloads.push_back(splined_shafts(is_tiny ? 4 : 40, 4));
    workloads.push_back(flush_plates("flush boxes", 1, 1, is_tiny ? 12 : 400, 7));
    workloads.push_back(flush_plates("flush plates", is_tiny ? 8 : 34, 0.125, is_tiny ? 4 : 30, 8));
    workloads.push_back(flat_polygons(is_tiny ? 100 : 1000, is_tiny ? 4 : 40, 9));
    add_near_and_random(workloads, {"one triangle", one_triangle()}, is_tiny ? 20 : 400, is_tiny ? 20 : 1000);
    return workloads;
}

std::vector<MeshPairs> gap_workloads(WorkloadSize size) {
    struct Gap {
        double radii;
        const char* name;
    };
    constexpr Gap gaps[] = {{1e-3, "1e-3"},   {1e-5, "1e-5"},   {1e-7, "1e-7"},   {1e-9, "1e-9"},
                            {1e-11, "1e-11"}, {1e-13, "1e-13"}, {1e-15, "1e-15"}, {0, "adjacent doubles"}};
    std::vector<MeshPairs> workloads;
    for (const Gap& gap : gaps)
        workloads.push_back(gap_pairs(gap.name, ship(), gap.radii, size == WorkloadSize::tiny ? 4 : 100, 5));
    return workloads;
}

std::vector<NamedMesh> build_workloads(WorkloadSize size) {
    std::vector<NamedMesh> meshes = {{"ship", ship()}, torus_of(100, 50, "10k")};
    if (size != WorkloadSize::tiny) meshes.push_back(torus_of(400, 125, "100k"));
    if (size == WorkloadSize::large) {
        meshes.push_back(torus_of(1000, 500, "1M"));
        meshes.push_back(torus_of(4000, 1250, "10M"));
    }
    for (const NamedMesh& mesh : real_meshes()) meshes.push_back(mesh);
    return meshes;
}

}  // namespace ecods::scenes
