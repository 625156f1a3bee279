// What is inside what: what solids cost beside questions about surfaces, and points beside CGAL's
// Side_of_triangle_mesh.
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <utility>

#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "engines/side_engine.hpp"
#include "harness/statistics.hpp"
#include "harness/turns.hpp"
#include "oracle/solid.hpp"
#include "scenes/shapes.hpp"
#include "suites/comparison.hpp"
#include "suites/solid_scenes.hpp"
#include "suites/suite.hpp"
#include "suites/timed_rows.hpp"

namespace ecods::bench {

namespace {

using Pass = std::function<void()>;

// Times of each pass, one for each repetition, in turns.
std::vector<std::vector<double>> time_passes(const std::vector<Pass>& passes, std::size_t repetition_count) {
    std::vector<std::vector<double>> us(passes.size());
    for (std::size_t repetition = 0; repetition < repetition_count; ++repetition) {
        for (std::size_t i = 0; i < passes.size(); ++i) us[i].push_back(microseconds_a_pass(passes[i]));
    }
    return us;
}

std::string text(double us) {
    return fmt::format("{:.2f}", us);
}

// ---- points

Table empty_point_table(std::size_t repetition_count) {
    Table table{
        .title = "Is a point in a solid?",
        .header = {"mesh", "points", "triangles", "us", "CGAL us", "of CGAL", "at most", "CGAL wrong", "judged"},
        .text_columns = 2};
    table.notes = {medians_of(repetition_count) +
                   ", for one point. CGAL: Side_of_triangle_mesh of posed vertices, "
                   "rounded, whose answers on and near the posed surface may be "
                   "others. Judged: so many points by the oracle, before the times."};
    return table;
}

void add_point_rows(Table& table, const char* name, const std::shared_ptr<const Mesh>& mesh,
                    const SuiteOptions& options, bool& is_right) {
    const Solid solid(mesh);
    QueryMemory memory;
    for (const PointScene& scene : point_scenes(*mesh, options.is_quick() ? 10 : 1000)) {
        const auto cgal_side = side_of_mesh_by_cgal(*mesh, scene.pose);
        std::size_t wrong = 0, cgal_wrong = 0;
        const std::size_t judged = options.is_quick() ? 1 : 4;
        const oracle::Soup soup{mesh->vertices(), mesh->triangles(), scene.pose};
        for (std::size_t i = 0; i < scene.points.size(); ++i) {
            const Side side = locate(scene.points[i], {solid, scene.pose}, memory).side;
            cgal_wrong += cgal_side(scene.points[i]) != side;
            if (i < judged) wrong += side != static_cast<Side>(oracle::locate(scene.points[i], soup).side);
        }
        is_right &= wrong == 0;
        volatile int sink = 0;
        const Posed<Solid> posed(solid, scene.pose);
        const auto us = time_passes({[&] {
                                         for (const Vec3& point : scene.points)
                                             sink = static_cast<int>(locate(point, posed, memory).side);
                                     },
                                     [&] {
                                         for (const Vec3& point : scene.points)
                                             sink = static_cast<int>(cgal_side(point));
                                     }},
                                    options.repetition_count);
        const auto count = static_cast<double>(scene.points.size());
        table.rows.push_back({name, scene.name, fmt::format("{}", mesh->triangles().size()),
                              text(median(us[0]) / count), text(median(us[1]) / count), share_text(us[0], us[1]),
                              scene.has_target ? "1.5" : "3", fmt::format("{}", cgal_wrong),
                              fmt::format("{}", judged)});
    }
}

// ---- pairs

Table empty_pair_table(std::size_t repetition_count) {
    Table table{.title = "How are two solids to each other?",
                .header = {"scene", "relation", "triangles", "us", "other us", "of other", "at most", "wrong"},
                .text_columns = 2};
    table.notes = {medians_of(repetition_count) +
                   ". Other: where surfaces are apart, intersects() and one locate() for each shell, otherwise "
                   "intersecting_triangles(). Relations follow from how the solids are made, and are compared before "
                   "the times."};
    return table;
}

void add_pair_row(Table& table, const SolidScene& scene, std::size_t repetition_count, bool& is_right) {
    QueryMemory memory;
    const Posed<Solid> a(*scene.a, scene.pose_a), b(*scene.b, scene.pose_b);
    const Relation mirrored = scene.relation == Relation::contains ? Relation::inside : scene.relation;
    const int wrong = (relation(a, b, memory) != scene.relation) + (relation(b, a, memory) != mirrored);
    is_right &= wrong == 0;
    volatile int sink = 0;
    const auto corner_of = [](const Posed<Solid>& solid) {
        const Mesh& mesh = solid.what->mesh();
        return Vec3(solid.pose.R * mesh.vertices()[mesh.triangles()[0][0]] + solid.pose.t);
    };
    const Vec3 p = corner_of(a), q = corner_of(b);
    const Posed<MeshShape> surface_a(surface_of(*scene.a), a.pose), surface_b(surface_of(*scene.b), b.pose);
    const Pass apart = [&] {
        sink = intersects(surface_a, surface_b, memory);
        sink = static_cast<int>(locate(p, b, memory).side);
        sink = static_cast<int>(locate(q, a, memory).side);
    };
    const Pass meeting = [&] { sink = static_cast<int>(intersecting_triangles(a, b, memory).size()); };
    const auto us = time_passes(
        {[&] { sink = static_cast<int>(relation(a, b, memory)); }, scene.do_surfaces_meet ? meeting : apart},
        repetition_count);
    const std::size_t triangles = a.what->mesh().triangles().size() + b.what->mesh().triangles().size();
    table.rows.push_back({scene.name, (std::ostringstream() << scene.relation).str(), fmt::format("{}", triangles),
                          text(median(us[0])), text(median(us[1])), share_text(us[0], us[1]),
                          scene.do_surfaces_meet ? "2" : "1.5", fmt::format("{}", wrong)});
}

// ---- meshes

// Edges of all triangles, each as one number.
std::vector<std::uint64_t> edges_of(const Mesh& mesh) {
    std::vector<std::uint64_t> edges;
    for (const Triangle& t : mesh.triangles()) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
            edges.push_back(std::uint64_t{low} << 32 | high);
        }
    }
    return edges;
}

