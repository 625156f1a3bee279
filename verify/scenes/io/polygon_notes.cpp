#include "scenes/io/polygon_notes.hpp"

#include <fmt/format.h>

namespace ecods::scenes {

void add_polygon_counts(const std::filesystem::path& file, const PolygonCounts& counts, Scene& scene) {
    if (counts.ears + counts.crossing + counts.in_no_plane == 0) return;
    scene.polygons.push_back({file.string(), counts});
    const auto note = [&](const std::string& text) { scene.notes.push_back(file.string() + ": " + text); };
    const std::string of_all = fmt::format(" of {} polygon{}", counts.polygons, counts.polygons == 1 ? "" : "s");
    if (counts.ears > 0) {
        const std::string in_no_plane =
            counts.in_no_plane > 0 ? fmt::format("; {}{} in no plane", counts.in_no_plane, of_all) : "";
        note(fmt::format("{}{} cut by ears, as no fan covers a dent{}", counts.ears, of_all, in_no_plane));
    }
    if (counts.crossing > 0) {
        note(fmt::format("the outlines of {}{} cross themselves, the first at {}: cut into fans, which may be anything",
                         counts.crossing, of_all, counts.first_crossing));
    }
}

}  // namespace ecods::scenes
