#include "scenes/hard_pair_parts.hpp"
#include "scenes/hard_pair_recipes.hpp"

namespace ecods::scenes::hard {
namespace {

// Corner b0 is in the interior of triangle a, b1 and b2 are strictly on its positive side.
struct FaceContact {
    IntTriangle a;
    IntTriangle b;
    Int3 normal;
};

FaceContact face_contact(Random& random, int size) {
    FaceContact c;
    c.a = integer_triangle(random, size);
    c.normal = cross(minus(c.a[1], c.a[0]), minus(c.a[2], c.a[0]));
    for (std::size_t k = 0; k < 3; ++k) c.b[0][k] = 2 * c.a[0][k] + c.a[1][k] + c.a[2][k];
    for (Int3& corner : c.a) {
        for (auto& x : corner) x *= 4;
    }
    do {
        for (std::size_t i = 1; i < 3; ++i) {
            do {
                for (std::size_t k = 0; k < 3; ++k) c.b[i][k] = c.b[0][k] + integer(random, -4 * size, 4 * size);
            } while (dot(c.normal, minus(c.b[i], c.b[0])) <= 0);
        }
    } while (cross(minus(c.b[1], c.b[0]), minus(c.b[2], c.b[0])) == Int3{});
    return c;
}

// Moves b0 by `steps` units in the last place along a local axis on which the normal, as seen from there, is not zero.
// The contact is an interior one, so the bodies then pass through each other, or are apart.
void step_contact(PosedPair& pair, const Int3& local_normal, int steps, Random& random) {
    pair.intersects = true;
    if (steps == 0) return;
    std::size_t axis = 0;
    do axis = random.below(3);
    while (local_normal[axis] == 0);
    const bool up = coin(random);
    double& x = pair.b[0][static_cast<Eigen::Index>(axis)];
    for (int i = 0; i < steps; ++i) {
        x = std::nextafter(x, up ? std::numeric_limits<double>::max() : std::numeric_limits<double>::lowest());
    }
    pair.intersects = (local_normal[axis] > 0) != up;
}

}  // namespace

// Products of a normal (38 bits) and a difference (20 bits) stay below 2^63.
PosedPair vertex_on_face(Random& random, int steps) {
    const FaceContact c = face_contact(random, 100000);
    PosedPair pair{random_pose(random), {}, to_vecs(c.a, 0x1p-40), to_vecs(c.b, 0x1p-40), {}};
    pair.pose_b = pair.pose_a;
    step_contact(pair, c.normal, steps, random);
    return pair;
}

namespace {

// The scaled rotation of an integer quaternion: rows are orthogonal, of length |q|^2.
struct IntegerRotation {
    std::array<Int3, 3> rows;
    std::int64_t norm;

    IntegerRotation(Random& random, int size) {
        std::int64_t w, x, y, z;
        do {
            w = integer(random, -size, size);
            x = integer(random, -size, size);
            y = integer(random, -size, size);
            z = integer(random, -size, size);
            norm = w * w + x * x + y * y + z * z;
        } while (norm == 0);
        rows = {Int3{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                Int3{2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                Int3{2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
    }
    Mat3 matrix() const {
        Mat3 R;
        for (std::size_t i = 0; i < 3; ++i) R.row(static_cast<Eigen::Index>(i)) = to_vec(rows[i]).transpose();
        return R;
    }
    // M^T p, by which M undoes it times norm^2.
    Int3 undo(const Int3& p) const {
        Int3 result;
        for (std::size_t j = 0; j < 3; ++j) result[j] = rows[0][j] * p[0] + rows[1][j] * p[1] + rows[2][j] * p[2];
        return result;
    }
};

Int3 times(const Int3& p, std::int64_t factor) {
    return {p[0] * factor, p[1] * factor, p[2] * factor};
}

// The same real configuration, each body modelled in a frame of its own: R_a v_a = N_a^2 N_b^2 p for both.
PosedPair in_integer_frames(const IntTriangle& a, const IntTriangle& b, int size, double scale, Random& random,
                            Int3* normal) {
    const IntegerRotation ra(random, size), rb(random, size);
    PosedPair pair;
    pair.pose_a.R = ra.matrix();
    pair.pose_b.R = rb.matrix();
    for (std::size_t i = 0; i < 3; ++i) {
        pair.a[i] = to_vec(times(ra.undo(a[i]), rb.norm * rb.norm), scale);
        pair.b[i] = to_vec(times(rb.undo(b[i]), ra.norm * ra.norm), scale);
    }
    if (normal != nullptr) *normal = rb.undo(*normal);
    return pair;
}

}  // namespace

PosedPair integer_rotations(Random& random) {
    const double scale = std::ldexp(1.0, -integer(random, 0, 40));
    const IntTriangle a = integer_triangle(random, 2);
    const IntTriangle b = integer_triangle(random, 2);
    PosedPair pair = in_integer_frames(a, b, 5, scale, random, nullptr);
    if (coin(random)) {
        for (int k = 0; k < 3; ++k) pair.pose_a.t[k] = pair.pose_b.t[k] = integer(random, -1000, 1000) * scale;
    }
    return pair;
}

// Numbers stay below 2^53: 2^15 for the contact, 3 * 16 for a rotation, 16^2 for the other's norm squared.
PosedPair vertex_on_face_integer(Random& random, int steps) {
    FaceContact c = face_contact(random, 1000);
    PosedPair pair = in_integer_frames(c.a, c.b, 2, 1, random, &c.normal);
    step_contact(pair, c.normal, steps, random);
    return pair;
}

}  // namespace ecods::scenes::hard
