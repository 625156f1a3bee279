#include "base/number_text.hpp"
#include "query/certificate/certificate_content.hpp"

namespace ecods {
namespace {

using Claim = Certificate::Claim;
using Kind = AxisFormula::Kind;

void append_count(std::string& text, std::uint64_t x) {
    text.push_back(' ');
    append(text, x);
}

void append_feature(std::string& text, const Feature& feature) {
    switch (feature.kind) {
        case Feature::Kind::vertex:
            text.append(" v");
            break;
        case Feature::Kind::edge:
            text.append(" e");
            break;
        case Feature::Kind::face:
            text.append(" f");
            append_count(text, feature.triangle);
            return;
    }
    append_count(text, feature.triangle);
    append_count(text, feature.corner);
}

void append_claim(std::string& text, const CertificateAccess::Content& c) {
    static constexpr const char* names[] = {"disjoint", "touching", "crossing", "distance",
                                            "within",   "beyond",   "hit",      "miss"};
    text.append("claim ").append(names[static_cast<std::size_t>(c.claim)]);
    const bool has_value = c.claim >= Claim::distance && c.claim <= Claim::hit;
    const bool is_infinite = c.value > 0x1.fffffffffffffp1023;
    if (has_value) {
        text.push_back(' ');
        if (is_infinite) {
            text.append("inf");
        } else {
            append_hex(text, c.value);
        }
    }
    if (c.claim == Claim::hit) append_count(text, c.a.triangle);
    if (c.claim == Claim::touching || c.claim == Claim::crossing || c.names_triangles) {
        append_count(text, c.a.triangle);
        append_count(text, c.b.triangle);
    } else if (c.claim == Claim::within || (c.claim == Claim::distance && !is_infinite)) {
        append_feature(text, c.a);
        append_feature(text, c.b);
    }
    text.push_back('\n');
}

void append_axis(std::string& text, const ProofAxis& axis) {
    text.append("axis");
    const AxisFormula& f = axis.formula;
    if (axis.is_given) {
        append_coordinates(text, axis.given);
    } else if (f.kind == Kind::normal_a) {
        text.append(" na");
        append_count(text, axis.a);
    } else if (f.kind == Kind::normal_b) {
        text.append(" nb");
        append_count(text, axis.b);
    } else {
        text.append(" x");
        append_count(text, axis.a);
        append_count(text, f.i);
        append_count(text, axis.b);
        append_count(text, f.j);
    }
    text.push_back('\n');
}

void append_formula(std::string& text, Kind kind, std::uint64_t i, std::uint64_t j) {
    static constexpr const char* names[] = {" na", " nb", " x", " ea", " eb", " c", " vv", " va", " vb"};
    text.append(names[static_cast<std::size_t>(kind)]);
    if (kind == Kind::normal_a || kind == Kind::normal_b) return;
    append_count(text, i);
    if (kind != Kind::coordinate) append_count(text, j);
}

// Appends one step. Returns the index of the next one.
std::size_t append_step(std::string& text, const std::vector<Proof::Word>& words, std::size_t at) {
    static constexpr const char* names[] = {"ab", "a", "b", "t"};
    const auto kind = static_cast<StepKind>(words[at++]);
    text.append(names[static_cast<std::size_t>(kind)]);
    if (kind == StepKind::triangles) {
        append_formula(text, static_cast<Kind>(words[at]), words[at + 1], words[at + 2]);
        at += 3;
    } else {
        for (std::size_t count = words[at++]; count > 0; --count) append_count(text, words[at++]);
        std::size_t left = words[at++];
        if (left > 0) text.append(" |");
        for (; left > 0; --left) append_count(text, words[at++]);
    }
    text.push_back('\n');
    return at;
}

}  // namespace

void append_coordinates(std::string& text, const Vec3& point) {
    for (int axis = 0; axis < 3; ++axis) {
        text.push_back(' ');
        append_hex(text, point[axis]);
    }
}

void append_proof(std::string& text, const CertificateAccess::Content& content) {
    append_claim(text, content);
    for (const ProofAxis& axis : content.proof.axes) append_axis(text, axis);
    for (std::size_t at = 0; at < content.proof.words.size();) at = append_step(text, content.proof.words, at);
    text.append("end\n");
}

void append_body(std::string& text, const MeshShape& shape, const Pose& pose) {
    text.append(certified_mesh_digest(shape));
    for (int row = 0; row < 3; ++row) {
        append_coordinates(text, pose.R.row(row));
        text.push_back(' ');
        append_hex(text, pose.t[row]);
    }
    text.push_back('\n');
}

}  // namespace ecods
