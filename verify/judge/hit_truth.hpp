// Everything that include/ecods/hit.hpp answers about a segment or ray and a body, judged by the oracle.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ecods/hit.hpp"
#include "judge/distance_truth.hpp"
#include "oracle/hits.hpp"

namespace ecods::judge {

using HitLine = std::variant<Segment, Ray>;

// As the library writes it.
std::vector<Hit> to_hits(const std::vector<oracle::ExactHit>& exact);

// Whether all of it is the same, bit for bit.
bool is_same(const Hit& x, const Hit& y);

// In hexadecimal floats.
std::string text(const Hit& hit);
std::string text(const HitLine& line);

// What the oracle says of a line and a posed mesh.
std::vector<oracle::ExactHit> exact_hits(const HitLine& line, const Posed<MeshShape>& body);

// What is true of a line and a body, known before the library is asked: it may be asked in any floating-point
// environment. Beside the line itself: a segment the other way round, and as a ray where its direction is a double; a
// ray that ends at its first and last hit, and at the doubles beside these.
class HitTruth {
  public:
    HitTruth(const HitLine& line, const Posed<MeshShape>& body);

    const std::vector<Hit>& hits() const { return questions_.front().expected; }

    // Asks all of it, with the witness, which may come from anywhere, and in the thread's own memory.
    std::optional<Wrong> ask(QueryMemory& memory, PairWitness& witness) const;

  private:
    struct Question {
        HitLine line;
        std::vector<Hit> expected;
    };
    void add(const HitLine& line);
    void add_as_ray(const Segment& segment);
    void add_limits(Ray ray);
    std::optional<Wrong> ask(const Question& question, QueryMemory& memory, PairWitness& witness) const;

    Posed<MeshShape> body_;
    std::vector<Question> questions_;
};

}  // namespace ecods::judge
