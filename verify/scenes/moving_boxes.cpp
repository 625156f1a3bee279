#include "scenes/moving_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scenes/random.hpp"

namespace ecods::scenes {

namespace {

struct Box {
    Vec3 centre;
    Vec3 half;
    Vec3 velocity;

    Aabb bounds() const { return {centre - half, centre + half}; }
};

constexpr std::uint32_t boxes_per_wall = 500, boxes_per_cluster = 500;

// All centres and half extents are multiples of 2^-15 and below 2^8, or of 2^-11 and below 2^12 where sizes differ much
// or boxes go far, so that bounds fit in the 24 bits of a float.
double on_box_grid(double x, BoxLayout layout) {
    const int bits = layout == BoxLayout::decades || layout == BoxLayout::ball ? 11 : 15;
    return std::ldexp(std::round(std::ldexp(x, bits)), -bits);
}

double partners(BoxLayout layout) {
    return layout == BoxLayout::sparse ? 0.3 : 5;
}

Vec3 draw_half(Random& random, BoxLayout layout) {
    double scale = 1;
    if (layout == BoxLayout::decades) {
        // Evenly over the logarithm, up to the shape of one octave: 2^10 is three decades.
        const int octave = static_cast<int>(random.below(10));
        scale = std::ldexp(random.uniform(1, 2), octave);
        scale = std::min(scale, 1000.0);
    }
    Vec3 half;
    for (int axis = 0; axis < 3; ++axis) {
        half[axis] = layout == BoxLayout::decades ? scale / 2 : random.uniform(0.25, 0.75);
        half[axis] = on_box_grid(half[axis], layout);
    }
    return half;
}

// The space in which centres stay, such that two random boxes overlap as often as wished: per axis with probability
// (sum of half extents) * 2 / side, boundaries left aside.
Vec3 sides(const std::vector<Box>& boxes, BoxLayout layout) {
    double volume = 0;  // the mean over neighbouring pairs of boxes, which are as good as random ones
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Vec3 sum = 2 * (boxes[i].half + boxes[(i + 1) % boxes.size()].half);
        volume += layout == BoxLayout::pile ? sum.x() * sum.y() : sum.x() * sum.y() * sum.z();
    }
    // Over the number of boxes, times it.
    const double space = volume / partners(layout);
    const double side =
        on_box_grid(layout == BoxLayout::pile ? std::sqrt(space) : std::cbrt(space), BoxLayout::decades);
    return {side, side, layout == BoxLayout::pile ? 0.25 : side};
}

void move(Box& box, const Vec3& side, bool jumps, Random& random, BoxLayout layout) {
    for (int axis = 0; axis < 3; ++axis) {
        const double wall = side[axis] / 2;
        double x = jumps ? random.uniform(-wall, wall) : box.centre[axis] + box.velocity[axis];
        if (std::abs(x) > wall) {
            x = std::copysign(wall, x);
            box.velocity[axis] = -box.velocity[axis];
        }
        box.centre[axis] = on_box_grid(x, layout);
    }
}

// A sum of twelve numbers that are as likely between -1/2 and 1/2: of variance 1.
double nearly_normal(Random& random) {
    double sum = 0;
    for (int i = 0; i < 12; ++i) sum += random.uniform(-0.5, 0.5);
    return sum;
}

// Puts a box where its layout says.
void place(Box& box, std::uint32_t index, const Vec3& side, const std::vector<Box>& boxes, Random& random,
           BoxLayout layout) {
    constexpr double cluster_deviation = 2;
    const double ball_radius = 0.6203505 * side.x();  // of the same volume
    if (layout == BoxLayout::walls && index % boxes_per_wall == 0) {
        const int axis = static_cast<int>(index / boxes_per_wall % 3);
        for (int k = 0; k < 3; ++k) box.half[k] = on_box_grid(k == axis ? 0.125 : side[k] / 4, layout);
    }
    if (layout == BoxLayout::clusters && index % boxes_per_cluster != 0) {
        const Vec3& centre = boxes[index - index % boxes_per_cluster].centre;
        for (int k = 0; k < 3; ++k)
            box.centre[k] = on_box_grid(centre[k] + cluster_deviation * nearly_normal(random), layout);
    } else if (layout == BoxLayout::ball) {
        do move(box, Vec3::Constant(2 * ball_radius), true, random, layout);
        while (box.centre.norm() > ball_radius);
    } else {
        move(box, side, true, random, layout);
    }
}

// By the angle of which the half has a tangent of 1/128: as a fraction, since sines differ between machines.
Vec3 turned(const Vec3& v) {
    constexpr double t = 1.0 / 128, cosine = (1 - t * t) / (1 + t * t), sine = 2 * t / (1 + t * t);
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y(), v.z()};
}

bool has_walls_at(std::uint32_t index, BoxLayout layout) {
    return layout == BoxLayout::walls && index % boxes_per_wall == 0;
}

// One frame after the other.
class Frames {
  public:
    Frames(const MovingBoxesOptions& options, std::vector<Box>& boxes, const Vec3& side, Random& random)
        : options_(options), boxes_(boxes), side_(side), random_(random) {
        for (const Box& box : boxes) exact_.push_back(box.centre);
    }

