// A script is run, and everything is checked after each of its updates.
#pragma once

#include <cstddef>
#include <string>

#include "fuzz/base/counters.hpp"
#include "fuzz/checks/certificates.hpp"
#include "fuzz/script/scene.hpp"
#include "fuzz/script/script.hpp"

namespace ecods::fuzz {

// A lie that the checks must find.
enum class Canary {
    none,
    answer,  // the first true collision is taken for none
    crash,   // at the first collision, the process aborts
    hang,    // ... or does not go on
    proof,   // a certificate's proof loses a line
    recipe,  // a case of a pair, or a mesh, is not what its recipe promises
};

struct PlayOptions {
    Canary canary = Canary::none;
    CertificateOptions certificates = {};
};

// Where a check failed.
struct Failure {
    std::size_t update = 0;  // from 0: during it, or the calls before it
    std::string check = {};
    std::string expected = {};
    std::string got = {};
};

// The same script is the same play, on every machine; the checks take their random numbers from the number of the
// update. Throws Failure.
void play(const Script& script, const PlayOptions& options, Counters& counters);

}  // namespace ecods::fuzz
