// The triangles of a building's elements.
#include <fmt/format.h>

#include <iterator>
#include <ostream>

#include "scenes/building/building.hpp"

namespace ecods::scenes {
namespace {

using Index = std::uint32_t;

class Builder {
  public:
    explicit Builder(const Element& element) : element_(element) {}

    Index add_vertex(Length u, Length v, Length w) {
        Vec3 point;
        point[(element_.axis + 1) % 3] = meters(u);
        point[(element_.axis + 2) % 3] = meters(v);
        point[element_.axis] = meters(w);
        vertices.push_back(point);
        return static_cast<Index>(vertices.size() - 1);
    }

    // Counterclockwise from outside.
    void add_quad(Index a, Index b, Index c, Index d) {
        if (element_.is_cut_otherwise) {
            triangles.push_back({b, c, d});
            triangles.push_back({b, d, a});
        } else {
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    }

    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;

  private:
    const Element& element_;
};

void add_pipe(const Element& pipe, Builder& builder) {
    const auto corners = pipe_corners(pipe);
    const auto count = static_cast<Index>(corners.size());
    for (const Length w : {pipe.lo, pipe.hi}) {
        for (const auto& [u, v] : corners) builder.add_vertex(u, v, w);
    }
    for (Index i = 0; i < count; ++i) {
        const Index next = (i + 1) % count;
        builder.add_quad(i, next, count + next, count + i);
    }
    for (Index i = 2; i < count; ++i) {
        builder.triangles.push_back({0, i, i - 1});
        builder.triangles.push_back({count, count + i - 1, count + i});
    }
}

// A vertex at each point of the grid that a filled cell has, at both ends.
class GridBuilder {
  public:
    GridBuilder(const Element& grid, Builder& builder)
        : grid_(grid), builder_(builder), width_(grid.us.size() - 1), height_(grid.vs.size() - 1) {
        for (std::size_t j = 0; j <= height_; ++j) {
            for (std::size_t i = 0; i <= width_; ++i) {
                const bool is_used =
                    is_filled(i, j) || is_filled(i, j - 1) || is_filled(i - 1, j) || is_filled(i - 1, j - 1);
                Ends ends{};
                if (is_used) ends.lo = builder_.add_vertex(grid_.us[i], grid_.vs[j], grid_.lo);
                if (is_used) ends.hi = builder_.add_vertex(grid_.us[i], grid_.vs[j], grid_.hi);
                ends_.push_back(ends);
            }
        }
    }

    void add_cells() {
        for (std::size_t j = 0; j < height_; ++j) {
            for (std::size_t i = 0; i < width_; ++i) {
                if (is_filled(i, j)) add_cell(i, j);
            }
        }
    }

  private:
    struct Ends {
        Index lo, hi;
    };

    // Indices of -1 wrap around, and lie outside as well.
    bool is_filled(std::size_t i, std::size_t j) const {
        return i < width_ && j < height_ && grid_.filled[j * width_ + i] != 0;
    }

    void add_cell(std::size_t i, std::size_t j) {
        const std::size_t row = width_ + 1;
        const Ends a = ends_[j * row + i];
        const Ends b = ends_[j * row + i + 1];
        const Ends c = ends_[(j + 1) * row + i + 1];
        const Ends d = ends_[(j + 1) * row + i];
        builder_.add_quad(a.lo, d.lo, c.lo, b.lo);
        if (grid_.defect != Defect::open) builder_.add_quad(a.hi, b.hi, c.hi, d.hi);
        if (!is_filled(i, j - 1)) add_side(a, b);
        if (!is_filled(i + 1, j)) add_side(b, c);
        if (!is_filled(i, j + 1)) add_side(c, d);
        if (!is_filled(i - 1, j)) add_side(d, a);
    }

    void add_side(const Ends& from, const Ends& to) { builder_.add_quad(from.lo, to.lo, to.hi, from.hi); }

    const Element& grid_;
    Builder& builder_;
    std::size_t width_, height_;
    std::vector<Ends> ends_;
};

}  // namespace

// Cosines of multiples of 15 degrees in ten-thousandths, cut off.
std::array<std::array<Length, 2>, 24> pipe_corners(const Element& pipe) {
    constexpr std::array<Length, 7> cosines{10000, 9659, 8660, 7071, 5000, 2588, 0};
    std::array<std::array<Length, 2>, 24> corners{};
    for (std::size_t i = 0; i < 6; ++i) {
        const Length x = pipe.radius * cosines[i] / 10000;
        const Length y = pipe.radius * cosines[6 - i] / 10000;
        corners[i] = {pipe.u + x, pipe.v + y};
        corners[i + 6] = {pipe.u - y, pipe.v + x};
        corners[i + 12] = {pipe.u - x, pipe.v - y};
        corners[i + 18] = {pipe.u + y, pipe.v - x};
    }
    return corners;
}

std::shared_ptr<const Mesh> mesh_of(const Element& element) {
    Builder builder(element);
    if (element.is_pipe()) {
        add_pipe(element, builder);
    } else {
        GridBuilder(element, builder).add_cells();
    }
    if (element.defect == Defect::doubled) {
        const std::vector<Triangle> once = builder.triangles;
        builder.triangles.insert(builder.triangles.end(), once.begin(), once.end());
    }
    return Mesh::create(std::move(builder.vertices), std::move(builder.triangles));
}

void write_obj(std::ostream& out, const std::vector<Element>& elements) {
    std::size_t first = 1;
    for (const Element& element : elements) {
        const auto mesh = mesh_of(element);
        fmt::memory_buffer text;
        fmt::format_to(std::back_inserter(text), "o {}\n", element.name);
        for (const Vec3& v : mesh->vertices())
            fmt::format_to(std::back_inserter(text), "v {} {} {}\n", v[0], v[1], v[2]);
        for (const Triangle& t : mesh->triangles())
            fmt::format_to(std::back_inserter(text), "f {} {} {}\n", first + t[0], first + t[1], first + t[2]);
        first += mesh->vertices().size();
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
    }
}

}  // namespace ecods::scenes
