// Whether a vertex and a face, or two edges, of which every corner moves by itself, meet (Sample-Queries).
#include "foreign/sample_queries.hpp"

#include <array>
#include <charconv>
#include <string_view>

#include "ecods/cast.hpp"
#include "foreign/shapes.hpp"
#include "foreign/sources.hpp"

namespace ecods::foreign::sample_queries {
namespace {

class Numbers {
  public:
    explicit Numbers(std::string_view text) : text_(text) {}

    bool more() {
        const std::size_t begin = text_.find_first_not_of(" \n");
        if (begin == std::string_view::npos) return false;
        text_.remove_prefix(begin);
        return true;
    }
    double next() {
        more();
        double number = 0;
        const auto read = std::from_chars(text_.data(), text_.data() + text_.size(), number);
        text_.remove_prefix(static_cast<std::size_t>(read.ptr - text_.data()));
        return number;
    }
    Vec3 next_point() {
        Vec3 p;
        for (int k = 0; k < 3; ++k) p[k] = next();
        return p;
    }

  private:
    std::string_view text_;
};

// Free corners are the images of the unit vectors under a pose whose matrix has them as columns.
struct Corners {
    MeshShape shape;
    Pose from{Mat3::Zero(), Vec3::Zero()}, to{Mat3::Zero(), Vec3::Zero()};

    explicit Corners(std::uint32_t count)
        : shape(Mesh::create({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()},
                             {{0, std::min(1u, count - 1), std::min(2u, count - 1)}})) {}
    Moving<MeshShape> moving() const { return {shape, from, to}; }
};

// The first `split` points belong to the first body.
void ask_queries(Expectations& expect, std::string_view queries, int split) {
    for (Numbers text(queries); text.more();) {
        const bool meet = text.next() == 1;
        Corners a(static_cast<std::uint32_t>(split)), b(static_cast<std::uint32_t>(4 - split));
        for (Pose Corners::*pose : {&Corners::from, &Corners::to}) {
            for (int i = 0; i < 4; ++i)
                (i < split ? (a.*pose).R.col(i) : (b.*pose).R.col(i - split)) = text.next_point();
        }
        expect.is(cast(a.moving(), b.moving()).has_value(), meet);
        expect.is(cast(b.moving(), a.moving()).has_value(), meet);
    }
}

}  // namespace

void ask(Expectations& expect) {
    expect.from("vertex-face");
    ask_queries(expect, vertex_face_queries, 1);
    expect.from("edge-edge");
    ask_queries(expect, edge_edge_queries, 2);
}

}  // namespace ecods::foreign::sample_queries
