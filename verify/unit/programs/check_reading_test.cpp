// ecods_check: the files that it reads, and those that it does not.
#include "program_test.hpp"

namespace ecods::scenes {
namespace {

using CheckReading = ProgramTest;

TEST_F(CheckReading, OutOfMemorySaysSo) {
    expect_out_of_memory(ECODS_CHECK_PROGRAM);
}

TEST_F(CheckReading, FilesFromStrangersNameNoFilesElsewhere) {
    expect_untrusted_is_refused(ECODS_CHECK_PROGRAM);
}

}  // namespace
}  // namespace ecods::scenes
