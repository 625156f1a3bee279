#include "tidy/edges.hpp"

#include <map>
#include <set>

namespace ecods::tidy {
namespace {

// The public headers, each in the lowest room that uses its words.
const std::map<std::string_view, std::string_view> header_rooms = {
    {"error.hpp", "src/base"},
    {"export.hpp", "src/base"},
    {"ids.hpp", "src/base"},
    {"instruction_set.hpp", "src/simd"},
    {"mesh.hpp", "src/geometry"},
    {"pose.hpp", "src/geometry"},
    {"primitives.hpp", "src/geometry"},
    {"results.hpp", "src/geometry"},
    {"predicates.hpp", "src/exact/sign"},
    {"ask.hpp", "src/query/shape"},
    {"shape.hpp", "src/query/shape"},
    {"two_body_test.hpp", "src/query/shape"},
    {"intersection.hpp", "src/query/intersection"},
    {"distance.hpp", "src/query/distance"},
    {"hit.hpp", "src/query/hit"},
    {"cast.hpp", "src/query/cast"},
    {"solid.hpp", "src/query/solid"},
    {"certificate.hpp", "src/query/certificate"},
    {"broad_phase.hpp", "src/broad_phase/changes"},
    {"world_options.hpp", "src/trace"},
    {"statistics.hpp", "src/world"},
    {"world.hpp", "src/world"},
    {"trace.hpp", "src/replay"},
    {"ecods.hpp", "include"},
};

const std::set<std::string_view> plain_headers = {"error.hpp",      "ids.hpp",        "mesh.hpp",   "pose.hpp",
                                                  "predicates.hpp", "primitives.hpp", "results.hpp"};

constexpr std::string_view public_folder = "include/ecods/";

}  // namespace

const std::vector<Room>& rooms() {
    static const std::vector<Room> table = {
        // The library.
        {"src/base", {}},
        {"src/simd", {"src/base"}},
        {"src/geometry", {"src/base", "src/simd"}},
        {"src/exact/number", {"src/base"}},
        {"src/exact/point", {"src/base", "src/simd", "src/geometry", "src/exact/number"}},
        {"src/exact/sign", {"src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point"}},
        {"src/exact/simplex",
         {"src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign"}},
        {"src/exact/measure/round",
         {"src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign"}},
        {"src/exact/measure/distance",
         {"src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign",
          "src/exact/simplex", "src/exact/measure/round"}},
        {"src/exact/measure/contact",
         {"src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign",
          "src/exact/simplex", "src/exact/measure/round", "src/exact/measure/distance"}},
        {"src/exact/measure/line",
         {"src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign",
          "src/exact/simplex", "src/exact/measure/round"}},
        {"src/bounds",
         {"src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign"}},
        {"src/bvh/tree", {"src/base", "src/simd", "src/geometry", "src/bounds"}},
        {"src/bvh/axes", {"src/base", "src/simd", "src/geometry", "src/bounds", "src/bvh/tree"}},
        {"src/bvh/masks", {"src/base", "src/simd", "src/geometry", "src/bounds", "src/bvh/tree", "src/bvh/axes"}},
        {"src/bvh/walks",
         {"src/base", "src/simd", "src/geometry", "src/bounds", "src/bvh/tree", "src/bvh/axes", "src/bvh/masks"}},
        {"src/query/shape",
         {"src/base", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign", "src/bounds",
          "src/bvh/tree"}},
        {"src/query/intersection",
         {"src/base", "src/simd", "src/geometry", "src/exact/point", "src/exact/sign", "src/exact/simplex",
          "src/bvh/axes", "src/bvh/walks", "src/query/shape"}},
        {"src/query/search", {"src/base", "src/bvh/walks", "src/query/shape", "src/query/intersection"}},
        {"src/query/distance",
         {"src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign",
          "src/exact/measure/round", "src/exact/measure/distance", "src/bvh/axes", "src/bvh/masks", "src/bvh/walks",
          "src/query/shape", "src/query/intersection", "src/query/search"}},
        {"src/query/hit",
         {"src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign",
          "src/exact/simplex", "src/exact/measure/round", "src/exact/measure/distance", "src/exact/measure/line",
          "src/bounds", "src/bvh/axes", "src/bvh/walks", "src/query/shape", "src/query/intersection",
          "src/query/search"}},
        {"src/query/cast",
         {"src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign",
          "src/exact/simplex", "src/exact/measure/round", "src/exact/measure/distance", "src/exact/measure/contact",
          "src/bvh/tree", "src/bvh/axes", "src/bvh/walks", "src/query/shape", "src/query/intersection",
          "src/query/search"}},
        {"src/query/solid",
         {"src/base", "src/simd", "src/geometry", "src/exact/point", "src/exact/sign", "src/exact/simplex",
          "src/bvh/tree", "src/bvh/axes", "src/bvh/masks", "src/bvh/walks", "src/query/shape",
          "src/query/intersection"}},
        {"src/query/convex",
         {"src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign",
          "src/exact/simplex", "src/exact/measure/round", "src/exact/measure/distance", "src/query/shape",
          "src/query/intersection", "src/query/solid"}},
        {"src/query/depth",
         {"src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign",
          "src/exact/simplex", "src/exact/measure/round", "src/query/shape", "src/query/intersection",
          "src/query/distance", "src/query/cast", "src/query/solid", "src/query/convex"}},
        {"src/query/certificate",
         {"src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign", "src/bounds",
          "src/bvh/tree", "src/bvh/masks", "src/bvh/walks", "src/query/shape", "src/query/intersection",
          "src/query/distance", "src/query/hit"}},
        {"src/broad_phase/changes", {"src/base", "src/simd", "src/geometry"}},
        {"src/broad_phase/boxes", {"src/base", "src/simd", "src/geometry", "src/bounds", "src/bvh/walks"}},
        {"src/broad_phase/scratch",
         {"src/base", "src/simd", "src/geometry", "src/broad_phase/changes", "src/broad_phase/boxes"}},
        {"src/broad_phase/sweep",
         {"src/base", "src/simd", "src/geometry", "src/broad_phase/changes", "src/broad_phase/boxes",
          "src/broad_phase/scratch"}},
        {"src/broad_phase/candidates",
         {"src/base", "src/simd", "src/geometry", "src/broad_phase/changes", "src/broad_phase/boxes",
          "src/broad_phase/scratch"}},
        {"src/broad_phase",
         {"src/base", "src/geometry", "src/bounds", "src/broad_phase/changes", "src/broad_phase/boxes",
          "src/broad_phase/sweep", "src/broad_phase/candidates"}},
        {"src/trace",
         {"src/base", "src/geometry", "src/query/shape", "src/query/solid", "src/query/convex",
          "src/broad_phase/changes"}},
        {"src/world",
         {"src/base", "src/geometry", "src/exact/sign", "src/query/shape", "src/query/intersection",
          "src/query/distance", "src/query/hit", "src/query/cast", "src/query/solid", "src/query/convex",
          "src/query/depth", "src/query/certificate", "src/broad_phase/changes", "src/broad_phase", "src/trace"}},
        {"src/replay",
         {"src/base", "src/geometry", "src/query/shape", "src/broad_phase/changes", "src/trace", "src/world"}},
        {"include",
         {"src/base", "src/simd", "src/geometry", "src/exact/sign", "src/query/shape", "src/query/intersection",
          "src/query/distance", "src/query/hit", "src/query/cast", "src/query/solid", "src/query/convex",
          "src/query/depth", "src/query/certificate", "src/broad_phase/changes", "src/trace", "src/world",
          "src/replay"}},
        {"src/python", {"include"}},

        // What checks it, and is not installed.
        {"verify/process", {}},
        {"verify/certificates/checker", {}},
        {"verify/certificates/folder", {"include"}},
        {"verify/oracle", {"include/plain"}},
        {"verify/scenes", {"include"}},
        {"verify/judge", {"include", "verify/oracle", "verify/scenes"}},
        {"verify/certificates/samples", {"include", "verify/scenes"}},
        {"verify/allocation", {"include", "verify/scenes"}},
        {"verify/exhaustive", {"include", "verify/oracle"}},
        {"verify/environment",
         {"include", "src/base", "src/simd", "src/geometry", "src/exact/point", "src/exact/measure/contact",
          "src/query/intersection", "src/query/distance", "src/query/hit", "src/query/cast", "verify/scenes"}},
        {"verify/threads", {"include", "verify/environment"}},
        {"verify/programs",
         {"include", "src/simd", "verify/process", "verify/certificates/folder", "verify/oracle", "verify/judge",
          "verify/scenes", "verify/environment"}},
        {"verify/programs/clash", {"include", "verify/process", "verify/scenes", "verify/programs"}},
        {"verify/examples", {"include", "verify/oracle", "verify/scenes"}},
        {"verify/foreign", {"include", "verify/scenes"}},
        {"verify/tidy", {}},
        {"verify/consumer", {"include"}},
        {"verify/unit/base", {"include", "src/base", "src/simd", "verify/environment"}},
        {"verify/unit/simd", {"include", "src/base", "src/simd", "verify/environment"}},
        {"verify/unit/geometry", {"include", "src/base", "src/geometry", "verify/scenes"}},
        {"verify/unit/exact",
         {"include", "src/base", "src/simd", "src/geometry", "src/exact/number", "src/exact/point", "src/exact/sign",
          "src/exact/simplex", "src/exact/measure/round", "src/exact/measure/distance", "src/exact/measure/contact",
          "src/exact/measure/line", "src/query/intersection", "src/query/distance", "verify/oracle", "verify/scenes",
          "verify/environment"}},
        {"verify/unit/bounds",
         {"include", "src/base", "src/bounds", "verify/oracle", "verify/scenes", "verify/environment"}},
        {"verify/unit/bvh",
         {"include", "src/base", "src/bvh/tree", "src/bvh/axes", "src/bvh/masks", "src/bvh/walks", "verify/oracle",
          "verify/scenes", "verify/environment"}},
        {"verify/unit/query",
         {"include", "src/query/shape", "src/base", "src/geometry", "src/query/search", "src/query/distance",
          "src/query/cast", "src/query/convex", "src/query/solid", "verify/oracle", "verify/judge", "verify/scenes",
          "verify/environment", "verify/certificates/samples"}},
        {"verify/unit/broad_phase",
         {"include", "src/base", "src/geometry", "src/bounds", "src/broad_phase/changes", "src/broad_phase/boxes",
          "src/broad_phase/scratch", "src/broad_phase/sweep", "src/broad_phase/candidates", "src/broad_phase",
          "verify/scenes", "verify/environment"}},
        {"verify/unit/world",
         {"include", "src/base", "src/broad_phase/changes", "src/broad_phase", "src/world", "verify/oracle",
          "verify/scenes", "verify/environment"}},
        {"verify/unit/trace", {"include", "src/trace", "verify/scenes", "verify/unit/world"}},
        {"verify/unit/oracle", {"include", "verify/oracle", "verify/scenes", "verify/exhaustive"}},
        {"verify/unit/scenes", {"include", "verify/oracle", "verify/scenes"}},
        {"verify/unit/allocation", {"include", "src/base", "verify/allocation", "verify/scenes"}},
        {"verify/unit/process", {"verify/process"}},
        {"verify/unit/programs", {"include", "verify/process", "verify/scenes", "verify/programs"}},
        {"verify/unit/clash",
         {"include", "verify/process", "verify/scenes", "verify/programs", "verify/programs/clash",
          "verify/unit/programs"}},
        {"verify/property", {"include", "verify/scenes", "verify/environment", "verify/unit/broad_phase"}},
        {"verify/property/guesses",
         {"include", "src/base", "src/geometry", "src/exact/point", "src/exact/measure/distance",
          "src/exact/measure/contact", "src/bounds", "src/bvh/tree", "src/bvh/axes", "src/bvh/masks", "src/bvh/walks",
          "src/query/hit", "src/query/cast", "src/query/convex", "verify/process", "verify/oracle", "verify/scenes",
          "verify/environment"}},

        // What tries to prove it wrong.
        {"fuzz/base", {"include", "src/trace", "verify/process"}},
        {"fuzz/pairs",
         {"include", "src/exact/point", "src/query/intersection", "src/query/distance", "verify/oracle", "verify/judge",
          "verify/scenes", "verify/environment", "fuzz/base"}},
        {"fuzz/checks",
         {"include", "verify/process", "verify/certificates/folder", "verify/oracle", "verify/judge", "verify/scenes",
          "fuzz/base"}},
        {"fuzz/script",
         {"include", "src/simd", "src/trace", "verify/scenes", "verify/environment", "verify/allocation", "fuzz/base",
          "fuzz/checks"}},
        {"fuzz/motion", {"include", "verify/judge", "verify/scenes", "fuzz/base", "fuzz/script"}},
        {"fuzz/shrink", {"include", "fuzz/script"}},
        {"fuzz/targets",
         {"include", "verify/certificates/checker", "verify/oracle", "verify/judge", "verify/scenes",
          "verify/environment", "fuzz/base", "fuzz/script"}},
        {"fuzz/tests",
         {"include", "verify/scenes", "verify/environment", "verify/unit/programs", "fuzz/base", "fuzz/checks",
          "fuzz/script", "fuzz/motion", "fuzz/shrink"}},
        {"fuzz",
         {"include", "verify/process", "verify/programs", "fuzz/base", "fuzz/pairs", "fuzz/script", "fuzz/motion",
          "fuzz/shrink"}},

        // What measures it.
        {"bench/engines",
         {"include", "src/simd", "src/broad_phase/changes", "src/broad_phase/boxes", "src/broad_phase/scratch",
          "verify/scenes", "verify/unit/broad_phase"}},
        {"bench/harness", {"include", "verify/process", "verify/oracle", "verify/scenes", "bench/engines"}},
        {"bench/report",
         {"include", "src/simd", "verify/process", "verify/scenes", "verify/environment", "bench/harness"}},
        {"bench/suites",
         {"include", "src/exact/point", "src/exact/sign", "src/exact/simplex", "src/query/intersection",
          "verify/process", "verify/oracle", "verify/judge", "verify/scenes", "bench/engines", "bench/harness",
          "bench/report"}},
        {"bench/python", {"include"}},
        {"bench/micro",
         {"include", "src/exact/point", "src/query/intersection", "src/bounds", "src/bvh/tree", "src/bvh/axes",
          "verify/scenes", "verify/environment"}},
        {"bench",
         {"include", "verify/process", "verify/programs", "verify/unit/programs", "bench/report", "bench/suites"}},
        {"fuzz/engines",
         {"include", "verify/process", "verify/programs", "verify/oracle", "verify/scenes", "bench/engines",
          "bench/harness", "bench/report"}},
    };
    return table;
}

const Room* find_room(std::string_view file) {
    std::string_view place = file;
    if (file.starts_with(public_folder)) {
        const auto at = header_rooms.find(file.substr(public_folder.size()));
        if (at == header_rooms.end()) return nullptr;
        place = at->second;
    } else if (file.starts_with("include/")) {
        return nullptr;
    }
    const Room* found = nullptr;
    for (const Room& room : rooms()) {
        const bool leads_there =
            place.starts_with(room.folder) && (place.size() == room.folder.size() || place[room.folder.size()] == '/');
        if (leads_there && (found == nullptr || room.folder.size() > found->folder.size())) found = &room;
    }
    return found;
}

bool is_plain_header(std::string_view file) {
    return file.starts_with(public_folder) && plain_headers.contains(file.substr(public_folder.size()));
}

}  // namespace ecods::tidy
