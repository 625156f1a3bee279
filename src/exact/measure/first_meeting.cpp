#include "exact/measure/first_meeting.hpp"

#include <utility>

#include "base/assert.hpp"

namespace ecods::exact {
namespace {

constexpr std::size_t after(std::size_t corner) {
    return corner == 2 ? 0 : corner + 1;
}

// Whether the features belong to a corner and all of the other triangle, or to two edges with their ends.
struct CornerAndTriangle {
    std::size_t side, corner;

    bool has(const FeaturePair& pair) const noexcept {
        const std::size_t own = side == 0 ? pair.a : pair.b;
        const bool has_vertex = pair.kind == FeatureKind::vertex_vertex ||
                                (pair.kind != FeatureKind::edge_edge && pair.vertex_side == side);
        return has_vertex && own == corner;
    }
};
struct TwoEdges {
    std::size_t a, b;

    bool has(const FeaturePair& pair) const noexcept {
        const auto is_end = [](std::size_t corner, std::size_t edge) {
            return corner == edge || corner == after(edge);
        };
        switch (pair.kind) {
            case FeatureKind::vertex_vertex:
                return is_end(pair.a, a) && is_end(pair.b, b);
            case FeatureKind::vertex_edge:
                return pair.vertex_side == 0 ? is_end(pair.a, a) && pair.b == b : pair.a == a && is_end(pair.b, b);
            case FeatureKind::vertex_face:
                return false;
            case FeatureKind::edge_edge:
                return pair.a == a && pair.b == b;
        }
        return false;
    }
};

class MeetingSearch {
  public:
    explicit MeetingSearch(MovingTriangles& triangles) : triangles_(triangles) {}

    std::optional<Meeting> run() {
        for (std::size_t side = 0; side < 2; ++side) {
            for (std::size_t corner = 0; corner < 3; ++corner) add(CornerAndTriangle{side, corner});
        }
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = 0; b < 3; ++b) add(TwoEdges{a, b});
        }
        if (!first_) return std::nullopt;
        TrianglesAtRoot then(triangles_, *first_);
        for (const FeaturePair& pair : feature_pairs) {
            if (then.share_point(pair)) return Meeting{first_->round(), pair};
        }
        ECODS_ASSERT(false);
        return std::nullopt;
    }

  private:
    void add(const CornerAndTriangle& part) {
        const Polynomial volume = triangles_.corner_volume(part.side, part.corner);
        if (!volume.is_zero()) return try_roots(volume, part);
        for (std::size_t edge = 0; edge < 3; ++edge) add_in_plane({part.side, part.corner, edge}, part);
    }
    void add(const TwoEdges& part) {
        const Polynomial volume = triangles_.edge_volume(part.a, part.b);
        if (!volume.is_zero()) return try_roots(volume, part);
        add_in_plane({0, part.a, part.b}, part);
        add_in_plane({0, after(part.a), part.b}, part);
        add_in_plane({1, part.b, part.a}, part);
        add_in_plane({1, after(part.b), part.a}, part);
    }

    template <class Part>
    void add_in_plane(const CornerAndEdge& which, const Part& part) {
        const MovingTriangles::Vector& turn = triangles_.turn(which);
        for (const Polynomial& coordinate : turn) {
            if (!coordinate.is_zero()) return try_roots(coordinate, part);
        }
        for (const std::size_t end : {which.edge, after(which.edge)}) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Polynomial difference = which.side == 0 ? triangles_.difference(which.corner, end, axis)
                                                              : triangles_.difference(end, which.corner, axis);
                if (difference.is_zero()) continue;
                try_roots(difference, part);
                break;
            }
        }
    }

    // Keeps the first root at which the part meets, if it is before what is known.
    template <class Part>
    void try_roots(const Polynomial& p, const Part& part) {
        for (Root& time : roots_in_unit_interval(p)) {
            if (first_ && compare(time, *first_) >= 0) return;
            TrianglesAtRoot then(triangles_, time);
            for (const FeaturePair& pair : feature_pairs) {
                if (!part.has(pair) || !then.share_point(pair)) continue;
                first_ = std::move(time);
                return;
            }
        }
    }

    MovingTriangles& triangles_;
    std::optional<Root> first_;
};

}  // namespace

std::optional<Meeting> first_meeting(MovingTriangles& triangles) {
    return MeetingSearch(triangles).run();
}

}  // namespace ecods::exact
