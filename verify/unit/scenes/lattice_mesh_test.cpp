// Meshes on the lattice are mapped without rounding, so that what they promise is kept by their images.
#include "scenes/lattice_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "oracle/solid.hpp"
#include "scenes/solid_cases.hpp"

namespace ecods::scenes {
namespace {

int largest_coordinate(const LatticeMesh& mesh) {
    int largest = 0;
    for (const LatticePoint& p : mesh.vertices) {
        for (const int x : p) largest = std::max(largest, std::abs(x));
    }
    return largest;
}

// Points in a row stay so. Of 3000 images of walls of 600 by 20 by 250, with points up to 2350, four were open.
TEST(LatticeMesh, ZeroAreaIsMappedExactly) {
    Random random(1);
    for (const LatticePair& pair : fixed_contacts()) {
        for (int i = 0; i < 40; ++i) {
            LatticeMesh mesh = i % 2 == 0 ? pair.a : pair.b;
            ASSERT_LE(largest_coordinate(mesh), lattice_max) << pair.name;
            add_zero_area(mesh, random);
            ASSERT_LE(largest_coordinate(mesh), lattice_max) << pair.name;
            const PosedMesh image = place(mesh, random_map(random), -1010, random);
            ASSERT_FALSE(oracle::open_edge(*image.mesh)) << pair.name;
        }
    }
}

TEST(LatticeMesh, WhatWouldBeRoundedIsRefused) {
    Random random(1);
    const LatticeMap map;
    place(box({0, 0, 0}, {lattice_max, -lattice_max, 1}), map, 0, random);
    EXPECT_THROW(place(box({0, 0, 0}, {lattice_max + 1, 1, 1}), map, 0, random), std::logic_error);
    EXPECT_THROW(place(box({0, -lattice_max - 1, 0}, {1, 1, 1}), map, 0, random), std::logic_error);
}

}  // namespace
}  // namespace ecods::scenes
