// Checks that a call is refused, and why.
#pragma once

#include <gtest/gtest.h>

#include "scenes/is_about.hpp"

namespace ecods::scenes {

template <class Call, class Why>
testing::AssertionResult is_refused(const Call& call, Why why) {
    try {
        call();
    } catch (const std::exception& error) {
        if (is_about(error, why)) return testing::AssertionSuccess();
        return testing::AssertionFailure() << "another error: " << error.what() << "\n";
    }
    return testing::AssertionFailure() << "no error\n";
}

}  // namespace ecods::scenes

// EXPECT_THROW for a class of errors with reasons: `why` is an Argument, an InvalidMesh::Reason, a NotSolid::Reason, or
// the Question that is not supported.
#define EXPECT_INVALID(expression, why) \
    EXPECT_TRUE(ecods::scenes::is_refused([&] { static_cast<void>(expression); }, why)) << #expression "\n"
