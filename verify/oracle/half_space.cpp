#include "oracle/half_space.hpp"

#include <stdexcept>
#include <utility>

#include "oracle/vector.hpp"

namespace ecods::oracle {
namespace {

using Numbers = Vector<mpq_class>;

// Solves A x = b by elimination.
Numbers solve(std::array<Numbers, 3> A, Numbers b) {
    for (std::size_t k = 0; k < 3; ++k) {
        std::size_t pivot = k;
        while (pivot < 3 && sgn(A[pivot][k]) == 0) ++pivot;
        if (pivot == 3) throw std::logic_error("the matrix of a half space's pose is singular");
        std::swap(A[k], A[pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t row = 0; row < 3; ++row) {
            if (row == k) continue;
            const mpq_class factor = A[row][k] / A[k][k];
            for (std::size_t j = 0; j < 3; ++j) A[row][j] -= factor * A[k][j];
            b[row] -= factor * b[k];
        }
    }
    return {b[0] / A[0][0], b[1] / A[1][1], b[2] / A[2][2]};
}

Numbers numbers(const Vec3& v) {
    return {mpq_class(v[0]), mpq_class(v[1]), mpq_class(v[2])};
}

template <class Visit>
void each_corner(const Mesh& mesh, const Visit& visit) {
    for (std::uint32_t triangle = 0; triangle < mesh.triangles().size(); ++triangle) {
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            visit(triangle, corner, mesh.triangles()[triangle][corner]);
        }
    }
}

}  // namespace

ExactHeights::ExactHeights(const HalfSpaceSet& set) {
    std::array<Numbers, 3> transposed;
    for (int row = 0; row < 3; ++row) transposed[static_cast<std::size_t>(row)] = numbers(set.pose.R.col(row));
    direction_ = solve(transposed, numbers(set.normal));
    at_origin_ = -dot(direction_, numbers(set.pose.t)) - mpq_class(set.offset);
}

mpq_class ExactHeights::at(const Numbers& x) const {
    return dot(direction_, x) + at_origin_;
}

mpq_class ExactHeights::at(const Vec3& v, const Pose& pose) const {
    return at(exact_posed(v, pose));
}

mpq_class ExactHeights::rise(const Vec3& step) const {
    return dot(direction_, numbers(step));
}

ExactRoot ExactHeights::distance(const mpq_class& height) const {
    const mpq_class square = height * height / dot(direction_, direction_);
    return {square.get_num(), square.get_den(), 0};
}

ExactRoot ExactHeights::share(int axis) const {
    const mpq_class& g = direction_[static_cast<std::size_t>(axis)];
    const mpq_class square = g * g / dot(direction_, direction_);
    return {square.get_num(), square.get_den(), 0};
}

ExactPoint ExactHeights::foot(const Vec3& v, const Pose& pose) const {
    Numbers x = exact_posed(v, pose);
    const mpq_class steps = at(x) / dot(direction_, direction_);
    for (std::size_t k = 0; k < 3; ++k) x[k] -= steps * direction_[k];
    return exact_point(x);
}

Numbers exact_posed(const Vec3& v, const Pose& pose) {
    Numbers x;
    for (int k = 0; k < 3; ++k) {
        x[static_cast<std::size_t>(k)] = dot(numbers(pose.R.row(k)), numbers(v)) + mpq_class(pose.t[k]);
    }
    return x;
}

ExactPoint exact_point(const Numbers& x) {
    ExactPoint point;
    for (std::size_t k = 0; k < 3; ++k) point.x[k] = {x[k].get_num(), x[k].get_den(), 0};
    return point;
}

LowestCorner lowest_corner(const ExactHeights& heights, const Mesh& mesh, const Pose& pose) {
    std::optional<LowestCorner> lowest;
    each_corner(mesh, [&](std::uint32_t triangle, std::uint32_t corner, std::uint32_t vertex) {
        mpq_class height = heights.at(mesh.vertices()[vertex], pose);
        if (!lowest || height < lowest->height) lowest = LowestCorner{std::move(height), triangle, corner, vertex};
    });
    return *lowest;
}

mpq_class greatest_height(const ExactHeights& heights, const Mesh& mesh, const Pose& pose) {
    std::optional<mpq_class> greatest;
    each_corner(mesh, [&](std::uint32_t, std::uint32_t, std::uint32_t vertex) {
        const mpq_class height = heights.at(mesh.vertices()[vertex], pose);
        if (!greatest || height > *greatest) greatest = height;
    });
    return *greatest;
}

std::optional<FirstCorner> first_corner(const HalfSpaceSet& set, const Vec3& end, const Mesh& mesh, const Pose& from,
                                        const Pose& to) {
    HalfSpaceSet later = set;
    later.pose.t = end;
    const ExactHeights start(set), stop(later);
    std::optional<FirstCorner> first;
    each_corner(mesh, [&](std::uint32_t triangle, std::uint32_t corner, std::uint32_t vertex) {
        const Vec3& v = mesh.vertices()[vertex];
        const mpq_class h0 = start.at(v, from), h1 = stop.at(v, to);
        if (sgn(h1) > 0) return;
        mpq_class time = h0 / (h0 - h1);
        if (!first || time < first->time) first = FirstCorner{std::move(time), triangle, corner};
    });
    return first;
}

}  // namespace ecods::oracle
