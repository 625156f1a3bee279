#include "scenes/moving_boxes.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/random.hpp"

namespace ecods::scenes {

namespace {

struct Box {
    Vec3 centre;
    Vec3 half;
    Vec3 velocity;

    Aabb bounds() const { return {centre - half, centre + half}; }
};

// All centres and half extents are multiples of 2^-11 (of 2^-15 where sizes are alike) and below 2^12 (2^8), so that
// bounds fit in the 24 bits of a float.
double on_box_grid(double x, BoxLayout layout) {
    const int bits = layout == BoxLayout::decades ? 11 : 15;
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
    }
    return "";
}

const char* name(BoxMotion motion) {
    switch (motion) {
        case BoxMotion::all:
            return "";
        case BoxMotion::tenth:
            return ", a tenth moves";
        case BoxMotion::teleport:
            return ", 1 % teleport";
        case BoxMotion::none:
            return ", nothing moves";
    }
    return "";
}

}  // namespace

MovingBoxes moving_boxes(const MovingBoxesOptions& options) {
    const BoxLayout layout = options.layout;
    Random random(options.seed);
    std::vector<Box> boxes(options.count);
    for (Box& box : boxes) box.half = draw_half(random, layout);
    const Vec3 side = sides(boxes, layout);

    MovingBoxes result;
    const std::string count =
        options.count % 1000 == 0 ? std::to_string(options.count / 1000) + "k" : std::to_string(options.count);
    result.name = std::string(name(layout)) + " " + count + name(options.motion);
    for (Box& box : boxes) {
        move(box, side, true, random, layout);
        const double size = 2 * box.half.maxCoeff();
        box.velocity = random.direction() * (0.01 * (layout == BoxLayout::decades ? size : 1));
        result.boxes.push_back(box.bounds());
    }
    for (std::size_t f = 0; f < options.frame_count; ++f) {
        std::vector<BoxMove>& moves = result.frames.emplace_back();
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            if (options.motion == BoxMotion::none) continue;
            if (options.motion == BoxMotion::tenth && i % 10 != 0) continue;
            const bool jumps = options.motion == BoxMotion::teleport && random.below(100) == 0;
            move(boxes[i], side, jumps, random, layout);
            moves.push_back({i, boxes[i].bounds()});
        }
    }
    return result;
}

}  // namespace ecods::scenes
