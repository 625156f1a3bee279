#include <array>

#include "geometry/words.hpp"
#include "query/certificate/certificate_content.hpp"

namespace ecods {
namespace {

using Claim = Certificate::Claim;
using Kind = AxisFormula::Kind;

void append_feature(std::string& text, const Feature& feature) {
    static constexpr std::array names{"v", "e", "f"};
    append_words(text, names[static_cast<std::size_t>(feature.kind)], feature.triangle);
    if (feature.kind != Feature::Kind::face) append_words(text, feature.corner);
}

void append_claim(std::string& text, const CertificateAccess::Content& c) {
    static constexpr std::array names{"disjoint", "touching", "crossing", "distance",
                                      "within",   "beyond",   "hit",      "miss"};
    append_words(text, "claim", names[static_cast<std::size_t>(c.claim)]);
    const bool has_value = c.claim >= Claim::distance && c.claim <= Claim::hit;
    const bool is_infinite = c.value > 0x1.fffffffffffffp1023;
    if (has_value) append_words(text, c.value);
    if (c.claim == Claim::hit) append_words(text, c.a.triangle);
    if (c.claim == Claim::touching || c.claim == Claim::crossing || c.names_triangles) {
        append_words(text, c.a.triangle, c.b.triangle);
    } else if (c.claim == Claim::within || (c.claim == Claim::distance && !is_infinite)) {
        append_feature(text, c.a);
        append_feature(text, c.b);
    }
    end_line(text);
}

void append_axis(std::string& text, const ProofAxis& axis) {
    const AxisFormula& f = axis.formula;
    if (axis.is_given) {
        append_line(text, "axis", axis.given);
    } else if (f.kind == Kind::normal_a) {
        append_line(text, "axis na", axis.a);
    } else if (f.kind == Kind::normal_b) {
        append_line(text, "axis nb", axis.b);
    } else {
        append_line(text, "axis x", axis.a, f.i, axis.b, f.j);
    }
}

void append_formula(std::string& text, Kind kind, std::uint64_t i, std::uint64_t j) {
    static constexpr std::array names{"na", "nb", "x", "ea", "eb", "c", "vv", "va", "vb"};
    append_words(text, names[static_cast<std::size_t>(kind)]);
    if (kind == Kind::normal_a || kind == Kind::normal_b) return;
    append_words(text, i);
    if (kind != Kind::coordinate) append_words(text, j);
}

// Appends the text of the step at words[at]. Returns the index of the next step.
std::size_t append_step(std::string& text, const std::vector<Proof::Word>& words, std::size_t at) {
    static constexpr std::array names{"ab", "a", "b", "t"};
    const auto kind = static_cast<StepKind>(words[at++]);
    append_words(text, names[static_cast<std::size_t>(kind)]);
    if (kind == StepKind::triangles) {
        append_formula(text, static_cast<Kind>(words[at]), words[at + 1], words[at + 2]);
        at += 3;
    } else {
        for (std::size_t count = words[at++]; count > 0; --count) append_words(text, words[at++]);
        std::size_t left = words[at++];
        if (left > 0) append_words(text, "|");
        for (; left > 0; --left) append_words(text, words[at++]);
    }
    end_line(text);
    return at;
}

}  // namespace

void append_proof(std::string& text, const CertificateAccess::Content& content) {
    append_claim(text, content);
    for (const ProofAxis& axis : content.proof.axes) append_axis(text, axis);
    for (std::size_t at = 0; at < content.proof.words.size();) at = append_step(text, content.proof.words, at);
    text.append("end\n");
}

}  // namespace ecods