Table mesh_table(const SuiteOptions& options, bool& is_right) {
    Table table;
    table.title = "Does a mesh bound a solid?";
    table.header = {"mesh", "triangles", "check ms", "tree ms", "sort ms", "of tree + sort", "at most", "CGAL ms"};
    table.notes = {medians_of(options.repetition_count) +
                   ". Tree: that of a new shape. Sort: std::sort of all edges, as numbers. CGAL: "
                   "does_self_intersect(), which does not look whether the mesh is closed, as its Surface_mesh is."};
    const std::uint32_t size = options.is_quick() ? 20 : 708;
    for (const auto& [name, mesh] : {std::pair("sphere", scenes::sphere(size, size)),
                                     {"ring", scenes::torus(size, size, 0.25)},
                                     {"slab", slab(size / 2 * 2 / 3 * 2, 8)}}) {
        const auto does_self_intersect = self_intersection_by_cgal(*mesh);
        is_right &= !does_self_intersect();
        const std::vector<std::uint64_t> edges = edges_of(*mesh);
        const auto us = time_passes({[&] { check_solid(*mesh); }, [&] { MeshShape(mesh).tree_bytes(); },
                                     [&] {
                                         std::vector<std::uint64_t> sorted = edges;
                                         std::sort(sorted.begin(), sorted.end());
                                     },
                                     [&] { static_cast<void>(does_self_intersect()); }},
                                    options.repetition_count);
        std::vector<double> other;
        for (std::size_t i = 0; i < us[1].size(); ++i) other.push_back(us[1][i] + us[2][i]);
        const auto ms = [&](std::size_t i) { return text(median(us[i]) / 1000); };
        table.rows.push_back({name, fmt::format("{}", mesh->triangles().size()), ms(0), ms(1), ms(2),
                              share_text(us[0], other), "2", ms(3)});
    }
    return table;
}

}  // namespace

SuiteResult run_solids(const SuiteOptions& options) {
    SuiteResult result;
    Table points = empty_point_table(options.repetition_count), pairs = empty_pair_table(options.repetition_count);
    const std::uint32_t size = options.is_quick() ? 16 : 316;
    add_point_rows(points, "sphere", scenes::sphere(size, size / 2), options, result.is_right);
    add_point_rows(points, "ring", scenes::torus(size, size / 2, 0.25), options, result.is_right);
    for (const std::uint32_t count : options.is_quick() ? std::vector{200u} : std::vector{2000u, 100'000u}) {
        for (const SolidScene& scene : solid_scenes(count)) {
            add_pair_row(pairs, scene, options.repetition_count, result.is_right);
        }
    }
    Table meshes = mesh_table(options, result.is_right);
    for (const Table* const table : {&points, &pairs, &meshes}) print(*table);
    result.sections.push_back({"Solids", {}, {points, pairs, meshes}, {}});
    return result;
}

}  // namespace ecods::bench
