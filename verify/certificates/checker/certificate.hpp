// A certificate, as its text gives it. Only its form is checked here: that lines and fields are there, and what can be
// seen of a line without the meshes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "text.hpp"

namespace certificate_checker {

struct Pose {
    std::array<std::array<double, 3>, 3> R;  // by rows
    std::array<double, 3> t;
};

// Which vector of two triangles, one of a and one of b (README.md, "FORMULA"); `given` are three numbers instead.
enum class Kind : std::uint8_t { given, na, nb, x, ea, eb, c, vv, va, vb };
struct Formula {
    Kind kind = Kind::given;
    std::uint32_t i = 0;
    std::uint32_t j = 0;
};

struct AxisLine {
    std::size_t line = 0;
    Formula formula;
    std::array<double, 3> given{};
    std::array<std::uint32_t, 2> triangles{};  // of a and of b, by the callers' numbers
};

// Some of Proof::numbers.
struct Numbers {
    std::size_t first = 0;
    std::size_t count = 0;
};

struct Step {
    std::size_t line = 0;
    std::array<bool, 2> opens{};  // a's part, b's
    bool is_formula = false;      // the line begins with t
    Formula formula;
    Numbers axes;
    Numbers open;  // the pairs left open
};

enum class Question : std::uint8_t { disjoint, touching, crossing, distance, within, beyond, hit, miss };

struct Feature {
    char kind = 'v';  // v, e or f
    std::uint32_t triangle = 0;
    std::uint32_t k = 0;
};

struct Claim {
    std::size_t line = 0;
    std::string words;
    Question question = Question::disjoint;
    double number = 0;                               // D or S
    std::optional<std::array<Feature, 2>> features;  // F and G
    std::array<std::uint32_t, 2> triangles{};        // I and J
    bool has_steps = true;
};

// A claim with its axes and steps, up to the line `end`.
struct Proof {
    Claim claim;
    std::vector<AxisLine> axes;
    std::vector<Step> steps;
    std::vector<std::uint32_t> numbers;
    std::size_t end = 0;
};

struct Mesh;
struct PosedMesh {
    std::string digest;
    Pose pose;
    std::size_t line = 0;
    const Mesh* mesh = nullptr;  // once the digest is found
};

using Segment = std::array<std::array<double, 3>, 2>;
struct PairHead {
    PosedMesh a;
    std::optional<PosedMesh> b;
    Segment segment{};  // where there is no b
};

struct BodyId {
    std::uint32_t slot = 0;
    std::uint32_t generation = 0;
    friend auto operator<=>(const BodyId&, const BodyId&) = default;
};
using BodyPair = std::array<BodyId, 2>;

// Which bodies may meet: each is in a group that the other's mask has.
struct GroupFilter {
    std::uint64_t groups = 0;
    std::uint64_t mask = 0;
    friend auto operator<=>(const GroupFilter&, const GroupFilter&) = default;
};

struct WorldBody {
    BodyId id;
    GroupFilter filter;
    PosedMesh mesh;
};

// What stands before the first line `pair`.
struct WorldHead {
    std::optional<double> clearance;
    std::vector<WorldBody> bodies;       // ascending, each once; so are the pairs
    std::vector<BodyPair> switched_off;  // each of two of the bodies
};

// True if filters let a and b meet, and they are not switched off; a is the lesser.
bool may_meet(const WorldHead& head, const WorldBody& a, const WorldBody& b);
// How many pairs of bodies may not meet.
std::uint64_t count_unjudged(const WorldHead& head, Budget& budget);

// A line `pair` with the proof behind it.
struct Section {
    std::size_t line = 0;
    BodyPair pair;
    std::array<const WorldBody*, 2> bodies;
    bool is_second = false;  // of its pair
    Proof proof;
};

// How many pairs of a world meet, how many do or are within the clearance, and how many may not meet.
struct WorldCounts {
    std::size_t colliding = 0;
    std::size_t close = 0;
    std::uint64_t unjudged = 0;
};

inline constexpr std::string_view pair_first_line = "ecods-certificate 2";
inline constexpr std::string_view world_first_line = "ecods-world-certificate 2";
// Format 1, which began so, named meshes by a linear digest.
inline constexpr std::array<std::string_view, 2> old_first_lines = {"ecods-certificate 1", "ecods-world-certificate 1"};

Pose read_pose(Text& in);  // the next twelve fields

// Each reads from the line that follows the current one, and ends at the last line that belongs to it. All throw
// Refusal.
PairHead read_pair_head(Text& in);
void read_proof(Text& in, Proof& proof);
WorldHead read_world_head(Text& in);  // ends at the first line `pair`, or at `end world`
// Reads from the current line, which is the first behind the section before (if any); false at `end world`. Pairs are
// ascending, once each, or twice where the first section says that they are disjoint and there is a clearance; they
// may meet, and the claims are such as decide a pair.
bool read_section(Text& in, const WorldHead& head, Section& section);

}  // namespace certificate_checker
