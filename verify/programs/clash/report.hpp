// What ecods_clash finds, as plain data: made by judging, read by everything that writes.
//
// A report is canonical: it depends on what the files say and on the options, not on the order of the files nor on the
// number of jobs. So whoever writes it needs no order of its own, and writes no clock and no hidden state.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/shape.hpp"

namespace ecods::clash {

// One thing that may clash: a mesh at a pose.
struct Part {
    std::string name;   // unique, printable UTF-8 or any other bytes of a file; no control characters
    std::string file;   // the path as it was given, or found in a folder that was given
    std::string group;  // "a", "b" or "ab" by --a and --b; empty without groups, and if it is in none
    std::shared_ptr<const MeshShape> shape =
        nullptr;  // never null; a Solid, perhaps a convex one, if the mesh bounds one
    Pose pose = {};
    bool is_solid = false;
    std::string not_solid_because = {};  // of a part that is no solid: what is wrong, with the edge or triangles
};

// What kind of clash two parts have, from the worst to the least: a pair has the first that holds.
enum class Kind : std::uint8_t {
    equal,        // the same solid, whatever the triangles; of surfaces: the same triangles
    inside,       // one is a subset of the other, which is a solid
    overlapping,  // solids with inner points in common, neither of which contains the other
    crossing,     // one of the two is a surface and goes through the other's surface, or partly into the solid
    touching,     // points in common, none of them in the inside of both (of surfaces: no two triangles cross)
    clearance,    // no point in common, at a distance of at most the clearance
};
inline constexpr std::size_t kind_count = 6;
inline constexpr std::array<Kind, kind_count> all_kinds{Kind::equal,    Kind::inside,   Kind::overlapping,
                                                        Kind::crossing, Kind::touching, Kind::clearance};

// The word of every format: "equal", "inside", and so on, as above.
std::string_view name_of(Kind kind) noexcept;

// How deep two solids are in each other (solid.hpp). Of convex ones both are the depth, rounded once; of others they
// are proven bounds of it, and upper may be infinite.
struct Interval {
    double lower = 0;
    double upper = 0;
};

using Line = std::array<Vec3, 2>;

// Where two parts clash. Coordinates are those of the real points, rounded.
struct Place {
    // Holds all common points: what boxes around both share, or, where lines were asked for, the least such box. Of a
    // clearance: around the two closest points.
    Aabb box = {};

    // Where lines were asked for: points in common that are on no line, ascending. Of a clearance, always: the closest
    // point of a and that of b.
    std::vector<Vec3> points = {};

    // Where lines were asked for: where the surfaces meet along a line, and the outlines of where faces lie on each
    // other. Each has its lesser end first; ascending, each once. At most ClashReport::line_limit of them are kept.
    std::vector<Line> lines = {};
    std::size_t line_count = 0;  // with those that are not kept
};

struct Clash {
    std::size_t a = 0;  // in ClashReport::parts; a < b
    std::size_t b = 0;
    Kind kind = Kind::touching;

    // How a is to b, in the words of results.hpp: "equal", "inside" (a in b), "contains" (b in a),
    // "overlapping", "partly_inside", "crossing", "touching", "apart".
    std::string_view relation = {};

    Place place = {};
    std::optional<double> distance = {};  // of kind clearance: rounded once
    std::optional<Interval> depth = {};   // of two solids with inner points in common
};

struct FailedFile {
    std::string file;
    std::string error;  // "FILE: PLACE: TEXT"
};

struct ClashReport {
    std::vector<Part> parts;                       // ascending by name (bytes)
    std::vector<Clash> clashes;                    // ascending by kind, then by a, then by b
    std::vector<FailedFile> failed;                // with --keep-going; ascending by file
    std::vector<std::string> notes;                // what a file has, and the report has not; ascending
    std::array<std::size_t, kind_count> counts{};  // of clashes, by kind; of the kinds that were not asked for, 0
    std::size_t line_limit = 0;                    // 0: points and lines were not asked for

    // Those options that may change the report, as name and value: {"clearance", "0.05"}. In the order of --help.
    std::vector<std::pair<std::string, std::string>> options;
};

}  // namespace ecods::clash
