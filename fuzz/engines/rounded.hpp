#pragma once

#include "fuzz/engines/engine_under_test.hpp"

namespace ecods::fuzz {

std::unique_ptr<EngineUnderTest> make_rounded(std::span<const scenes::NamedMesh> meshes);

}  // namespace ecods::fuzz
