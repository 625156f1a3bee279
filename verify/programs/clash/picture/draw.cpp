#include "programs/clash/picture/draw.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "programs/clash/picture/marks.hpp"

namespace ecods::clash {
namespace {

// Each pixel is the mean of this many samples in each direction.
constexpr std::size_t oversampling = 2;

struct Samples {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<Sample> all;  // row by row
};

double nearest_depth(const ScreenMesh& mesh) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& point : mesh.points) least = std::min(least, point.z());
    return least;
}

Samples take_samples(const ClashScene& scene, const Camera& camera, std::size_t width, std::size_t height,
                     double thickness) {
    Samples samples{width, height, {}};
    const Marks marks = marks_of(scene, camera, width, height, thickness);
    std::vector<ScreenMesh> meshes;
    meshes.push_back(on_screen(scene.first, Layer::first, camera, width, height));
    meshes.push_back(on_screen(scene.second, Layer::second, camera, width, height));
    meshes.push_back({marks.area_points, marks.area_triangles, Layer::area});
    meshes.push_back({marks.line_points, marks.line_triangles, Layer::line});
    const Look look{{scene.first.is_solid, scene.second.is_solid}, {scene.is_first_within, scene.is_second_within}};
    // Other parts are cut away up to these two, in a close-up of which up to what is about as deep as it is high.
    const double cut_depth =
        std::max(std::min(nearest_depth(meshes[0]), nearest_depth(meshes[1])), -static_cast<double>(height));
    for (const PosedMesh& mesh : scene.context)
        meshes.push_back(on_screen(mesh, Layer::context, camera, width, height));
    samples.all.resize(width * height);
    for_each_band(meshes, {width, height, cut_depth}, [&](const Band& band) {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < band.row_count * width; ++i) {
            std::size_t end = begin;
            while (end < band.fragments.size() && band.fragments[end].sample == i) ++end;
            const std::size_t row = band.first_row + i / width;
            if (end > begin)
                samples.all[row * width + i % width] =
                    composite(band.fragments.subspan(begin, end - begin), i % width, row, look);
            begin = end;
        }
    });
    return samples;
}

// Whether a contour runs between two neighboring samples of which the surfaces are not of one plane, or steps apart.
bool is_edge(const Surface& a, const Surface& b) {
    if (a.kind != b.kind) return true;
    if (a.kind == Surface::Kind::none || a.kind == Surface::Kind::mark) return false;
    int cosine = 0;
    for (std::size_t k = 0; k < 3; ++k) cosine += a.normal[k] * b.normal[k];
    if (cosine < 14'500) return true;  // of 127 * 127: 26 degrees
    // A step: deeper than both slopes allow.
    const double across = std::max(1.0, static_cast<double>(std::min(-a.normal[2], -b.normal[2])));
    return std::abs(a.depth - b.depth) > 4 + 3 * 127 / across;
}

// Most samples are of one plane with their neighbors.
inline bool differ(const Surface& a, const Surface& b) {
    return (a.plane_key() != b.plane_key() || std::abs(a.depth - b.depth) >= 4) && is_edge(a, b);
}

bool is_faint(const Surface& surface) {
    return surface.kind == Surface::Kind::none || surface.kind == Surface::Kind::context;
}

// The contours that a sample is on, as bits: of other parts, of the two parts, of the contact.
constexpr unsigned faint_contour = 1;
constexpr unsigned front_contour = 2;
constexpr unsigned contact_contour = 4;

std::vector<std::uint8_t> find_contours(const Samples& samples) {
    std::vector<std::uint8_t> contours(samples.all.size());
    const auto compare = [&](std::size_t i, std::size_t k) {
        const Sample& here = samples.all[i];
        const Sample& there = samples.all[k];
        unsigned found = 0;
        if (differ(here.front, there.front))
            found = is_faint(here.front) && is_faint(there.front) ? faint_contour : front_contour;
        if (differ(here.contact, there.contact)) found |= contact_contour;
        if (found == 0) return;
        contours[i] = static_cast<std::uint8_t>(contours[i] | found);
        contours[k] = static_cast<std::uint8_t>(contours[k] | found);
    };
    for (std::size_t y = 0; y < samples.height; ++y) {
        for (std::size_t x = 0; x < samples.width; ++x) {
            const std::size_t i = y * samples.width + x;
            if (x + 1 < samples.width) compare(i, i + 1);
            if (y + 1 < samples.height) compare(i, i + samples.width);
        }
    }
    return contours;
}

Rgb with_contours(Rgb color, unsigned contours, double opacity) {
    if ((contours & contact_contour) != 0) color = mix(color, line_color, 0.7);
    if ((contours & front_contour) != 0) return mix(color, {22, 30, 42}, opacity);
    if ((contours & faint_contour) != 0) return mix(color, {120, 128, 138}, 0.45);
    return color;
}

}  // namespace

Image draw(const ClashScene& scene, const Camera& camera, std::size_t width, std::size_t height,
           const DrawOptions& options) {
    const Samples samples =
        take_samples(scene, camera, width * oversampling, height * oversampling, oversampling * options.line_width);
    const std::vector<std::uint8_t> contours = find_contours(samples);
    Image image{width, height, std::vector<Rgb>(width * height)};
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            std::array<unsigned, 3> sum{};
            for (std::size_t i = 0; i < oversampling * oversampling; ++i) {
                const std::size_t at =
                    (y * oversampling + i / oversampling) * samples.width + x * oversampling + i % oversampling;
                Rgb color = samples.all[at].color;
                if (contours[at] != 0) color = with_contours(color, contours[at], options.contours);
                for (std::size_t k = 0; k < 3; ++k) sum[k] += color[k];
            }
            constexpr unsigned count = oversampling * oversampling;
            for (std::size_t k = 0; k < 3; ++k)
                image.at(x, y)[k] = static_cast<std::uint8_t>((sum[k] + count / 2) / count);
        }
    }
    return image;
}

Shares shares_seen(const ClashScene& scene, const Camera& camera, std::size_t width, std::size_t height) {
    const Samples samples = take_samples(scene, camera, width, height, 1.5);
    const double one = 1 / static_cast<double>(width * height);
    const auto is_last = [](std::size_t at, std::size_t size) {
        return static_cast<double>(at) >= (1 - Shares::corner_share) * static_cast<double>(size);
    };
    const auto is_first = [](std::size_t at, std::size_t size) {
        return static_cast<double>(at) < Shares::corner_share * static_cast<double>(size);
    };
    Shares shares;
    for (std::size_t i = 0; i < samples.all.size(); ++i) {
        const Sample& sample = samples.all[i];
        if (sample.front.kind == Surface::Kind::first) shares.first += one;
        if (sample.front.kind == Surface::Kind::second) shares.second += one;
        if (sample.contact.kind == Surface::Kind::none) continue;
        (sample.front.kind == sample.contact.kind ? shares.contact : shares.veiled_contact) += one;
        const std::size_t x = i % width;
        const std::size_t y = i / width;
        if (is_last(x, width) && is_first(y, height)) shares.contact_in_corners[0] += one;
        if (is_first(x, width) && is_first(y, height)) shares.contact_in_corners[1] += one;
        if (is_last(x, width) && is_last(y, height)) shares.contact_in_corners[2] += one;
        if (is_first(x, width) && is_last(y, height)) shares.contact_in_corners[3] += one;
    }
    return shares;
}

}  // namespace ecods::clash
