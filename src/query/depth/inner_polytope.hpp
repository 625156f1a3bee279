// InnerPolytope grows a polytope of vertices of the Minkowski difference of two convex solids, in doubles, towards the
// faces of the difference that are nearest to the origin.
//
// The faces of the polytope are triangles, facing outwards. They form a closed surface whatever rounding does: removed
// faces leave a border, and new faces join a vertex to that border. The proof in nearest_planes.hpp uses this property
// alone.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "query/depth/border_edges.hpp"
#include "query/depth/difference_face.hpp"
#include "query/depth/rounded_bounds.hpp"

namespace ecods::depths {

class InnerPolytope {
  public:
    enum class End : std::uint8_t {
        nearest,  // in doubles, no vertex is beyond the nearest face
        apart,    // proven: a plane has the whole difference on one side and the origin on the other
        unknown,  // undecided; integers must decide
    };

    End find(const convex::PosedHulls& hulls);

    struct Face {
        exact::Point n;  // cross product of two edges
        double n_error;  // error bound of each coordinate of n
        double length;   // length of n
        std::array<DifferenceVertex, 3> corners;
    };
    Face face(std::uint32_t i) const noexcept;
    std::uint32_t nearest() const noexcept { return nearest_; }
    // Returns an upper bound of the depth. If is_upper_proven(), the bound is proven; otherwise it holds if the nearest
    // face is in the plane of a face of the whole difference.
    double upper() const noexcept { return upper_; }
    bool is_upper_proven() const noexcept { return hulls_->is_scanned(0) && hulls_->is_scanned(1); }

    // Calls visit(i) for each face, except faces that are proven to be further from the origin than upper(), with the
    // origin on their inner side.
    template <class Visit>
    void visit_near(Visit&& visit) const {
        for (std::uint32_t i = 0; i < face_count_; ++i) {
            const double length = length_[i] * RoundedBounds::slack + 2 * n_error_[i];
            if (!(h_[i] - h_error_[i] > upper_ * length)) visit(i);
        }
    }

    // Adds a vertex, which must be strictly beyond some face. If doubles do not decide whether the vertex is beyond a
    // face, is_beyond(face) must return whether the vertex is strictly beyond. Returns false if the border is too long.
    template <class IsBeyond>
    bool insert(const DifferenceVertex& v, IsBeyond&& is_beyond) {
        if (!has_space()) add_space();
        add_vertex(v);
        const exact::Point& m = vertices_[vertex_count_ - 1].m;
        std::uint32_t visible_count = 0;
        for (std::uint32_t i = 0; i < face_count_; ++i) {
            const double height = (nx_[i] * m[0] + ny_[i] * m[1]) + nz_[i] * m[2] - h_[i];
            if (height < -2 * h_error_[i]) continue;
            if (height > 2 * h_error_[i] || is_beyond(face(i))) visible_[visible_count++] = i;
        }
        if (!replace(visible_count)) return false;
        bound_by_nearest();
        return true;
    }

  private:
    struct Vertex {
        exact::Point m;
        DifferenceVertex of;
    };

    ECODS_ALWAYS_INLINE End grow();
    ECODS_ALWAYS_INLINE bool begin();
    bool begin_anywhere();
    ECODS_ALWAYS_INLINE bool set_tetrahedron();
    ECODS_ALWAYS_INLINE void add_support(const exact::Point& n);
    ECODS_ALWAYS_INLINE void find_nearest();
    ECODS_ALWAYS_INLINE bool replace_visible(std::uint32_t visible_count);
    bool replace(std::uint32_t visible_count);
    void bound_by_nearest() noexcept;
    ECODS_ALWAYS_INLINE std::uint32_t support(std::size_t side, const exact::Point& n) const noexcept;
    ECODS_ALWAYS_INLINE void add_vertex(const DifferenceVertex& v) noexcept {
        vertices_[vertex_count_++] = {exact::minus(hulls_->rounded(0, v.p), hulls_->rounded(1, v.q)), v};
    }
    ECODS_ALWAYS_INLINE std::uint32_t find_visible();
    ECODS_ALWAYS_INLINE std::uint32_t find_border(std::uint32_t visible_count);
    ECODS_ALWAYS_INLINE void set_face(std::uint32_t i, std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept;
    void remove_face(std::uint32_t i) noexcept;
    void add_space();
    // Returns true if the lists of vertices and faces have space for one more step, with faces read four at a time.
    bool has_space() const noexcept {
        return face_count_ + border_max + 4 <= h_.size() && vertex_count_ + 8 <= vertices_.size();
    }

    static constexpr std::uint32_t border_max = 64;

    const convex::PosedHulls* hulls_ = nullptr;
    RoundedBounds bounds_;
    std::vector<double> nx_, ny_, nz_, h_, length_;
    std::vector<double> n_error_, h_error_;  // error bounds of each coordinate of n, and of h
    std::vector<double> nearness_;           // -h / length; -infinity after the last face
    std::vector<std::array<std::uint32_t, 3>> corners_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> visible_;
    std::array<BorderEdge, border_max + 3> border_{};
    std::uint32_t face_count_ = 0, vertex_count_ = 0, nearest_ = 0;
    double upper_ = 0;
};

}  // namespace ecods::depths
