// A PairProof proves a claim about every pair of triangles of two bodies by walking both trees.
#pragma once

#include <optional>
#include <vector>

#include "bvh/walks/open_pair.hpp"
#include "ecods/certificate.hpp"
#include "ecods/ids.hpp"
#include "query/certificate/contact_axis.hpp"
#include "query/certificate/exact_axis.hpp"
#include "query/certificate/exact_points.hpp"
#include "query/certificate/pair_axis.hpp"
#include "query/certificate/proof.hpp"
#include "query/distance/triangle_distances.hpp"

namespace ecods {

class PairProof {
  public:
    // Axes must prove boxes to be further apart than `least`: the distance that the claims distance and beyond name,
    // and 0 for other claims. `pair` must be bound to the bodies. All arguments must outlive this object.
    PairProof(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double least, TriangleDistances& pair,
              Proof& proof);

    enum class EndsAt : std::uint8_t { meeting, crossing };
    // Writes the proof and returns nullopt. The claim must be true, except that the bodies may cross, or, if `ends_at`
    // is meeting, share a point. If the bodies do so, returns two triangles that cross or share a point, and the proof
    // is unfinished. Axes between the two triangles `closest` are tried first.
    std::optional<TrianglePair> run(const std::optional<TrianglePair>& closest, EndsAt ends_at);

  private:
    // A SlabAxis caches the axis along the slab of a node or leaf.
    struct SlabAxis {
        static constexpr std::size_t none = ~std::size_t{0};
        std::size_t node = none;
        std::size_t at = none;  // index in axes_ once the proof uses it
        PairAxis axis{};
        SlabEnds ends{};
    };
    // A Trial holds the parameters with which an axis is tried. The axis is added to the proof only if it proves at
    // least `least` pairs. If `is_fine`, doubles test the pairs that floats leave open.
    struct Trial {
        int least;
        bool is_fine;
        const SlabEnds* of_x = nullptr;
        const SlabEnds* of_y = nullptr;
    };

    PairAxis bind(const Vec3& n) const { return pair_axis(bodies_[0], bodies_[1], n, least_); }
    template <class X, class Y>
    std::uint64_t open(const X& x, const Y& y);
    template <class X, class Y>
    std::uint64_t try_axes(const X& x, const Y& y, std::uint64_t all);
    void remember(std::size_t at);
    template <class X, class Y>
    void try_slabs(const X& x, const Y& y, bool is_fine, std::uint64_t& left);
    void try_features(const TreeLeaf& x, const TreeLeaf& y, std::uint64_t& left);
    template <class X, class Y>
    bool try_axis(PairAxis& axis, const X& x, const Y& y, const Trial& trial, std::uint64_t& left);
    template <class X>
    SlabAxis& slab_axis(const X& x, std::size_t body);
    Vec3 direction_of(std::uint32_t i, std::uint32_t j);
    SixCorners corners_of(std::uint32_t i, std::uint32_t j);
    AxisFormula formula_of(const DistanceInterval& interval, std::uint32_t i, std::uint32_t j) const;
    std::optional<AxisFormula> formula_for(std::uint32_t i, std::uint32_t j);
    bool add_contact(const AxisFormula& formula, std::uint32_t i, std::uint32_t j);
    template <class X, class Y>
    void try_contact(ContactAxis& contact, const X& x, const Y& y, std::uint64_t& left);
    void add_first_axes(const TrianglePair& closest, const AxisFormula& formula);
    bool visit(const NodePair& top);

    double least_;
    TriangleDistances& pair_;
    Proof& proof_;
    std::array<BodyFrame, 2> bodies_;
    std::array<Mat3, 2> normals_;
    std::vector<PairAxis> axes_;  // the first six are the normals of both trees' boxes
    std::vector<SlabAxis> slabs_;
    std::array<std::uint8_t, 128> slab_places_{};  // by hash of the node: 1 + index in slabs_, or 0
    std::array<std::size_t, 4> recent_{};
    std::size_t recent_count_ = 0;
    int contact_count_ = 0;  // number of pairs of leaves that the first axes left open
    int fine_count_ = 0;     // number of pairs of leaves that needed doubles
    std::vector<NodePair> stack_;
    std::optional<ExactPoints> points_;
    std::vector<ContactAxis> contacts_;
    EndsAt ends_at_ = EndsAt::crossing;
    std::optional<TrianglePair> found_;  // two triangles that ended the walk
};

}  // namespace ecods