    std::vector<BoxMove> next() {
        std::vector<BoxMove> moves;
        const std::uint32_t only = options_.motion == BoxMotion::one_new ? draw_index() : 0;
        for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
            if (!takes_part(i, only)) continue;
            const bool is_new = options_.motion == BoxMotion::one_new || draws_new();
            if (options_.motion == BoxMotion::churn_at_rest && !is_new) continue;
            step(i, is_new);
            moves.push_back({i, boxes_[i].bounds(), is_new});
        }
        ++frame_;
        return moves;
    }

  private:
    std::uint32_t draw_index() { return random_.below(static_cast<std::uint32_t>(boxes_.size())); }
    bool draws_new() {
        const bool has_new = options_.motion == BoxMotion::churn || options_.motion == BoxMotion::churn_at_rest;
        return has_new && random_.below(20) == 0;
    }

    bool takes_part(std::uint32_t index, std::uint32_t only) {
        if (has_walls_at(index, options_.layout)) return false;
        switch (options_.motion) {
            case BoxMotion::none:
                return false;
            case BoxMotion::tenth:
                return index % 10 == 0;
            case BoxMotion::hundredth:
                return index % 100 == 0;
            case BoxMotion::random:
                return random_.below(100) == 0;
            case BoxMotion::burst:
                return 2 * frame_ >= options_.frame_count;
            case BoxMotion::one_new:
                return index == only;
            default:
                return true;
        }
    }

    void step(std::uint32_t index, bool is_new) {
        Box& box = boxes_[index];
        Vec3& exact = exact_[index];
        if (options_.motion == BoxMotion::turn || options_.motion == BoxMotion::fly) {
            exact = options_.motion == BoxMotion::turn ? turned(exact) : Vec3(exact + Vec3(4, 3, 0));
            for (int axis = 0; axis < 3; ++axis) box.centre[axis] = on_box_grid(exact[axis], options_.layout);
            return;
        }
        const bool jumps = is_new || (options_.motion == BoxMotion::teleport && random_.below(100) == 0);
        move(box, side_, jumps, random_, options_.layout);
    }

    const MovingBoxesOptions& options_;
    std::vector<Box>& boxes_;
    const Vec3& side_;
    Random& random_;
    std::vector<Vec3> exact_;  // centres before they are rounded, of boxes that move together
    std::size_t frame_ = 0;
};

const char* name(BoxLayout layout) {
    switch (layout) {
        case BoxLayout::dense:
            return "dense";
        case BoxLayout::sparse:
            return "sparse";
        case BoxLayout::pile:
            return "flat pile";
        case BoxLayout::decades:
            return "three decades of sizes";
        case BoxLayout::walls:
            return "walls";
        case BoxLayout::clusters:
            return "clusters";
        case BoxLayout::ball:
            return "swarm";
    }
    return "";
}

std::string name(BoxMotion motion, double speed) {
    const std::string percent = std::to_string(static_cast<int>(std::round(100 * speed)));
    switch (motion) {
        case BoxMotion::all:
            return speed == 0.01 ? "" : ", " + percent + " % of a size a frame";
        case BoxMotion::tenth:
            return ", a tenth moves";
        case BoxMotion::teleport:
            return ", 1 % teleport";
        case BoxMotion::none:
            return ", nothing moves";
        case BoxMotion::hundredth:
            return ", 1 % move";
        case BoxMotion::random:
            return ", a random 1 % moves";
        case BoxMotion::burst:
            return ", rest and a burst";
        case BoxMotion::churn:
            return ", 5 % come and go";
        case BoxMotion::churn_at_rest:
            return ", 5 % come and go, others at rest";
        case BoxMotion::one_new:
            return ", one in, one out";
        case BoxMotion::turn:
            return " turns";
        case BoxMotion::fly:
            return " flies";
    }
    return "";
}

std::string name(std::size_t count) {
    if (count % 1'000'000 == 0) return std::to_string(count / 1'000'000) + "M";
    return count % 1000 == 0 ? std::to_string(count / 1000) + "k" : std::to_string(count);
}

}  // namespace

MovingBoxes moving_boxes(const MovingBoxesOptions& options) {
    const BoxLayout layout = options.layout;
    Random random(options.seed);
    std::vector<Box> boxes(options.count);
    for (Box& box : boxes) box.half = draw_half(random, layout);
    const Vec3 side = sides(boxes, layout);

    MovingBoxes result;
    result.name = std::string(name(layout)) + " " + name(options.count) + name(options.motion, options.speed);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        Box& box = boxes[i];
        place(box, i, side, boxes, random, layout);
        const double size = 2 * box.half.maxCoeff();
        box.velocity = random.direction() * (options.speed * (layout == BoxLayout::decades ? size : 1));
        result.boxes.push_back(box.bounds());
    }
    Frames frames(options, boxes, side, random);
    for (std::size_t f = 0; f < options.frame_count; ++f) result.frames.push_back(frames.next());
    return result;
}

}  // namespace ecods::scenes
