// Names of bodies that are equal; for read_files.cpp and gltf_file.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace ecods::scenes {

struct BodyOrigin {
    std::string path;      // as it was given
    bool is_file = false;  // the body is all that the file has
};

// The bodies of each name that several bodies have, ascending; in n log n time, whatever the names.
std::vector<std::vector<std::size_t>> bodies_of_one_name(const Scene& scene);

// Where bodies of several paths have one name, each is named after its path: "a/part.obj" if it is all of that file,
// otherwise "a/part.obj: name". Names that are equal even then (of one path, given twice) get " (2)", " (3)" ... behind
// all but the first. A control character, which a terminal would obey, becomes a question mark. The names do not depend
// on the order of the paths, but for those numbers.
void make_names_unique(Scene& scene, const std::vector<BodyOrigin>& origins);

}  // namespace ecods::scenes
