#include "fuzz/shrink/simpler.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace ecods::fuzz {
namespace {

void for_each_part(Script& script, const std::function<void(Part&)>& act) {
    for (Call& call : script) {
        if (auto* create = std::get_if<Create>(&call)) act(create->part);
        if (auto* shape = std::get_if<SetShape>(&call)) act(shape->part);
    }
}

// Bits from the first to the last that is set.
int digits(double x) {
    if (x == 0) return 0;
    int exponent = 0;
    const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::abs(std::frexp(x, &exponent)), 53));
    return 53 - std::countr_zero(mantissa);
}

double leading_bits(double x, int count) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return std::ldexp(std::round(std::ldexp(mantissa, count)), exponent - count);
}

}  // namespace

double rounder(double x, int roundness) {
    constexpr std::array<int, roundness_count> bits = {0, 0, 1, 4, 10, 26};
    const double y = roundness == 0   ? 0.0
                     : roundness == 1 ? std::round(x)
                                      : leading_bits(x, bits[static_cast<std::size_t>(roundness)]);
    // Plus zero is rounder than minus zero.
    return std::isfinite(y) && digits(y) < digits(x) ? y + 0.0 : x;
}

void for_each_pose(Script& script, const std::function<void(Pose&)>& act) {
    for (Call& call : script) {
        if (auto* create = std::get_if<Create>(&call)) act(create->pose);
        if (auto* move = std::get_if<SetPose>(&call)) act(move->pose);
        if (auto* moves = std::get_if<SetPoses>(&call)) std::ranges::for_each(moves->poses, act);
    }
}

void for_each_number(Script& script, const std::function<void(double&)>& act) {
    for_each_pose(script, [&](Pose& pose) {
        if (!pose.R.isIdentity(0)) std::ranges::for_each(pose.R.reshaped(), act);
        std::ranges::for_each(pose.t, act);
    });
    for (const auto& mesh : meshes_of(script)) {
        std::vector<Vec3> vertices(mesh->vertices().begin(), mesh->vertices().end());
        for (Vec3& vertex : vertices) std::ranges::for_each(vertex, act);
        if (std::ranges::equal(vertices, mesh->vertices())) continue;
        const auto triangles = mesh->triangles();
        replace_mesh(script, mesh.get(), Mesh::create(std::move(vertices), {triangles.begin(), triangles.end()}));
    }
}

std::vector<std::shared_ptr<const Mesh>> meshes_of(const Script& script) {
    std::vector<std::shared_ptr<const Mesh>> meshes;
    Script copy = script;
    for_each_part(copy, [&](Part& part) {
        if (std::ranges::find(meshes, part.mesh) == meshes.end()) meshes.push_back(part.mesh);
    });
    return meshes;
}

void replace_mesh(Script& script, const Mesh* old, const std::shared_ptr<const Mesh>& mesh) {
    for_each_part(script, [&](Part& part) {
        if (part.mesh.get() == old) part.mesh = mesh;
    });
}

std::shared_ptr<const Mesh> without_triangles(const Mesh& mesh, std::size_t begin, std::size_t count) {
    std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
    const std::size_t end = std::min(begin + count, triangles.size());
    triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(begin),
                    triangles.begin() + static_cast<std::ptrdiff_t>(end));
    if (triangles.empty()) return nullptr;
    std::map<std::uint32_t, std::uint32_t> kept;  // old index to new
    std::vector<Vec3> vertices;
    for (Triangle& triangle : triangles) {
        for (std::uint32_t& corner : triangle) {
            const auto [place, is_new] = kept.emplace(corner, static_cast<std::uint32_t>(vertices.size()));
            if (is_new) vertices.push_back(mesh.vertices()[corner]);
            corner = place->second;
        }
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

}  // namespace ecods::fuzz
