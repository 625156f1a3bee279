#include "scenes/engine_motion.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ecods::scenes {

namespace {

// Sizes and places in the model's millimetres, found by fitting circles to the vertices of its bearings. The crankshaft
// turns about the z axis, the camshaft about the parallel to it through (0, -100); pistons move along x.
constexpr double rod_length = 139;
constexpr double pin_x_at_rest = 27.61788;  // of the crank pin on the right; the other is opposite
constexpr double pin_y_at_rest = 23.09221;
const Vec3 cam_axis(0, -100, 0);

// The turn of one step. The crank's step is the cam's, twice.
constexpr double cos_5_degrees = 0.99619469809174555;
constexpr double sin_5_degrees = 0.08715574274765817;

// A turn about z: the complex number of norm 1.
struct Turn {
    double cos = 1;
    double sin = 0;
};

// Divided by the norm, so that errors do not add up over many steps.
Turn compose(const Turn& a, const Turn& b) {
    const double cos = a.cos * b.cos - a.sin * b.sin;
    const double sin = a.sin * b.cos + a.cos * b.sin;
    const double norm = std::sqrt(cos * cos + sin * sin);
    return {cos / norm, sin / norm};
}

Turn inverse(const Turn& turn) {
    return {turn.cos, -turn.sin};
}

// The pose, turned about the parallel to z through `axis`, then moved. Entry by entry, for the same bits everywhere.
Pose turned(const Pose& pose, const Turn& turn, const Vec3& axis, const Vec3& shift) {
    Pose result = pose;
    for (int column = 0; column < 3; ++column) {
        result.R(0, column) = turn.cos * pose.R(0, column) - turn.sin * pose.R(1, column);
        result.R(1, column) = turn.sin * pose.R(0, column) + turn.cos * pose.R(1, column);
    }
    const Vec3 arm = pose.t - axis;
    result.t.x() = (turn.cos * arm.x() - turn.sin * arm.y()) + axis.x() + shift.x();
    result.t.y() = (turn.sin * arm.x() + turn.cos * arm.y()) + axis.y() + shift.y();
    result.t.z() = pose.t.z() + shift.z();
    return result;
}

// The bodies whose mesh has this name, and of which the centre of the box lies at x * side > 0 (any, for side 0).
std::size_t find_part(const Scene& engine, std::string_view mesh_name, double side) {
    for (std::size_t i = 0; i < engine.bodies.size(); ++i) {
        const SceneBody& body = engine.bodies[i];
        const NamedMesh& named = engine.meshes[body.mesh_index];
        if (named.name.find(mesh_name) == std::string::npos) continue;
        if (side == 0) return i;
        double min = INFINITY, max = -INFINITY;
        for (const Vec3& v : named.mesh->vertices()) {
            const double x = body.pose.R.row(0).dot(v) + body.pose.t.x();
            min = std::min(min, x);
            max = std::max(max, x);
        }
        if ((min + max) * side > 0) return i;
    }
    throw std::runtime_error("the engine has no part '" + std::string(mesh_name) + "'");
}

// Rod, piston and pin of one side: 1 is that of positive x.
struct Cylinder {
    double side;
    std::size_t rod, piston, pin;
};

// Where the rod points (from the crank pin), and where its far end is, when the crank pin is at (x, y) on the right
// side.
struct Stroke {
    Turn rod;
    double piston_x;
};

Stroke stroke_at(double x, double y) {
    const double sin = -y / rod_length;
    const double cos = std::sqrt(1 - sin * sin);
    return {{cos, sin}, x + rod_length * cos};
}

void move_cylinder(const Scene& engine, const Cylinder& cylinder, const Turn& crank, Frame& frame) {
    // By symmetry the left side is the right side turned by half a turn: x and y of everything change sign.
    const double x = crank.cos * pin_x_at_rest - crank.sin * pin_y_at_rest;
    const double y = crank.sin * pin_x_at_rest + crank.cos * pin_y_at_rest;
    const Stroke rest = stroke_at(pin_x_at_rest, pin_y_at_rest);
    const Stroke now = stroke_at(x, y);

    const Vec3 slide(cylinder.side * (now.piston_x - rest.piston_x), 0, 0);
    for (const std::size_t part : {cylinder.piston, cylinder.pin})
        frame.moves.push_back({part, turned(engine.bodies[part].pose, {}, Vec3::Zero(), slide)});

    const Vec3 pin_at_rest(cylinder.side * pin_x_at_rest, cylinder.side * pin_y_at_rest, 0);
    const Vec3 pin_shift(cylinder.side * (x - pin_x_at_rest), cylinder.side * (y - pin_y_at_rest), 0);
    const Turn swing = compose(now.rod, inverse(rest.rod));
    frame.moves.push_back({cylinder.rod, turned(engine.bodies[cylinder.rod].pose, swing, pin_at_rest, pin_shift)});
}

}  // namespace

std::filesystem::path engine_file() {
    return "/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb";
}

void run_engine(Scene& engine, std::size_t frame_count) {
    const std::vector<std::size_t> crank_parts = {find_part(engine, "body_22", 0), find_part(engine, "body_23", 0)};
    const std::vector<std::size_t> cam_parts = {find_part(engine, "body_20", 0), find_part(engine, "body_21", 0)};
    std::vector<Cylinder> cylinders;
    for (const double side : {1.0, -1.0})
        cylinders.push_back({side, find_part(engine, "rod_123", side), find_part(engine, "Piston_123", side),
                             find_part(engine, "body_24", side)});

    const Turn step{cos_5_degrees, sin_5_degrees};
    Turn cam, crank;
    engine.frames.clear();
    for (std::size_t f = 0; f < frame_count; ++f) {
        cam = compose(cam, inverse(step));
        crank = compose(crank, compose(step, step));
        Frame& frame = engine.frames.emplace_back();
        for (const std::size_t part : crank_parts)
            frame.moves.push_back({part, turned(engine.bodies[part].pose, crank, Vec3::Zero(), Vec3::Zero())});
        for (const std::size_t part : cam_parts)
            frame.moves.push_back({part, turned(engine.bodies[part].pose, cam, cam_axis, Vec3::Zero())});
        for (const Cylinder& cylinder : cylinders) move_cylinder(engine, cylinder, crank, frame);
    }
}

}  // namespace ecods::scenes
