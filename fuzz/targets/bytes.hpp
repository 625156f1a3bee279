// Input of a fuzzer as numbers, poses and meshes. Everything is finite and valid; when bytes run out, zeros follow.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods::fuzz {

class Bytes {
  public:
    Bytes(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}

    bool empty() const { return at_ == end_; }
    std::uint8_t byte() { return empty() ? std::uint8_t{0} : *at_++; }
    std::uint32_t below(std::uint32_t count) { return byte() % count; }
    std::int8_t signed_byte() { return static_cast<std::int8_t>(byte()); }

    // Mostly small numbers, those used before, and their neighbours: what meets exactly, or just not.
    double number() {
        double x = 0;
        switch (below(8)) {
            case 0:
                x = known_[below(8)];
                break;
            case 1:
                x = std::nextafter(known_[below(8)], below(2) == 0 ? infinity : -infinity);
                break;
            case 2:
                x = -known_[below(8)];
                break;
            case 3:
                x = std::ldexp(signed_byte(), 8 * signed_byte());
                break;
            case 4:
                x = 0.1 * signed_byte();
                break;
            case 5: {
                std::uint64_t bits = 0;
                for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
                x = std::bit_cast<double>(bits);
                break;
            }
            default:
                x = 0.5 * (static_cast<int>(below(9)) - 4);
                break;
        }
        if (!std::isfinite(x)) x = 1;
        known_[count_++ % 8] = x;
        return x;
    }

    Vec3 point() {
        Vec3 p;
        for (double& x : p) x = number();
        return p;
    }

    // Signed permutations, what was used before, small integers, anything.
    Pose pose() {
        Pose pose;
        switch (below(4)) {
            case 0:
                pose.R = last_matrix_;
                break;
            case 1: {
                const std::uint32_t code = below(48);
                const std::array<int, 3> columns[6] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                                       {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
                pose.R.setZero();
                for (int row = 0; row < 3; ++row) {
                    pose.R(row, columns[code % 6][static_cast<std::size_t>(row)]) = (code / 6) >> row & 1 ? -1 : 1;
                }
                break;
            }
            case 2:
                for (double& x : pose.R.reshaped()) x = static_cast<int>(below(5)) - 2;
                break;
            default:
                for (double& x : pose.R.reshaped()) x = number();
                break;
        }
        last_matrix_ = pose.R;
        pose.t = point();
        return pose;
    }

    std::shared_ptr<const Mesh> mesh(std::uint32_t vertices_max, std::uint32_t triangles_max) {
        std::vector<Vec3> vertices(1 + below(vertices_max));
        for (Vec3& v : vertices) v = point();
        std::vector<Triangle> triangles(1 + below(triangles_max));
        for (Triangle& t : triangles) {
            for (std::uint32_t& index : t) index = below(static_cast<std::uint32_t>(vertices.size()));
        }
        return Mesh::create(std::move(vertices), std::move(triangles));
    }

  private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    const std::uint8_t* at_;
    const std::uint8_t* end_;
    std::array<double, 8> known_{};
    std::size_t count_ = 0;
    Mat3 last_matrix_ = Mat3::Identity();
};

}  // namespace ecods::fuzz
