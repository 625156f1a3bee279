// An arm of six joints goes its way joint by joint. Each joint is a turn, and the links behind it turn with it,
// rigidly. Casts find what each link meets first, and at which angle; looking every five degrees misses a thin post.
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ecods/builders.hpp"
#include "ecods/intersection.hpp"
#include "ecods/turn.hpp"

namespace {

using namespace ecods;
using SolidPtr = std::shared_ptr<const ConvexSolid>;

double radians(double degrees) {
    return degrees / 180 * std::numbers::pi;
}

// A box from one corner to the other.
SolidPtr block(const Vec3& min, const Vec3& max) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1 ? max : min).x(), (i & 2 ? max : min).y(), (i & 4 ? max : min).z());
    }
    return std::make_shared<const ConvexSolid>(corners);
}

struct Obstacle {
    std::string name;
    SolidPtr solid;
};

// Links behind each other, each with the joint in front of it. All is given as it is while no joint is turned.
class Chain {
  public:
    void add(const SolidPtr& link, const Vec3& axis, const Vec3& place) {
        links_.push_back({link, axis, place, Pose()});
    }

    std::size_t size() const { return links_.size(); }
    Posed<MeshShape> link(std::size_t i) const { return Posed<ConvexSolid>(links_[i].solid, links_[i].pose); }

    // The joint's axis and place go with its link, which turns about them, and so with all links before.
    Turn turn(std::size_t joint, double degrees) const {
        const Link& at = links_[joint];
        return about(at.pose.R * at.axis, radians(degrees), at.pose.R * at.place + at.pose.t);
    }

    // Turns the links behind the joint. Each pose is rounded, by about 1e-16 of the arm.
    void apply(std::size_t joint, const Turn& turn) {
        for (std::size_t i = joint; i < links_.size(); ++i) links_[i].pose = pose_at(links_[i].pose, turn, 1);
    }

  private:
    struct Link {
        SolidPtr solid;
        Vec3 axis, place;
        Pose pose;
    };
    std::vector<Link> links_;
};

Chain make_arm() {
    const Vec3 along = Vec3::UnitX(), across = Vec3::UnitY(), up = Vec3::UnitZ();
    Chain arm;
    arm.add(block({-0.08, -0.08, 0.02}, {0.08, 0.08, 0.42}), up, {0, 0, 0});
    arm.add(block({-0.05, -0.05, 0.45}, {0.55, 0.05, 0.55}), across, {0, 0, 0.5});
    arm.add(block({0.57, -0.04, 0.46}, {0.94, 0.04, 0.54}), across, {0.56, 0, 0.5});
    arm.add(block({0.95, -0.03, 0.47}, {1.04, 0.03, 0.53}), along, {0.945, 0, 0.5});
    arm.add(block({1.05, -0.03, 0.47}, {1.14, 0.03, 0.53}), across, {1.045, 0, 0.5});
    arm.add(block({1.15, -0.01, 0.45}, {1.35, 0.01, 0.55}), along, {1.145, 0, 0.5});
    return arm;
}

std::vector<Obstacle> make_obstacles() {
    return {{"the floor", block({-2, -2, -0.1}, {2, 2, 0})},
            {"the shelf", block({-0.4, 0.7, 0.85}, {0.4, 1.2, 0.9})},
            {"the thin post", block({0.879, 0.959, 0}, {0.881, 0.961, 1.5})}};
}

struct Step {
    std::size_t joint;  // from 0 on
    double degrees;
};

// A Found names what a link meets first as a joint turns.
struct Found {
    std::size_t link = 0;
    const Obstacle* obstacle = nullptr;
    double angle = 0;  // in degrees
};

// The joint stands still for the links before it, which are not asked about.
std::optional<Found> first_found(const Chain& arm, const Step& step, const std::vector<Obstacle>& obstacles) {
    const Turn turn = arm.turn(step.joint, step.degrees);
    std::optional<Found> first;
    double limit = 1;
    for (std::size_t i = step.joint; i < arm.size(); ++i) {
        const Posed<MeshShape> link = arm.link(i);
        for (const Obstacle& obstacle : obstacles) {
            const Posed<MeshShape> other = Posed<ConvexSolid>(obstacle.solid, Pose());
            const auto contact = cast(Turning<MeshShape>(*link.what, link.pose, turn), other, limit);
            if (!contact || (first && !(contact->time < limit))) continue;
            limit = contact->time;
            first = {i, &obstacle, angle_at(turn, limit) / std::numbers::pi * 180};
        }
    }
    return first;
}

void go_joint_by_joint(const std::vector<Step>& way, const std::vector<Obstacle>& obstacles) {
    Chain arm = make_arm();
    for (const Step& step : way) {
        const auto found = first_found(arm, step, obstacles);
        fmt::print("joint {} by {:4} degrees: ", step.joint + 1, step.degrees);
        if (found) {
            fmt::print("link {} meets {} after {:.3f}\n", found->link + 1, found->obstacle->name, found->angle);
        } else {
            fmt::print("free\n");
        }
        arm.apply(step.joint, arm.turn(step.joint, step.degrees));
    }
}

// Looks where the arm is, every so many degrees.
void look_every(double degrees, const std::vector<Step>& way, const std::vector<Obstacle>& obstacles) {
    Chain arm = make_arm();
    std::size_t look_count = 0;
    std::set<std::string> seen;
    for (const Step& step : way) {
        const int count = static_cast<int>(std::ceil(std::abs(step.degrees) / degrees));
        for (int k = 0; k < count; ++k, ++look_count) {
            arm.apply(step.joint, arm.turn(step.joint, step.degrees / count));
            for (std::size_t i = 0; i < arm.size(); ++i) {
                for (const Obstacle& obstacle : obstacles) {
                    const Posed<MeshShape> other = Posed<ConvexSolid>(obstacle.solid, Pose());
                    if (intersects(arm.link(i), other)) seen.insert(obstacle.name);
                }
            }
        }
    }
    fmt::print("{} looks, one every {} degrees, see {}\n", look_count, degrees, fmt::join(seen, " and "));
}

}  // namespace

int main() {
    const std::vector<Obstacle> obstacles = make_obstacles();
    const std::vector<Step> way{{0, 90}, {1, -40}, {2, 75}, {3, 90}, {4, 60}, {5, 180}};
    go_joint_by_joint(way, obstacles);
    look_every(5, way, obstacles);
    look_every(0.25, way, obstacles);
}
