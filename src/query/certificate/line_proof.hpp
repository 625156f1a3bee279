// The walk of a tree that proves that a segment, or its piece before the first hit, meets none of its triangles.
#pragma once

#include <vector>

#include "ecods/segment.hpp"
#include "query/certificate/exact_axis.hpp"
#include "query/certificate/proof.hpp"
#include "query/certificate/proof_axes.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

class LineProof {
  public:
    // The piece goes from parameter 0 to `end`. `apart` is half_open where triangles may be met at the very end. All
    // must outlive this.
    LineProof(const Posed<MeshShape>& body, const Segment& segment, const Parameter& end, ApartBy apart, Proof& proof);

    // The claim must be true.
    void run();

  private:
    using Word = Proof::Word;
    static constexpr Word no_axis = 0xffff;

    struct Axis {
        Vec3 n;
        BodyAxis a;
        double low = 0, high = 0;  // of the piece, enlarged by all errors
        bool is_bounded = false;
        Word named = no_axis;
    };

    Axis bind(const Vec3& n) const;
    void add_axes();
    template <class X>
    std::uint32_t open(const X& x);
    void visit(TreeRef top);
    AxisFormula likely_axis(const Triangle& triangle) const;
    void decide(std::uint32_t triangle);

    const Posed<MeshShape>& body_;
    const MeshTree& tree_;
    BodyFrame frame_;
    ApartBy apart_;
    Proof& proof_;
    Vec3 from_, to_;  // of the piece, less the body's translation, about
    double parameter_;
    ExactPoints points_;
    IntegerVector3 exact_from_, exact_to_;
    std::vector<Axis> axes_;
    std::vector<Word> of_step_;
    std::vector<TreeRef> stack_;
};

}  // namespace ecods
