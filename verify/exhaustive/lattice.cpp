#include "exhaustive/lattice.hpp"

#include <algorithm>

namespace ecods::lattice {

std::array<int, 3> digits(int point) {
    return {point % 3, point / 3 % 3, point / 9};
}

Vec3 position(int point) {
    const auto d = digits(point);
    return {double(d[0]), double(d[1]), double(d[2])};
}

std::array<Vec3, 3> positions(const Corners& corners) {
    return {position(corners[0]), position(corners[1]), position(corners[2])};
}

std::vector<Corners> all_triangles() {
    std::vector<Corners> triangles;
    for (int a = 0; a < point_count; ++a) {
        for (int b = a; b < point_count; ++b) {
            for (int c = b; c < point_count; ++c) triangles.push_back({a, b, c});
        }
    }
    return triangles;
}

std::vector<Symmetry> all_symmetries() {
    std::vector<Symmetry> symmetries;
    std::array<std::size_t, 3> axes{0, 1, 2};
    do {
        for (int mirrored = 0; mirrored < 8; ++mirrored) {
            Symmetry symmetry{};
            for (int point = 0; point < point_count; ++point) {
                const auto d = digits(point);
                std::array<int, 3> image{};
                for (std::size_t k = 0; k < 3; ++k) {
                    image[k] = (mirrored >> k & 1) != 0 ? 2 - d[axes[k]] : d[axes[k]];
                }
                symmetry[static_cast<std::size_t>(point)] = image[0] + 3 * image[1] + 9 * image[2];
            }
            symmetries.push_back(symmetry);
        }
    } while (std::ranges::next_permutation(axes).found);
    return symmetries;
}

Corners apply(const Symmetry& symmetry, const Corners& corners) {
    Corners image{};
    for (std::size_t k = 0; k < 3; ++k) image[k] = symmetry[static_cast<std::size_t>(corners[k])];
    std::ranges::sort(image);
    return image;
}

}  // namespace ecods::lattice
