// Names of bodies that come from several files; for read_files.cpp.
#pragma once

#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace ecods::scenes {

struct BodyOrigin {
    std::string path;      // as it was given
    bool is_file = false;  // the body is all that the file has
};

// Where bodies of several paths have one name, each is named after its path: "a/part.obj" if it is all of that file,
// otherwise "a/part.obj: name". Names that are equal even then (of one path, given twice) get " (2)", " (3)" ... behind
// all but the first. A control character, which a terminal would obey, becomes a question mark. The names do not depend
// on the order of the paths, but for those numbers.
void make_names_unique(Scene& scene, const std::vector<BodyOrigin>& origins);

}  // namespace ecods::scenes
