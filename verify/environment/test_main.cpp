// The main of every test program: that of GoogleTest, with the instruction sets of the run.
#include <gtest/gtest.h>

#include "environment/instruction_sets.hpp"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    ecods::environment::limit_by_variable_or_exit();
    return RUN_ALL_TESTS();
}
