// A real assembly: the parts of an engine, at rest and running.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "engines/world_bodies.hpp"
#include "process/progress.hpp"
#include "report/povray.hpp"
#include "report/time_chart.hpp"
#include "scenes/engine_motion.hpp"
#include "scenes/io/gltf_file.hpp"
#include "suites/comparison.hpp"
#include "suites/suite.hpp"

namespace ecods::bench {

namespace {

const char* name_of(Relation relation) {
    switch (relation) {
        case Relation::apart:
            return "-";
        case Relation::touching:
            return "touching";
        case Relation::crossing:
            return "crossing";
        default:
            return "?";
    }
}

struct ContactCheck {
    std::size_t asked = 0;
    std::size_t triangle_pairs = 0;
    std::size_t wrong = 0;  // contacts
};

// Asks a World about every contact that the oracle found. One of parts that rest is asked about once.
ContactCheck check_contacts(const scenes::Scene& scene, const Truth& truth) {
    WorldBodies bodies(scene);
    // ECoDS says the same as the oracle: how the bodies meet, and which triangles do.
    const auto agrees = [&](const TrueHit& hit) {
        const BodyId a = bodies[hit.pair.a], b = bodies[hit.pair.b];
        return bodies.world.relation(a, b) == hit.contact->relation &&
               bodies.world.intersecting_triangles(a, b) == hit.contact->triangles;
    };
    ContactCheck check;
    std::map<IndexPair, const Contact*> last;
    process::Progress progress("contacts asked of ECoDS: frames", truth.hits.size());
    for (std::size_t frame = 0; frame < truth.hits.size(); ++frame) {
        if (frame > 0) bodies.move(scene.frames[frame - 1].moves);
        for (const TrueHit& hit : truth.hits[frame]) {
            const Contact* contact = hit.contact.get();
            if (std::exchange(last[hit.pair], contact) == contact) continue;
            ++check.asked;
            check.triangle_pairs += contact->triangles.size();
            if (!agrees(hit)) ++check.wrong;
        }
        progress.step();
    }
    return check;
}

// What a pair of parts did over all frames.
struct PartsMeeting {
    Relation at_rest = Relation::apart;
    std::size_t triangles_at_rest = 0;
    std::size_t touching_frames = 0;
    std::size_t crossing_frames = 0;
    std::size_t triangles_max = 0;
};

std::map<IndexPair, PartsMeeting> meetings_of(const Truth& truth) {
    std::map<IndexPair, PartsMeeting> meetings;
    for (std::size_t frame = 0; frame < truth.hits.size(); ++frame) {
        for (const TrueHit& hit : truth.hits[frame]) {
            PartsMeeting& meeting = meetings[hit.pair];
            const Contact& contact = *hit.contact;
            if (frame == 0) {
                meeting.at_rest = contact.relation;
                meeting.triangles_at_rest = contact.triangles.size();
            }
            ++(contact.relation == Relation::crossing ? meeting.crossing_frames : meeting.touching_frames);
            meeting.triangles_max = std::max(meeting.triangles_max, contact.triangles.size());
        }
    }
    return meetings;
}

Table meetings_table(const scenes::Scene& scene, const std::map<IndexPair, PartsMeeting>& meetings,
                     std::size_t frame_count, bool moves) {
    Table table{.title = moves ? "Parts that meet while the crank turns" : "Parts that meet and do not move",
                .header = {"part A", "part B", "at rest", "triangle pairs"},
                .text_columns = 3};
    if (moves) table.header.insert(table.header.end(), {"frames touching", "frames crossing", "triangle pairs, most"});
    std::vector<bool> is_moving(scene.bodies.size(), false);
    for (const scenes::Frame& frame : scene.frames)
        for (const scenes::Move& move : frame.moves) is_moving[move.body_index] = true;
    for (const auto& [pair, meeting] : meetings) {
        if ((is_moving[pair.a] || is_moving[pair.b]) != moves) continue;
        std::vector<std::string> row = {scene.bodies[pair.a].name, scene.bodies[pair.b].name, name_of(meeting.at_rest),
                                        fmt::format("{}", meeting.triangles_at_rest)};
        if (moves)
            for (const std::size_t count : {meeting.touching_frames, meeting.crossing_frames, meeting.triangles_max})
                row.push_back(fmt::format("{}", count));
        table.rows.push_back(std::move(row));
    }
    if (moves) table.notes = {fmt::format("Of {} frames, the rest included.", frame_count)};
    return table;
}

// Crankcase, cylinders, heads and their covers.
bool is_casing(const std::string& mesh_name) {
    constexpr std::array<std::string_view, 7> names = {"body_1", "body_2", "body_3", "body_4",
                                                       "body_5", "body_8", "body_12"};
    return std::find(names.begin(), names.end(), mesh_name) != names.end();
}

Picture draw_engine(const scenes::Scene& scene, const Truth& truth, std::size_t frame,
                    const std::filesystem::path& folder) {
    std::vector<PaintedBody> bodies = bodies_at(scene, frame);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (is_casing(scene.meshes[scene.bodies[i].mesh_index].name)) bodies[i].paint = Paint::casing;
    for (const TrueHit& hit : truth.hits[frame]) {
        const Paint paint = hit.contact->relation == Relation::crossing ? Paint::crossing : Paint::touching;
        for (const TrianglePair& triangles : hit.contact->triangles) {
            Paint& a = bodies[hit.pair.a].triangles[triangles.a];
            Paint& b = bodies[hit.pair.b].triangles[triangles.b];
            a = std::max(a, paint);
            b = std::max(b, paint);
        }
    }
    const View view{.name = fmt::format("engine-{}", frame),
                    .eye = Vec3(-250, 1000, 640),
                    .target = Vec3(-5, -20, -12),
                    .angle = 37};
    return draw(
        scene, bodies, view, folder,
        fmt::format(
            "The engine at frame {}, its casing cut open. Where parts meet, the triangles that share a point are "
            "coloured: orange where the parts cross, blue where they touch only.",
            frame));
}

}  // namespace

SuiteResult run_assembly(const SuiteOptions& options) {
    SuiteResult result;
    scenes::Scene scene = scenes::read_gltf_file(scenes::engine_file());
    const std::size_t frame_count = std::min<std::size_t>(72, options.frame_count / 2);
    scenes::run_engine(scene, frame_count);

    const std::string title = "Two-cylinder engine";
    Comparison comparison = compare_engines(scene, title, options, Detail::contacts);
    const ContactCheck check = check_contacts(scene, comparison.truth);
    result.is_right = comparison.is_right && check.wrong == 0;
    comparison.table.notes.push_back(fmt::format(
        "{} contacts were asked about in full: ECoDS's relation and its list of triangle pairs ({} in all) are "
        "the oracle's in all but {}.",
        check.asked, check.triangle_pairs, check.wrong));

    const std::map<IndexPair, PartsMeeting> meetings = meetings_of(comparison.truth);
    const auto count_at_rest = [&](Relation relation) {
        return std::count_if(meetings.begin(), meetings.end(),
                             [&](const auto& entry) { return entry.second.at_rest == relation; });
    };
    const std::string at_rest = fmt::format("At rest, {} pairs of parts cross and {} touch only.",
                                            count_at_rest(Relation::crossing), count_at_rest(Relation::touching));
    const Table moving = meetings_table(scene, meetings, frame_count + 1, true);
    const Table resting = meetings_table(scene, meetings, frame_count + 1, false);
    const Table work = work_table(comparison.runs, "The work behind it: " + title);
    print(comparison.table);
    result.comparisons.push_back(comparison.table);
    print(work);
    fmt::print("{}\n\n", at_rest);
    print(moving);
    print(resting);

    std::size_t triangle_count = 0;
    for (const scenes::SceneBody& body : scene.bodies)
        triangle_count += scene.meshes[body.mesh_index].mesh->triangles().size();
    Section section{
        title,
        {fmt::format("A glTF assembly out of Debian's assimp-testmodels: {} parts, {} triangles. At rest, then "
                     "{} steps of the crank by 10 degrees: crankshaft, camshaft, their gears, rods, pistons and "
                     "pins move as the geometry demands; the valve train rests.",
                     scene.bodies.size(), triangle_count, frame_count)},
        {comparison.table, work},
        {}};
    if (options.has_pictures) {
        section.pictures.push_back(draw_engine(scene, comparison.truth, 0, options.folder));
        section.pictures.push_back(draw_engine(scene, comparison.truth, frame_count * 5 / 12, options.folder));
        section.charts.push_back(time_chart(comparison.runs, "engine-times",
                                            "The engine: milliseconds per frame. The scale is logarithmic."));
    }
    result.sections.push_back(std::move(section));
    result.sections.push_back({"Which parts of the engine meet", {at_rest}, {moving, resting}, {}});
    return result;
}

}  // namespace ecods::bench
