#include "scenes/polygon/cut_ears.hpp"

#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "scenes/polygon/point_tree.hpp"

namespace ecods::scenes {
namespace {

constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

class EarCutter {
  public:
    EarCutter(const PlaneWalk& face, std::vector<Triangle>& triangles)
        : face_(face), triangles_(triangles), tree_(face.points), links_(face.size()), left_(face.size()) {
        const auto count = static_cast<std::uint32_t>(face.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            links_[i].before = i == 0 ? count - 1 : i - 1;
            links_[i].after = i + 1 == count ? 0 : i + 1;
            add_to_queue(i);
        }
    }

    bool cut() {
        while (left_ > 3) {
            if (queue_.empty()) return false;
            const std::uint32_t i = take_from_queue();
            if (i != nobody) look_at(i);
        }
        if (turn_at(last_) != Sign::positive) return false;
        add_triangle(last_);
        return true;
    }

  private:
    struct Link {
        std::uint32_t before = 0, after = 0;
        bool is_cut = false;
        bool is_in_queue = false;
    };

    const Vec2& point(std::uint32_t i) const { return face_.points[i]; }

    Sign turn_at(std::uint32_t i) const { return turn(point(links_[i].before), point(i), point(links_[i].after)); }

    // How far the third side of the triangle at the corner goes. Rounded: it decides what is looked at first.
    double length(std::uint32_t i) const { return (point(links_[i].before) - point(links_[i].after)).lpNorm<1>(); }

    void add_to_queue(std::uint32_t i) {
        if (links_[i].is_cut || links_[i].is_in_queue) return;
        links_[i].is_in_queue = true;
        queue_.emplace(length(i), i);
    }

    // The corner with the shortest third side: long triangles are slow to look through, and bad to have.
    std::uint32_t take_from_queue() {
        const auto [length_then, i] = queue_.top();
        queue_.pop();
        links_[i].is_in_queue = false;
        if (links_[i].is_cut || length(i) <= length_then) return i;
        add_to_queue(i);
        return nobody;
    }

    void add_triangle(std::uint32_t i) {
        triangles_.push_back({face_.names[links_[i].before], face_.names[i], face_.names[links_[i].after]});
    }

    // A corner with an obstacle is looked at again when a neighbor goes; that the obstacle goes does not free it. Next
    // to an obstacle inside the triangle are points outside of the face, or the ear that was cut there, which lie
    // outside of what is left. At an obstacle on the third side, the face has an angle of 180 degrees at least, and no
    // ear.
    void look_at(std::uint32_t i) {
        if (links_[i].is_cut || turn_at(i) != Sign::positive || has_obstacle(i)) return;
        add_triangle(i);
        take_out(i);
    }

    // True if a corner is in the triangle at i or on its open third side. No edge can lead through the triangle from a
    // corner to a corner: it would leave the place of corner i, where the face is, or cross a side.
    bool has_obstacle(std::uint32_t i) const {
        const PlaneTriangle triangle(point(links_[i].before), point(i), point(links_[i].after));
        return tree_.visit_in(triangle, [](std::uint32_t, const std::array<Sign, 3>& sides) {
            return sides[0] == Sign::positive && sides[1] == Sign::positive;
        });
    }

    void take_out(std::uint32_t i) {
        const std::uint32_t before = links_[i].before;
        const std::uint32_t after = links_[i].after;
        links_[before].after = after;
        links_[after].before = before;
        links_[i].is_cut = true;
        tree_.remove(i);
        --left_;
        last_ = before;
        add_to_queue(before);
        add_to_queue(after);
    }

    const PlaneWalk& face_;
    std::vector<Triangle>& triangles_;
    PointTree tree_;
    std::vector<Link> links_;
    using Queued = std::pair<double, std::uint32_t>;  // the length at that time, and the corner
    std::priority_queue<Queued, std::vector<Queued>, std::greater<>> queue_;
    std::size_t left_;
    std::uint32_t last_ = 0;  // not cut
};

}  // namespace

bool cut_ears(const PlaneWalk& face, std::vector<Triangle>& triangles) {
    return face.size() >= 3 && EarCutter(face, triangles).cut();
}

}  // namespace ecods::scenes
