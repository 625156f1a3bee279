#include "scenes/mesh_pairs.hpp"

#include <cmath>
#include <optional>

#include "ecods/intersection.hpp"
#include "ecods/shape.hpp"
#include "scenes/mesh_ball.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes {

namespace {

// A copy of the mesh on its way along a line towards another copy that rests.
class Approach {
  public:
    Approach(const std::shared_ptr<const Mesh>& mesh, std::uint32_t seed)
        : shape_(mesh), ball_(ball_of(*mesh)), random_(seed) {}

    void draw() {
        const Mat3 resting = random_.rotation().toRotationMatrix();
        moving_ = random_.rotation().toRotationMatrix();
        line_ = random_.direction();
        resting_ = place(ball_, resting, Vec3::Zero());
    }

    MeshQuery at(double distance) const { return {{0, resting_}, {0, place(ball_, moving_, line_ * distance)}}; }

    bool hits(double distance) {
        const MeshQuery query = at(distance);
        return intersects({shape_, query.a.pose}, {shape_, query.b.pose}, memory_);
    }

    // The first contact from afar: a distance that hits and one that does not, closer than `width` radii, or adjacent
    // when that is zero. Nothing when steps of a sixteenth of a radius meet no contact.
    struct Bracket {
        double hit;
        double miss;
    };
    std::optional<Bracket> first_contact(double width) {
        const double step = ball_.radius / 16;
        int steps = 32;
        while (steps >= 0 && !hits(steps * step)) --steps;
        if (steps < 0 || steps == 32) return std::nullopt;
        Bracket bracket{steps * step, (steps + 1) * step};
        while (bracket.miss - bracket.hit > width * ball_.radius) {
            const double middle = bracket.hit + (bracket.miss - bracket.hit) / 2;
            if (middle == bracket.hit || middle == bracket.miss) break;
            (hits(middle) ? bracket.hit : bracket.miss) = middle;
        }
        return bracket;
    }

    Random& random() { return random_; }
    double radius() const { return ball_.radius; }

  private:
    MeshShape shape_;
    QueryMemory memory_;
    Ball ball_;
    Random random_;
    Mat3 moving_;
    Vec3 line_;
    Pose resting_;
};

// Draws until the query is as it must be: every other one hits.
template <class DrawGap>
MeshPairs approach_pairs(const std::string& name, const std::shared_ptr<const Mesh>& mesh, std::size_t count,
                         std::uint32_t seed, double bracket_width, const DrawGap& draw_gap) {
    MeshPairs pairs{name, {{name, mesh}}, {}};
    Approach approach(mesh, seed);
    while (pairs.queries.size() < count) {
        approach.draw();
        const double gap = draw_gap(approach.random()) * approach.radius();
        const auto contact = approach.first_contact(bracket_width);
        if (!contact) continue;
        const bool must_hit = pairs.queries.size() % 2 == 0;
        const double distance = must_hit ? contact->hit - gap : contact->miss + gap;
        if (approach.hits(distance) == must_hit) pairs.queries.push_back(approach.at(distance));
    }
    return pairs;
}

}  // namespace

MeshPairs near_pairs(const std::string& name, const std::shared_ptr<const Mesh>& mesh, std::size_t count,
                     std::uint32_t seed) {
    return approach_pairs(name, mesh, count, seed, 0x1p-20, [](Random& random) {
        const int exponent = -13 + static_cast<int>(random.below(6));
        return std::ldexp(random.uniform(1, 2), exponent);
    });
}

MeshPairs gap_pairs(const std::string& name, const std::shared_ptr<const Mesh>& mesh, double gap, std::size_t count,
                    std::uint32_t seed) {
    return approach_pairs(name, mesh, count, seed, 0, [gap](Random&) { return gap; });
}

MeshPairs random_pairs(const std::string& name, const std::shared_ptr<const Mesh>& mesh, std::size_t count,
                       std::uint32_t seed) {
    MeshPairs pairs{name, {{name, mesh}}, {}};
    Random random(seed);
    const Ball ball = ball_of(*mesh);
    const double reach = 2 * ball.radius;
    while (pairs.queries.size() < count) {
        const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
        const Vec3 offset(x, y, random.uniform(-reach, reach));
        if ((offset.x() * offset.x() + offset.y() * offset.y()) + offset.z() * offset.z() > reach * reach) continue;
        const Pose a = place(ball, random.rotation().toRotationMatrix(), Vec3::Zero());
        const Pose b = place(ball, random.rotation().toRotationMatrix(), offset);
        pairs.queries.push_back({{0, a}, {0, b}});
    }
    return pairs;
}

}  // namespace ecods::scenes
