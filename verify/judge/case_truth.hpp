// Cases of the families, with their bodies and what is true of them: the same for tests and for the fuzzer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/cast_truth.hpp"
#include "judge/convex_truth.hpp"
#include "judge/distance_truth.hpp"
#include "judge/hit_truth.hpp"
#include "judge/solid_truth.hpp"
#include "judge/turn_truth.hpp"
#include "scenes/cast_cases.hpp"
#include "scenes/convex_cases.hpp"
#include "scenes/distance_cases.hpp"
#include "scenes/hit_cases.hpp"
#include "scenes/solid_cases.hpp"
#include "scenes/turn_cases.hpp"

namespace ecods::judge {

// A case of each question has `Judged<Case>`: its bodies, and their `truth`.
template <class Case>
struct Judged;

template <>
struct Judged<scenes::CastCase> {
    MeshShape a, b;
    CastTruth truth;

    explicit Judged(const scenes::CastCase& made, int samples = 8)
        : a(made.a), b(made.b), truth({a, made.pose_a}, made.motion, {b, made.pose_b}, samples) {}
};

template <>
struct Judged<scenes::MoveCase> {
    MeshShape a, b;
    CastTruth truth;

    explicit Judged(const scenes::MoveCase& made, int samples = 8)
        : a(made.a), b(made.b), truth({a, made.from_a, made.to_a}, {b, made.from_b, made.to_b}, samples) {}
};

template <>
struct Judged<scenes::TurnCase> {
    MeshShape a, b;
    TurnTruth truth;

    explicit Judged(const scenes::TurnCase& made, int samples = 8)
        : a(made.a), b(made.b), truth({a, made.pose_a, made.turn}, {b, made.pose_b}, samples) {}
};

template <>
struct Judged<scenes::HitCase> {
    MeshShape shape;
    HitTruth truth;

    explicit Judged(const scenes::HitCase& made) : shape(made.mesh), truth(made.line, {shape, made.pose}) {}
};

template <>
struct Judged<scenes::DistanceCase> {
    MeshShape a, b;
    DistanceTruth truth;

    explicit Judged(const scenes::DistanceCase& made, const Questions& questions = {})
        : a(made.a), b(made.b), truth({a, made.pose_a}, {b, made.pose_b}, questions) {}
};

template <>
struct Judged<scenes::ConvexCase> {
    ConvexSolid a, b;
    ConvexTruth truth;

    explicit Judged(const scenes::ConvexCase& made)
        : a(made.a.mesh), b(made.b.mesh), truth({a, made.a.pose}, {b, made.b.pose}) {}
};

template <>
struct Judged<scenes::SolidCase> {
    Solid a, b;
    SolidTruth truth;

    explicit Judged(const scenes::SolidCase& made)
        : a(made.a.mesh), b(made.b.mesh), truth({a, made.a.pose}, {b, made.b.pose}, made.known_points()) {}
};

// Asks all, with the witness where the questions take one.
template <class Truth>
std::optional<Wrong> ask(const Truth& truth, QueryMemory& memory, PairWitness& witness) {
    if constexpr (requires { truth.ask(memory, witness); }) {
        return truth.ask(memory, witness);
    } else {
        return truth.ask(memory);
    }
}

// What is true, in a word: the kind of the first contact, of the first hit or of the closest points, or "nothing"; of
// convex solids ConvexTruth::kind(); of solids their relation.
std::string kind_of(const CastTruth& truth);
std::string kind_of(const TurnTruth& truth);
std::string kind_of(const HitTruth& truth);
std::string kind_of(const DistanceTruth& truth);
std::string kind_of(const ConvexTruth& truth);
std::string kind_of(const SolidTruth& truth);

// A promise of the recipe of a case, beside what the oracle found.
struct Promise {
    bool is_kept;
    std::string promised;
    std::string found;
};

// All that its recipe knows of a case; of a point where it is, if that is finite.
std::vector<Promise> promises_of(const scenes::CastCase& made, const CastTruth& truth);
std::vector<Promise> promises_of(const scenes::MoveCase& made, const CastTruth& truth);
std::vector<Promise> promises_of(const scenes::TurnCase& made, const TurnTruth& truth);
std::vector<Promise> promises_of(const scenes::HitCase& made, const HitTruth& truth);
std::vector<Promise> promises_of(const scenes::DistanceCase& made, const DistanceTruth& truth);
std::vector<Promise> promises_of(const scenes::ConvexCase& made, const ConvexTruth& truth);
std::vector<Promise> promises_of(const scenes::SolidCase& made, const SolidTruth& truth);

}  // namespace ecods::judge
