#include "programs/clash/picture/choose_camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "programs/clash/picture/draw.hpp"

namespace ecods::clash {
namespace {

// To the eye: two numbers on the ground and a height, no face of a house edge-on. The first is preferred a little, and
// heights in the order below.
constexpr std::array<std::array<double, 2>, 8> ground{
    {{-3, -5}, {3, -5}, {5, -3}, {-5, -3}, {5, 3}, {-5, 3}, {3, 5}, {-3, 5}}};
struct Height {
    double height;
    double weight;
};
constexpr std::array<Height, 4> heights{{{3.5, 1}, {1.2, 0.93}, {8, 0.9}, {-2.5, 0.85}}};

constexpr double margin = 1.12;
constexpr std::size_t trial_height = 40;
constexpr std::size_t trial_triangles = 30'000;

Vec3 to_eye(const std::array<double, 2>& on_ground, double height, const Vec3& vertical) {
    return vertical.y() == 1 ? Vec3(on_ground[0], height, -on_ground[1]) : Vec3(on_ground[0], on_ground[1], height);
}

Views views_from(const ClashScene& scene, const Vec3& eye, double aspect) {
    std::vector<Vec3> all = scene.first.points;
    all.insert(all.end(), scene.second.points.begin(), scene.second.points.end());
    Views views;
    views.whole = camera_from(eye, scene.vertical);
    look_at_middle(views.whole, all);
    views.whole.half_height = margin * half_height_of(views.whole, all, aspect);
    if (views.whole.half_height == 0) views.whole.half_height = 1;  // points
    views.near = views.whole;
    look_at_middle(views.near, scene.contact_box);
    const double contact = half_height_of(views.near, scene.contact_box, aspect);
    // Points and short lines need some of the parts around them; a gap is what is to be seen, however small.
    const double gap = (scene.contact_box.back() - scene.contact_box.front()).norm();
    const double least = scene.kind == Kind::clearance ? gap * 2 : views.whole.half_height * 0.06;
    views.near.half_height = std::max({contact * 2.2, least, views.whole.half_height * 1e-9});
    views.is_one = views.near.half_height > 0.55 * views.whole.half_height;
    if (views.is_one) views.near = views.whole;
    for (Camera* camera : {&views.near, &views.whole}) {
        camera->distance = camera->half_height;
        for (const Vec3& point : all)
            camera->distance =
                std::max(camera->distance, (camera->target - point).dot(camera->forward) + camera->half_height);
    }
    return views;
}

double score(const Shares& shares) {
    const auto up_to = [](double share, double enough) { return std::min(share, enough) / enough; };
    return 1.2 * up_to(shares.contact + 0.6 * shares.veiled_contact, 0.12) + 0.5 * up_to(shares.contact, 0.03) +
           0.6 * up_to(shares.first, 0.12) + 0.6 * up_to(shares.second, 0.12);
}

// A scene of few triangles, for looking at it from many sides: of large meshes some triangles, which bound no solid.
void thin_out(PosedMesh& mesh, std::vector<Triangle>& kept) {
    if (mesh.triangles.size() <= trial_triangles) return;
    const std::size_t step = mesh.triangles.size() / trial_triangles + 1;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += step) kept.push_back(mesh.triangles[i]);
    std::vector<Vec3> points;
    points.reserve(kept.size() * 3);
    for (Triangle& triangle : kept) {
        for (std::uint32_t& corner : triangle) {
            points.push_back(mesh.points[corner]);
            corner = static_cast<std::uint32_t>(points.size() - 1);
        }
    }
    mesh.points = std::move(points);
    mesh.triangles = kept;
    mesh.is_solid = false;
}

}  // namespace

Views default_views(const ClashScene& scene, double aspect) {
    return views_from(scene, to_eye(ground.front(), heights.front().height, scene.vertical), aspect);
}

Views choose_views(const ClashScene& scene, double aspect) {
    ClashScene trial = scene;
    trial.context.clear();
    std::vector<Triangle> first;
    std::vector<Triangle> second;
    thin_out(trial.first, first);
    thin_out(trial.second, second);
    const auto width = static_cast<std::size_t>(std::lround(trial_height * aspect));
    Vec3 best_eye = Vec3::UnitX();
    double best = -1;
    for (const Height& height : heights) {
        for (std::size_t i = 0; i < ground.size(); ++i) {
            const Vec3 eye = to_eye(ground[i], height.height, scene.vertical);
            const Views views = views_from(trial, eye, aspect);
            const double value = height.weight * (1 - 0.01 * static_cast<double>(i)) *
                                 score(shares_seen(trial, views.near, width, trial_height));
            if (value <= best) continue;
            best = value;
            best_eye = eye;
        }
    }
    return views_from(scene, best_eye, aspect);
}

}  // namespace ecods::clash
