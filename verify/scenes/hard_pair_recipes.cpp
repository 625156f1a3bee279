#include "scenes/hard_pair_recipes.hpp"

#include "scenes/hard_pair_parts.hpp"

namespace ecods::scenes::hard {

PosedPair lattice(Random& random) {
    const IntTriangle a = integer_triangle(random, 2);
    const IntTriangle b = integer_triangle(random, 2);
    return in_basis(a, b, random);
}

PosedPair generic(Random& random) {
    PosedPair pair;
    pair.pose_a = random_pose(random);
    pair.pose_b = random_pose(random);
    pair.pose_b.t = pair.pose_a.t;
    for (int k = 0; k < 3; ++k) pair.pose_b.t[k] += full(random, -0.5, 0.5);
    for (auto* triangle : {&pair.a, &pair.b}) {
        for (Vec3& corner : *triangle) {
            for (int k = 0; k < 3; ++k) corner[k] = full(random, -1, 1);
        }
    }
    return pair;
}

PosedPair coplanar(Random& random) {
    IntTriangle a, b;
    do {
        a = integer_triangle(random, 3);
        b = integer_triangle(random, 3);
        for (auto* t : {&a, &b}) {
            for (Int3& corner : *t) corner[2] = 1;
        }
    } while (cross(minus(a[1], a[0]), minus(a[2], a[0])) == Int3{} ||
             cross(minus(b[1], b[0]), minus(b[2], b[0])) == Int3{});
    return in_basis(a, b, random);
}

// Edges a0 a1 and b0 b1 cross in the origin of the lattice; the third corners are anywhere.
PosedPair edge_on_edge(Random& random) {
    IntTriangle a, b;
    const auto opposite = [](const Int3& p, std::int64_t factor) {
        return Int3{-factor * p[0], -factor * p[1], -factor * p[2]};
    };
    do {
        a = integer_triangle(random, 2);
        a[1] = opposite(a[0], integer(random, 1, 2));
        b = integer_triangle(random, 2);
        b[1] = opposite(b[0], integer(random, 1, 2));
    } while (cross(minus(a[1], a[0]), minus(a[2], a[0])) == Int3{} ||
             cross(minus(b[1], b[0]), minus(b[2], b[0])) == Int3{});
    return in_basis(a, b, random);
}

Mat3 signed_permutation(Random& random) {
    std::array<int, 3> axes{0, 1, 2};
    for (std::size_t i = 2; i > 0; --i) {
        std::swap(axes[i], axes[random.below(static_cast<std::uint32_t>(i) + 1)]);
    }
    Mat3 R = Mat3::Zero();
    for (int i = 0; i < 3; ++i) R(i, axes[static_cast<std::size_t>(i)]) = coin(random) ? 1 : -1;
    return R;
}

// Corners of two boxes that share a face's plane, in space; undone by a permutation matrix for each body.
PosedPair permutations(Random& random) {
    const auto number = [&] { return std::floor(full(random, 0.1, 1) * 0x1p44) * 0x1p-44; };
    const Vec3 half_a{number(), number(), number()}, half_b{number(), number(), number()};
    Vec3 offset;
    for (int k = 0; k < 3; ++k) offset[k] = coin(random) ? half_a[k] - half_b[k] : half_a[k] + half_b[k];
    offset[integer(random, 0, 2)] = 0;
    PosedPair pair;
    pair.pose_a.R = signed_permutation(random);
    pair.pose_b.R = signed_permutation(random);
    pair.pose_b.t = offset;
    const auto corners = [&](const Vec3& half) {
        std::array<Vec3, 3> result;
        const int start = integer(random, 0, 7), axis = integer(random, 0, 2);
        // Two face neighbours of a corner: half a face of the box.
        const std::array<int, 3> bits{start, start ^ (1 << axis), start ^ (1 << (axis + 1) % 3)};
        for (std::size_t i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) result[i][k] = (bits[i] >> k & 1) != 0 ? half[k] : -half[k];
        }
        return result;
    };
    pair.a = corners(half_a);
    pair.b = corners(half_b);
    for (Vec3& v : pair.a) v = pair.pose_a.R.transpose() * v;
    for (Vec3& v : pair.b) v = pair.pose_b.R.transpose() * v;
    return pair;
}

