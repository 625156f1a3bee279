// A mesh, and the replay of a text, for the tests of traces.
#pragma once

#include <memory>
#include <sstream>
#include <string>

#include "ecods/mesh.hpp"
#include "ecods/trace.hpp"

namespace ecods {

inline const std::shared_ptr<const Mesh> triangle = Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, -0.0}}, {{0, 1, 2}});

inline ReplayReport replay_text(const std::string& text, const ReplayOptions& options = {}) {
    std::istringstream in(text);
    return replay(in, options);
}

}  // namespace ecods
