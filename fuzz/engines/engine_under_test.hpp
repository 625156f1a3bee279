// An engine that is judged: any collision library that answers whether two triangle meshes touch.
//
// To add one:
// 1. Write a file beside this one with a class derived from EngineUnderTest, and a function that makes one (rounded.cpp
//    is the shortest example). Use the engine as its documentation advises; an answer must not depend on those before.
// 2. Add a line with its name to the table in engines.cpp, and the file and the engine's library to CMakeLists.txt.
// 3. `ecods_fuzz_engine --engine NAME` then counts its false negatives and false positives, family by family.
// An engine in another language is a program of its own, with --engine-command: see README.md here.
// An engine may crash, hang or throw: it runs in a process of its own and is started again behind the query that did
// it. An engine of the benchmark (bench/engines/narrow_engine.hpp) needs no file here: peers.cpp hands them all on.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scenes/mesh_pairs.hpp"

namespace ecods::fuzz {

class EngineUnderTest {
  public:
    virtual ~EngineUnderTest() = default;

    // Whether two meshes at their poses share a point, surfaces alone. `query` names meshes of the list that the engine
    // was made with.
    virtual bool intersects(const scenes::MeshQuery& query) = 0;
};

struct EngineMaker {
    std::string name;  // for --engine: short, in small letters
    std::string use;   // how it is used, and what its precision is
    bool must_be_right = false;
    // `meshes` outlives what is made.
    std::function<std::unique_ptr<EngineUnderTest>(std::span<const scenes::NamedMesh> meshes)> make = {};
    bool shows_errors = false;  // its error stream is for whoever writes it; otherwise it is thrown away
};

// All that this program was built with, ECoDS first.
const std::vector<EngineMaker>& engines_under_test();

// An engine that says yes to everything, crashes at one query in sixteen and hangs at another: shows that wrong
// answers, crashes and hangs are seen. Not among the others.
EngineMaker canary_engine();

}  // namespace ecods::fuzz
