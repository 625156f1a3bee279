// A failure becomes files: the shortest trace that still fails, and a picture of the moment.
#pragma once

#include <filesystem>

#include "fuzz/run.hpp"

namespace ecods::fuzz {

struct RecordOptions {
    std::filesystem::path folder;
    double shrink_seconds = 60;  // on the clock
    unsigned run_seconds = 60;   // of processor time, that a run may take
    PlayOptions play = {};
};

// Generates the run's script again, shrinks it to what fails the same check, writes PROFILE-SEED.trace and .obj, and
// says in the failure what they are, and what the short script's check expected and got. Pairs of triangles have their
// numbers in the failure already.
void record(RunFailure& failure, RecordOptions options);

// Plays a trace with all checks, in this process. What failed, if anything.
struct ReplayOptions {
    PlayOptions play = {};
    bool compares_digests = true;
};
std::optional<Failure> replay_trace(const std::filesystem::path& file, const ReplayOptions& options,
                                    Counters& counters);

// Writes a trace again with the digests that this build gives, and with its notes behind it: for a trace that shows a
// defect which is corrected, and for one that was written by hand, without digests.
void renew_trace(const std::filesystem::path& file);

}  // namespace ecods::fuzz
