// Everything that include/ecods/solid.hpp answers about two posed convex solids, judged by the oracle.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "judge/distance_truth.hpp"
#include "judge/wrong.hpp"
#include "oracle/convex.hpp"

namespace ecods::judge {

// As the library writes it.
Depth to_depth(const oracle::ExactDepth& exact);

// Whether all of it is the same, bit for bit.
bool is_same(const Depth& x, const Depth& y);
bool is_same(const SignedDistance& x, const SignedDistance& y);

// In hexadecimal floats.
std::string text(const Depth& depth);
std::string text(const SignedDistance& distance);

// What is true of two convex solids, known before the library is asked: it may be asked in any floating-point
// environment. Poses are regular.
class ConvexTruth {
  public:
    ConvexTruth(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b);

    double distance() const { return of_[0].closest ? of_[0].closest->distance : 0; }
    const std::optional<Depth>& depth() const { return of_[0].depth; }  // nothing if they share no point
    const SignedDistance& signed_distance() const { return of_[0].signed_distance; }
    const oracle::ConvexPair& exact() const { return *exact_; }

    // What is so of the pair, in a word: of the distance its kind, of the depth what its normal comes from.
    std::string kind() const;

    // The same, to be asked of other solids of the same meshes.
    ConvexTruth with(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b) const;

    // Asks for distance, closest features, depth and signed distance in both orders, with the witness, which may come
    // from anywhere, and without, and in the thread's own memory.
    std::optional<Wrong> ask(QueryMemory& memory, PairWitness& witness) const;

    // Whether depth_bounds() hold. In the usual environment.
    std::optional<Wrong> ask_bounds(QueryMemory& memory) const;

    // Whether vectors that reach the depth along the normal part the solids, and `count` random ones that are shorter
    // do not: of the depth that the library gives, by the oracle's set of differences.
    std::optional<Wrong> ask_translations(QueryMemory& memory, std::span<const Vec3> directions) const;

  private:
    struct Answers {
        std::optional<ClosestPoints> closest;
        std::optional<Depth> depth;
        SignedDistance signed_distance;
    };
    static Answers answers_of(const oracle::ConvexPair& pair);
    std::optional<Wrong> ask_in_order(std::size_t order, const Ask& ask) const;

    std::array<Posed<ConvexSolid>, 2> solids_;
    std::shared_ptr<const oracle::ConvexPair> exact_;
    std::array<Answers, 2> of_;  // of (a, b), and of (b, a)
};

// What the hull of points is: convex_hull() beside the oracle, which tries all planes through three.
std::optional<Wrong> ask_for_hull(std::span<const Vec3> points);

// Whether a mesh that bounds a solid is convex.
std::optional<Wrong> ask_whether_convex(const std::shared_ptr<const Mesh>& mesh);

}  // namespace ecods::judge
