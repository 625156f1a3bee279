// The engines of the benchmark, as it uses them.
#pragma once

#include "fuzz/engines/engine_under_test.hpp"

namespace ecods::fuzz {

std::unique_ptr<EngineUnderTest> make_ecods(std::span<const scenes::NamedMesh> meshes);
std::unique_ptr<EngineUnderTest> make_fcl(std::span<const scenes::NamedMesh> meshes);
std::unique_ptr<EngineUnderTest> make_bullet(std::span<const scenes::NamedMesh> meshes);
std::unique_ptr<EngineUnderTest> make_ode(std::span<const scenes::NamedMesh> meshes);
std::unique_ptr<EngineUnderTest> make_cgal(std::span<const scenes::NamedMesh> meshes);

}  // namespace ecods::fuzz
