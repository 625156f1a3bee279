#include "exact/measure/contact/moving_triangles.hpp"

#include "exact/point/vectors.hpp"

namespace ecods::exact {

Polynomial MovingTriangles::difference(std::size_t i, std::size_t j, std::size_t axis) const {
    return corners_[0][i][axis] - corners_[1][j][axis];
}

const RelativePosition::Vector& MovingTriangles::turn(const CornerAndEdge& which) {
    std::optional<Vector>& turn = turns_[index_of(which)];
    if (!turn) {
        const Triangle& other = corners_[1 - which.side];
        const Vector& from = other[which.edge];
        turn = cross(minus(other[next_corner(which.edge)], from), minus(corners_[which.side][which.corner], from));
    }
    return *turn;
}

Polynomial MovingTriangles::corner_volume(std::size_t side, std::size_t corner) {
    const Triangle& other = corners_[1 - side];
    std::optional<Vector>& normal = normals_[1 - side];
    if (!normal) normal = cross(minus(other[1], other[0]), minus(other[2], other[0]));
    return dot(*normal, minus(corners_[side][corner], other[0]));
}

Polynomial MovingTriangles::edge_volume(std::size_t edge_a, std::size_t edge_b) const {
    const Vector &p = corners_[0][edge_a], &q = corners_[1][edge_b];
    return dot(cross(minus(corners_[0][next_corner(edge_a)], p), minus(corners_[1][next_corner(edge_b)], q)),
               minus(q, p));
}

template <class P>
template <class Make>
int TrianglesAtRoot<P>::sign_of(std::int8_t& known, const Make& make) {
    if (known == unknown) known = static_cast<std::int8_t>(time_.sign_of(make()));
    return known;
}

template <class P>
int TrianglesAtRoot<P>::order(std::size_t i, std::size_t j, std::size_t axis) {
    return sign_of(orders_[9 * i + 3 * j + axis], [&] { return triangles_.difference(i, j, axis); });
}

template <class P>
int TrianglesAtRoot<P>::turn(const CornerAndEdge& which, std::size_t axis) {
    return sign_of(turns_[3 * index_of(which) + axis], [&] { return triangles_.turn(which)[axis]; });
}

template <class P>
int TrianglesAtRoot<P>::corner_volume(std::size_t side, std::size_t corner) {
    return sign_of(volumes_[3 * side + corner], [&] { return triangles_.corner_volume(side, corner); });
}

template <class P>
int TrianglesAtRoot<P>::edge_volume(std::size_t edge_a, std::size_t edge_b) {
    return sign_of(volumes_[6 + 3 * edge_a + edge_b], [&] { return triangles_.edge_volume(edge_a, edge_b); });
}

// Returns true if a corner is in an edge without its ends: on the edge's line and, on some axis, strictly between the
// ends.
template <class P>
bool TrianglesAtRoot<P>::is_inside_edge(const CornerAndEdge& which) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (turn(which, axis) != 0) return false;
    }
    const auto order_of = [&](std::size_t end, std::size_t axis) {
        return which.side == 0 ? order(which.corner, end, axis) : order(end, which.corner, axis);
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (order_of(which.edge, axis) * order_of(next_corner(which.edge), axis) < 0) return true;
    }
    return false;
}

// Returns true if a corner is in a face without its edges: in the face's plane and, seen along some axis, strictly on
// the same side of all three edges. The three turns add up to the face's normal, so if they have the same sign, the
// face has an area when seen along that axis.
template <class P>
bool TrianglesAtRoot<P>::is_inside_face(std::size_t side, std::size_t corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int sign = turn({side, corner, 0}, axis);
        if (sign != 0 && turn({side, corner, 1}, axis) == sign && turn({side, corner, 2}, axis) == sign) {
            return corner_volume(side, corner) == 0;
        }
    }
    return false;
}

// Returns true if two edges cross: they are in one plane and, seen along some axis, the ends of each edge are strictly
// on different sides of the other. The two turns of an edge's ends differ by the cross product of both edges. So if
// they have opposite signs, the edges are not parallel, and the projection along that axis is one to one on their
// plane.
template <class P>
bool TrianglesAtRoot<P>::edges_cross(std::size_t edge_a, std::size_t edge_b) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (turn({0, edge_a, edge_b}, axis) * turn({0, next_corner(edge_a), edge_b}, axis) < 0 &&
            turn({1, edge_b, edge_a}, axis) * turn({1, next_corner(edge_b), edge_a}, axis) < 0) {
            return edge_volume(edge_a, edge_b) == 0;
        }
    }
    return false;
}

template <class P>
bool TrianglesAtRoot<P>::share_point(const FeaturePair& features) {
    const std::size_t side = features.vertex_side;
    switch (features.kind) {
        case FeatureKind::vertex_vertex:
            return order(features.a, features.b, 0) == 0 && order(features.a, features.b, 1) == 0 &&
                   order(features.a, features.b, 2) == 0;
        case FeatureKind::vertex_edge:
            return is_inside_edge({side, features.corner(side), features.corner(1 - side)});
        case FeatureKind::vertex_face:
            return is_inside_face(side, features.corner(side));
        case FeatureKind::edge_edge:
            return edges_cross(features.a, features.b);
    }
    return false;
}

template class TrianglesAtRoot<Polynomial>;
template class TrianglesAtRoot<Quintic>;

}  // namespace ecods::exact
