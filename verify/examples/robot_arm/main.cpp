// A robot's arm on its way: how near does it come to what stands around, and does it hit anything between two samples?
// Balls, cylinders and boxes are polytopes here, so that every number is that of the shapes as given.
//
// usage: ecods_robot_arm [PICTURE.pov]
#include <fmt/core.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ecods/world.hpp"
#include "examples/stage.hpp"

namespace {

using namespace ecods;
using SolidPtr = std::shared_ptr<const ConvexSolid>;
constexpr double pi = 3.14159265358979324;

// Along z, from 0 to `length`.
SolidPtr prism(int side_count, double radius, double length) {
    std::vector<Vec3> points;
    for (int i = 0; i < side_count; ++i) {
        const double angle = (2 * i + 1) * pi / side_count;
        for (const double z : {0.0, length}) points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    return std::make_shared<ConvexSolid>(points);
}

constexpr std::array<double, 3> lengths{1.0, 0.8, 0.5};
constexpr int step_count = 20;

// Where the links are at a time from 0 to 1: each turns about its own joint, the first one about the vertical, too.
std::array<Pose, 3> arm_at(double time) {
    const std::array<double, 3> bends{0.35 + 0.25 * time, 0.5 + 0.7 * time, 0.6 - 0.4 * time};
    Eigen::Isometry3d joint = Eigen::Isometry3d::Identity();
    joint.translate(Vec3(0, 0, 0.3)).rotate(Eigen::AngleAxisd(1.2 * (2 * time - 1), Vec3::UnitZ()));
    std::array<Pose, 3> poses;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        joint.rotate(Eigen::AngleAxisd(bends[i], Vec3::UnitY()));
        poses[i] = Pose::from_isometry(joint);
        joint.translate(Vec3(0, 0, lengths[i]));
    }
    return poses;
}

struct Cell {
    World world;
    std::array<BodyId, 3> links;
    std::map<BodyId, std::string> names;

    BodyId add(const std::string& name, const SolidPtr& shape, const Pose& pose, const CollisionFilter& filter) {
        const BodyId body = world.create_body({.shape = shape, .pose = pose, .filter = filter});
        names[body] = name;
        return body;
    }
};

// What is in group 1 stands still, and meets the arm alone, which is in group 2 and does not meet itself.
Cell make_cell() {
    Cell cell;
    const CollisionFilter still{.groups = 1, .mask = 2}, arm{.groups = 2, .mask = 1};
    for (std::size_t i = 0; i < lengths.size(); ++i)
        cell.links[i] = cell.add(fmt::format("link {}", i + 1), prism(8, 0.1, lengths[i]), arm_at(0)[i], arm);
    cell.add("post", prism(16, 0.12, 0.75), {.t = {1.125, 1.25, 0}}, still);
    cell.add("bin", prism(4, 0.45, 0.35), {.t = {1.35, -0.15, 0}}, still);
    return cell;
}

}  // namespace

int main(int argc, char** argv) {
    Cell cell = make_cell();
    examples::Stage stage({4.2, -3.4, 2.6}, {0.6, 0.1, 0.6}, 38);
    std::vector<Meeting> meetings;
    PairDistance nearest{{}, World::no_limit};
    for (int step = 0; step <= step_count; ++step) {
        const std::array<Pose, 3> poses = arm_at(static_cast<double>(step) / step_count);
        // Each point goes straight from its old place to its new one, so that small things are not jumped over. The arc
        // of a turning link is approximated by that; shorter steps are nearer to it.
        for (const Meeting& meeting : cell.world.meetings(cell.links, poses)) {
            fmt::print("  on the way to step {}: {} meets {} at {:.4f} of it\n", step, cell.names[meeting.bodies.a],
                       cell.names[meeting.bodies.b], meeting.contact.time);
            meetings.push_back(meeting);
        }
        cell.world.set_poses(cell.links, poses);
        // All pairs of convex solids within 0.3.
        const std::vector<PairDistance> distances = cell.world.signed_distances(0.3);
        for (const PairDistance& each : distances) {
            fmt::print("step {:2}: {} and {}: {:.6f}\n", step, cell.names[each.bodies.a], cell.names[each.bodies.b],
                       each.distance);
            if (each.distance < nearest.distance) {
                nearest = each;
                if (argc > 1) {
                    const ClosestPoints points = cell.world.closest(each.bodies.a, each.bodies.b);
                    stage.add_segment(points.point_a, points.point_b, 0.008, examples::red);
                }
            }
        }
        const auto paint = examples::glassy(examples::blue, step % 5 == 0 ? 0.0 : 0.9);
        for (const BodyId link : cell.links)
            stage.add(static_cast<const MeshShape&>(*cell.world.shape(link)).mesh(), cell.world.pose(link), paint);
    }
    fmt::print("Nearest: {} and {}, {:.6f}. ", cell.names[nearest.bodies.a], cell.names[nearest.bodies.b],
               nearest.distance);
    fmt::print("{} contacts on the way.\n", meetings.size());
    if (argc > 1) {
        for (const auto& [body, name] : cell.names)
            if (name == "post" || name == "bin")
                stage.add(static_cast<const MeshShape&>(*cell.world.shape(body)).mesh(), cell.world.pose(body),
                          examples::amber);
        stage.write(argv[1]);
    }
}
