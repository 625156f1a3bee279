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
        // The corner that was in the way, and the neighbors in the list of those that wait for it.
        std::uint32_t waits_for = nobody, wait_before = nobody, wait_after = nobody;
        std::uint32_t first_waiting = nobody;  // for this one
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

    void look_at(std::uint32_t i) {
        if (links_[i].is_cut) return;
        stop_waiting(i);
        if (turn_at(i) != Sign::positive) return;
        const std::uint32_t obstacle = find_obstacle(i);
        if (obstacle == nobody) {
            add_triangle(i);
            take_out(i);
        } else {
            wait_for(i, obstacle);
        }
    }

    void wait_for(std::uint32_t i, std::uint32_t obstacle) {
        const std::uint32_t next = links_[obstacle].first_waiting;
        links_[i].waits_for = obstacle;
        links_[i].wait_before = nobody;
        links_[i].wait_after = next;
        if (next != nobody) links_[next].wait_before = i;
        links_[obstacle].first_waiting = i;
    }

    void stop_waiting(std::uint32_t i) {
        Link& link = links_[i];
        if (link.waits_for == nobody) return;
        if (link.wait_before != nobody) {
            links_[link.wait_before].wait_after = link.wait_after;
        } else {
            links_[link.waits_for].first_waiting = link.wait_after;
        }
        if (link.wait_after != nobody) links_[link.wait_after].wait_before = link.wait_before;
        link.waits_for = nobody;
    }

    // A corner that is in the triangle at i or on its open third side. No edge can lead through the triangle from a
    // corner to a corner: it would leave the place of corner i, where the face is, or cross a side.
    std::uint32_t find_obstacle(std::uint32_t i) const {
        const PlaneTriangle triangle(point(links_[i].before), point(i), point(links_[i].after));
        std::uint32_t obstacle = nobody;
        tree_.visit_in(triangle, [&](std::uint32_t other, const std::array<Sign, 3>& sides) {
            if (sides[0] != Sign::positive || sides[1] != Sign::positive) return false;
            obstacle = other;
            return true;
        });
        return obstacle;
    }

    void take_out(std::uint32_t i) {
        const std::uint32_t before = links_[i].before;
        const std::uint32_t after = links_[i].after;
        links_[before].after = after;
        links_[after].before = before;
        links_[i].is_cut = true;
        stop_waiting(i);
        tree_.remove(i);
        --left_;
        last_ = before;
        add_to_queue(before);
        add_to_queue(after);
        wake(i);
    }

    // Corners that waited for one that went are looked at again.
    void wake(std::uint32_t obstacle) {
        while (links_[obstacle].first_waiting != nobody) {
            const std::uint32_t waiting = links_[obstacle].first_waiting;
            stop_waiting(waiting);
            add_to_queue(waiting);
        }
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
