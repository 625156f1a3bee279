#include "programs/clash/picture/pictures.hpp"

#include <algorithm>
#include <cmath>

#include "process/parallel.hpp"
#include "programs/clash/picture/choose_camera.hpp"
#include "programs/clash/picture/draw.hpp"

namespace ecods::clash {
namespace {

constexpr double aspect = static_cast<double>(picture_width) / picture_height;

constexpr Rgb frame_color{22, 30, 42};

// A frame around the pixels from `left` and `top` to before `right` and `bottom`, as far as it is in the picture.
void draw_frame(Image& image, long left, long top, long right, long bottom, long thickness, const Rgb& color) {
    for (long y = std::max(top, 0L); y < std::min(bottom, static_cast<long>(image.height)); ++y) {
        for (long x = std::max(left, 0L); x < std::min(right, static_cast<long>(image.width)); ++x) {
            const bool is_inner =
                x >= left + thickness && x < right - thickness && y >= top + thickness && y < bottom - thickness;
            if (!is_inner) image.at(static_cast<std::size_t>(x), static_cast<std::size_t>(y)) = color;
        }
    }
}

// Both parts as wholes in the corner with the least of the contact, with a frame around what the picture shows.
void add_inset(Image& image, const ClashScene& scene, const Views& views) {
    const std::size_t width = static_cast<std::size_t>(static_cast<double>(image.width) * Shares::corner_share);
    const std::size_t height = static_cast<std::size_t>(static_cast<double>(image.height) * Shares::corner_share);
    Image inset = draw(scene, views.whole, width, height, {1, 0.4});
    const Vec3 middle = on_screen(views.near.target, views.whole, width, height);
    const double half = static_cast<double>(height) / 2 * views.near.half_height / views.whole.half_height;
    const double half_y = std::max(half, 6.0);
    const double half_x = std::max(half * aspect, 6.0);
    draw_frame(inset, std::lround(middle.x() - half_x), std::lround(middle.y() - half_y),
               std::lround(middle.x() + half_x), std::lround(middle.y() + half_y), 2, contact_color);
    draw_frame(inset, 0, 0, static_cast<long>(width), static_cast<long>(height), 1, {120, 128, 138});
    const std::array<double, 4> contact = shares_seen(scene, views.near, 90, 60).contact_in_corners;
    const auto corner = std::min_element(contact.begin(), contact.end()) - contact.begin();
    const std::size_t left = corner % 2 == 0 ? image.width - width : 0;
    const std::size_t top = corner / 2 == 0 ? 0 : image.height - height;
    for (std::size_t y = 0; y < height; ++y) std::copy_n(&inset.at(0, y), width, &image.at(left, top + y));
}

Picture make_picture(const ClashReport& report, const Clash& clash, std::span<const Aabb> boxes) {
    ClashScene scene = scene_of(report, clash);
    Views views = choose_views(scene, aspect);
    add_context(scene, report, clash, boxes, 1.6 * views.near.half_height * aspect);
    Image image = draw(scene, views.near, picture_width, picture_height, {});
    if (!views.is_one) {
        scene.context.clear();
        add_inset(image, scene, views);
    }
    views.near.target += scene.origin;
    return {views.near, to_png(image)};
}

}  // namespace

bool can_make_pictures() noexcept {
    return can_write_png();
}

std::vector<Picture> make_pictures(const ClashReport& report, std::size_t count, std::size_t jobs,
                                   const std::function<void()>& step) {
    count = std::min(count, report.clashes.size());
    if (count == 0) return {};
    if (!can_write_png()) to_png({});  // which throws
    const std::vector<Aabb> boxes = part_boxes(report);
    std::vector<Picture> pictures(count);
    process::for_each_in_parallel(count, jobs, [&](std::size_t i, std::size_t) {
        pictures[i] = make_picture(report, report.clashes[i], boxes);
        if (step) step();
    });
    return pictures;
}

Camera camera_without_picture(const ClashReport& report, const Clash& clash) {
    const ClashScene scene = boxes_scene_of(report, clash);
    Camera camera = default_views(scene, aspect).near;
    camera.target += scene.origin;
    return camera;
}

}  // namespace ecods::clash
