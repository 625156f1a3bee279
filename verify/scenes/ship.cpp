#include "scenes/ship.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scenes/mesh_builder.hpp"

namespace ecods::scenes {

namespace {

struct Station {
    double x;
    double radius;
};

// An ellipse across the x axis, counter-clockwise when seen from the nose.
std::vector<Vec3> ellipse(int corner_count, const Station& station, const Vec3& centre, double flatness) {
    std::vector<Vec3> points;
    for (int i = 0; i < corner_count; ++i) {
        const double angle = 2 * std::numbers::pi * i / corner_count;
        points.push_back(
            centre + Vec3(station.x, station.radius * std::cos(angle), flatness * station.radius * std::sin(angle)));
    }
    return points;
}

// The mirror image of a loop about the xz plane, turned round so that it is still counter-clockwise.
std::vector<Vec3> on_side(std::vector<Vec3> points, double side) {
    if (side > 0) return points;
    for (Vec3& point : points) point.y() = -point.y();
    std::reverse(points.begin(), points.end());
    return points;
}

void add_hull(MeshBuilder& mesh) {
    constexpr std::array<Station, 10> stations = {{{-0.95, 0.105},
                                                   {-0.80, 0.160},
                                                   {-0.55, 0.205},
                                                   {-0.30, 0.225},
                                                   {-0.05, 0.225},
                                                   {0.20, 0.205},
                                                   {0.45, 0.170},
                                                   {0.65, 0.125},
                                                   {0.82, 0.080},
                                                   {0.94, 0.040}}};
    Ring last;
    for (std::size_t i = 0; i < stations.size(); ++i) {
        const std::vector<Vec3> points = ellipse(10, stations[i], Vec3::Zero(), 0.7);
        Ring ring = mesh.add_ring(points);
        if (i == 0) {
            mesh.fan_from(mesh.add({-0.85, 0, 0}), ring);
        } else {
            mesh.bridge(last, ring);
        }
        // Every second station is a seam between plates.
        if (i % 2 == 1) ring = mesh.add_ring(points);
        last = ring;
    }
    mesh.fan_to(last, mesh.add({1, 0, 0}));
}

void add_wing(MeshBuilder& mesh, double side) {
    struct Section {
        double y, z, leading, trailing, thickness;
    };
    constexpr std::array<Section, 5> sections = {{{0.12, 0.00, 0.36, -0.62, 0.070},
                                                  {0.34, -0.01, 0.02, -0.64, 0.050},
                                                  {0.58, -0.03, -0.26, -0.68, 0.036},
                                                  {0.82, -0.06, -0.48, -0.74, 0.024},
                                                  {1.00, -0.10, -0.62, -0.88, 0.010}}};
    Ring last;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const Section& s = sections[i];
        const double thickest = s.leading + 0.35 * (s.trailing - s.leading);
        // Counter-clockwise when seen from the tip.
        const std::vector<Vec3> points = on_side({{s.leading, s.y, s.z},
                                                  {thickest, s.y, s.z - s.thickness},
                                                  {s.trailing, s.y, s.z},
                                                  {thickest, s.y, s.z + s.thickness}},
                                                 side);
        Ring ring = mesh.add_ring(points);
        if (i == 0) {
            mesh.add_quad(ring[3], ring[2], ring[1], ring[0]);
        } else {
            mesh.bridge(last, ring);
        }
        if (i == 2) ring = mesh.add_ring(points);
        last = ring;
    }
    mesh.add_quad(last[0], last[1], last[2], last[3]);
}

void add_fin(MeshBuilder& mesh, double side) {
    const auto section = [](double front, double back, double y, double z, double half_thickness) {
        return std::vector<Vec3>{{front, y - half_thickness, z},
                                 {front, y + half_thickness, z},
                                 {back, y + half_thickness, z},
                                 {back, y - half_thickness, z}};
    };
    const Ring root = mesh.add_ring(on_side(section(-0.48, -0.90, 0.09, 0.06, 0.014), side));
    const Ring tip = mesh.add_ring(on_side(section(-0.84, -1.00, 0.24, 0.46, 0.006), side));
    mesh.add_quad(root[3], root[2], root[1], root[0]);
    mesh.bridge(root, tip);
    mesh.add_quad(tip[0], tip[1], tip[2], tip[3]);
}

void add_engine(MeshBuilder& mesh, double side) {
    const Vec3 centre(0, 0.33, -0.04);
    const Ring nozzle = mesh.add_ring(on_side(ellipse(8, {-0.96, 0.072}, centre, 1), side));
    const Ring body = mesh.add_ring(on_side(ellipse(8, {-0.84, 0.098}, centre, 1), side));
    const Ring intake = mesh.add_ring(on_side(ellipse(8, {-0.38, 0.082}, centre, 1), side));
    mesh.fan_from(mesh.add({-0.82, side * centre.y(), centre.z()}), nozzle);
    mesh.bridge(nozzle, body);
    mesh.bridge(body, intake);
    mesh.fan_to(intake, mesh.add({-0.22, side * centre.y(), centre.z()}));
}

void add_canopy(MeshBuilder& mesh) {
    const auto circle = [](double length, double width, double z) {
        std::vector<Vec3> points;
        for (int i = 0; i < 6; ++i) {
            const double angle = std::numbers::pi * i / 3;
            points.push_back({0.30 + length * std::cos(angle), width * std::sin(angle), z});
        }
        return points;
    };
    const Ring base = mesh.add_ring(circle(0.30, 0.120, 0.08));
    const Ring middle = mesh.add_ring(circle(0.19, 0.085, 0.18));
    mesh.bridge(base, middle);
    mesh.fan_to(middle, mesh.add({0.24, 0, 0.215}));
}

void add_cannon(MeshBuilder& mesh, double side) {
    const Vec3 centre(0, 0.60, -0.09);
    const Ring back = mesh.add_ring(on_side(ellipse(3, {-0.56, 0.034}, centre, 1), side));
    const Ring front = mesh.add_ring(on_side(ellipse(3, {0.02, 0.024}, centre, 1), side));
    mesh.bridge(back, front);
    mesh.fan_to(front, mesh.add({0.12, side * centre.y(), centre.z()}));
}

// Two blades with one foot.
void add_antenna(MeshBuilder& mesh) {
    const std::uint32_t foot = mesh.add({-0.12, 0, 0.14});
    for (const double side : {1.0, -1.0}) {
        const std::uint32_t front = mesh.add({-0.26, side * 0.07, 0.34});
        const std::uint32_t back = mesh.add({-0.34, side * 0.07, 0.34});
        mesh.triangles.push_back({foot, front, back});
    }
}

}  // namespace

std::shared_ptr<const Mesh> ship() {
    MeshBuilder mesh;
    add_hull(mesh);
    add_canopy(mesh);
    add_antenna(mesh);
    for (const double side : {1.0, -1.0}) {
        add_wing(mesh, side);
        add_fin(mesh, side);
        add_engine(mesh, side);
        add_cannon(mesh, side);
    }
    return mesh.finish();
}

// The outer ends of the wings are the farthest vertices, at 1.3359.
double ship_radius() {
    return 1.34;
}

}  // namespace ecods::scenes
