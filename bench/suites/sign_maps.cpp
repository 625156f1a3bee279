#include "suites/sign_maps.hpp"

#include <fmt/core.h>
#include <Eigen/Geometry>

#include <array>
#include <fstream>
#include <utility>

#include "ecods/primitives.hpp"
#include "exact/point/point.hpp"
#include "exact/sign/plain_signs.hpp"
#include "process/program.hpp"

namespace ecods::bench {
namespace {

// Two to the power of -53: neighbours of 0.5 are so far apart.
constexpr double grid_step = 0x1p-53;

template <class SignOf>
SignMap make_map(std::string title, SignOf&& sign_of) {
    SignMap map{std::move(title), sign_map_size, {}};
    map.signs.reserve(sign_map_size * sign_map_size);
    for (std::size_t j = 0; j < sign_map_size; ++j) {
        for (std::size_t i = 0; i < sign_map_size; ++i) {
            map.signs.push_back(
                sign_of(0.5 + static_cast<double>(i) * grid_step, 0.5 + static_cast<double>(j) * grid_step));
        }
    }
    return map;
}

// The true sign depends on which of x and y is larger alone.
SignMaps judge(SignMap plain, SignMap exact, int sign_below_diagonal) {
    SignMaps maps{std::move(plain), std::move(exact)};
    for (std::size_t j = 0; j < sign_map_size; ++j) {
        for (std::size_t i = 0; i < sign_map_size; ++i) {
            const int truth = i == j ? 0 : i > j ? sign_below_diagonal : -sign_below_diagonal;
            maps.plain_wrong += maps.plain.signs[j * sign_map_size + i] != truth;
            maps.exact_wrong += maps.exact.signs[j * sign_map_size + i] != truth;
        }
    }
    return maps;
}

std::string wrong_share(std::size_t wrong) {
    return fmt::format("{:.1f} %", 100 * static_cast<double>(wrong) / (sign_map_size * sign_map_size));
}

Picture plot_sign_maps(std::array<const SignMap*, 2> maps, const std::filesystem::path& folder, const std::string& name,
                       const std::string& caption) {
    const std::filesystem::path picture = folder / (name + ".png"), script = folder / (name + ".gnuplot");
    std::ofstream out(script);
    out << "set terminal pngcairo size 880,470 font 'DejaVu Sans,14' background '#ffffff'\n"
        << fmt::format("set output '{}'\n", picture.string())
        << fmt::format("set multiplot layout 1,{} margins 0.03,0.97,0.06,0.91 spacing 0.05,0.1\n", maps.size())
        << "set palette maxcolors 3 defined (-1 '#0b62b8', 0 '#ffffff', 1 '#f0a83c')\nset cbrange [-1.5:1.5]\n"
        << "unset colorbox\nunset key\nunset tics\nset border 15 lc rgb '#777777'\nset size square\n";
    for (std::size_t m = 0; m < maps.size(); ++m) {
        const SignMap& map = *maps[m];
        const std::filesystem::path data = folder / fmt::format("{}-{}.txt", name, m + 1);
        std::ofstream table(data);
        for (std::size_t i = 0; i < map.signs.size(); ++i) {
            table << map.signs[i] << ((i + 1) % map.size == 0 ? '\n' : ' ');
        }
        table.close();
        out << fmt::format("set title '{0}'\nset xrange [-0.5:{1}.5]\nset yrange [-0.5:{1}.5]\n", map.title,
                           map.size - 1)
            << fmt::format("plot '{}' matrix with image\n", data.string());
    }
    out << "unset multiplot\n";
    out.close();
    const process::ProgramResult result = process::run_program({"gnuplot", script.string()});
    return {picture, caption, result.status == 0 ? "" : "gnuplot failed: " + result.text()};
}

}  // namespace

SignMaps map_orient2d() {
    const Vec2 q(12, 12), r(24, 24);
    SignMap plain = make_map("plain double", [&](double x, double y) {
        return exact::sign_of((q[0] - x) * (r[1] - y) - (q[1] - y) * (r[0] - x));
    });
    SignMap exact = make_map("ECoDS", [&](double x, double y) { return static_cast<int>(orient2d(Vec2(x, y), q, r)); });
    return judge(std::move(plain), std::move(exact), -1);
}

SignMaps map_posed_orient3d() {
    Pose pose;
    pose.R = Eigen::Quaterniond(0.6, 0.3, -0.5, 0.55).normalized().toRotationMatrix();
    pose.t = Vec3(0.7, -1.3, 0.4);
    const Vec3 a(12, 12, 0), b(24, 24, 1), c(12, 12, 7);
    SignMap plain = make_map("plain double, from rounded posed points", [&](double x, double y) {
        const auto at = [&](const Vec3& v) { return exact::pose_point(pose.R, v, pose.t); };
        return exact::sign_of(exact::plain_orient3d(at(a), at(b), at(c), at(Vec3(x, y, 0.5))));
    });
    SignMap exact = make_map("ECoDS", [&](double x, double y) {
        return static_cast<int>(
            orient3d(PosedPoint{pose, a}, PosedPoint{pose, b}, PosedPoint{pose, c}, PosedPoint{pose, Vec3(x, y, 0.5)}));
    });
    return judge(std::move(plain), std::move(exact), 1);
}

Picture draw_orient2d(const SignMaps& maps, const std::filesystem::path& folder, const std::string& name) {
    return plot_sign_maps(
        {&maps.plain, &maps.exact}, folder, name,
        fmt::format("Which side of the line through (12, 12) and (24, 24)? Each cell is one of 256 x 256 neighbouring "
                    "points (0.5 + i u, 0.5 + j u), u = 2^-53; orient2d is negative (blue), zero (white: on the line) "
                    "or positive (amber). The line is the diagonal. Wrong signs: plain double {}, ECoDS {}.",
                    wrong_share(maps.plain_wrong), wrong_share(maps.exact_wrong)));
}

Picture draw_posed_orient3d(const SignMaps& maps, const std::filesystem::path& folder, const std::string& name) {
    return plot_sign_maps(
        {&maps.plain, &maps.exact}, folder, name,
        fmt::format(
            "The same in space, under a pose: which side of the plane x = y of a rotated body? Each cell is one "
            "of 256 x 256 neighbouring points of the body. Rounding the posed points breaks the plane into "
            "steps. Wrong signs: plain double {}, ECoDS {}.",
            wrong_share(maps.plain_wrong), wrong_share(maps.exact_wrong)));
}

}  // namespace ecods::bench