PosedPair short_coordinates(Random& random) {
    const double unit = std::ldexp(1.0, integer(random, -20, 20));
    PosedPair pair;
    pair.a = to_vecs(integer_triangle(random, 3), unit);
    pair.b = to_vecs(integer_triangle(random, 3), unit);
    for (int k = 0; k < 3; ++k) {
        pair.pose_a.t[k] = integer(random, -1000, 1000) * unit;
        pair.pose_b.t[k] = pair.pose_a.t[k] + integer(random, -3, 3) * unit;
    }
    return pair;
}

PosedPair far_from_origin(Random& random) {
    PosedPair pair = lattice(random);
    double distance = 1;
    for (int i = integer(random, 0, 12); i > 0; --i) distance *= 10;
    for (int k = 0; k < 3; ++k) pair.pose_a.t[k] = pair.pose_b.t[k] = full(random, -1, 1) * distance;
    if (coin(random)) nudge_one(pair, random);
    return pair;
}

// Each triangle has its third corner a small fraction beside the edge of the other two.
PosedPair slivers(Random& random) {
    PosedPair pair = lattice(random);
    for (auto* t : {&pair.a, &pair.b}) {
        const double thickness = std::ldexp(1.0, -integer(random, 0, 40));
        (*t)[2] = 0.5 * ((*t)[0] + (*t)[1]) + thickness * ((*t)[2] - (*t)[0]);
    }
    if (coin(random)) pair.b[0] = pair.a[2];
    return pair;
}

PosedPair wide_exponents(Random& random) {
    PosedPair pair = lattice(random);
    const bool both = coin(random);
    for (int i = 0; i < 9; ++i) {
        if (random.below(4) != 0) continue;
        const double x = full(random, -1, 1);
        pair.pose_a.R.data()[i] = std::ldexp(x, -integer(random, 0, both ? 200 : 60));
    }
    pair.pose_b.R = pair.pose_a.R;
    if (coin(random)) {
        for (auto* t : {&pair.a, &pair.b}) {
            for (Vec3& corner : *t) {
                for (int k = 0; k < 3; ++k) {
                    if (random.below(8) != 0) continue;
                    const double x = full(random, -1, 1);
                    corner[k] = std::ldexp(x, -integer(random, 0, 300));
                }
            }
        }
    }
    return pair;
}

PosedPair scaled(Random& random, int exponent_min, int exponent_max) {
    PosedPair pair = lattice(random);
    const double scale = std::ldexp(1.0, integer(random, exponent_min, exponent_max));
    pair.pose_a.t.setZero();
    pair.pose_b.t.setZero();
    for (auto* t : {&pair.a, &pair.b}) {
        for (Vec3& corner : *t) corner *= scale;
    }
    if (coin(random)) nudge_one(pair, random);
    return pair;
}

PosedPair singular(Random& random) {
    PosedPair pair = lattice(random);
    for (Pose* pose : {&pair.pose_a, &pair.pose_b}) {
        make_singular(*pose, random);
        if (coin(random)) pair.pose_b = pair.pose_a;
    }
    return pair;
}

PosedPair degenerate(Random& random) {
    const int size = integer(random, 0, 2);
    PosedPair pair;
    for (auto* t : {&pair.a, &pair.b}) {
        for (Vec3& corner : *t) {
            for (int k = 0; k < 3; ++k) corner[k] = integer(random, -size, size);
        }
        switch (random.below(4)) {
            case 0:
                (*t)[2] = (*t)[0];
                break;
            case 1:
                (*t)[2] = 2 * (*t)[1] - (*t)[0];
                break;
            default:
                break;
        }
    }
    if (coin(random)) pair.pose_a = random_pose(random);
    pair.pose_b = pair.pose_a;
    return pair;
}

}  // namespace ecods::scenes::hard
