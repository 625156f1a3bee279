#include "certificate.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace certificate_checker {
namespace {

std::uint32_t below(Text& in, std::uint32_t end, const char* why) {
    const std::uint32_t value = in.count();
    if (value >= end) in.fail(why);
    return value;
}

std::uint32_t corner(Text& in) {
    return below(in, 3, "0, 1 or 2 expected");
}

PosedMesh read_posed_mesh(Text& in) {
    PosedMesh mesh;
    mesh.line = in.line_number();
    mesh.digest = in.word();
    mesh.pose = read_pose(in);
    in.end_of_line();
    return mesh;
}

Feature read_feature(Text& in) {
    Feature feature;
    const std::string_view kind = in.word();
    if (kind != "v" && kind != "e" && kind != "f") in.fail("no such feature");
    feature.kind = kind[0];
    feature.triangle = in.count();
    if (feature.kind != 'f') feature.k = corner(in);
    return feature;
}

// Two triangles that meet, or two features.
void read_upper_end(Text& in, Claim& claim, bool is_zero) {
    if (is_zero || (in.peek() != "v" && in.peek() != "e" && in.peek() != "f")) {
        for (std::uint32_t& triangle : claim.triangles) triangle = in.count();
        return;
    }
    claim.features = {read_feature(in), read_feature(in)};
    const char kinds[] = {(*claim.features)[0].kind, (*claim.features)[1].kind};
    if (kinds[0] != 'v' && kinds[1] != 'v' && (kinds[0] == 'f' || kinds[1] == 'f')) in.fail("no such pair of features");
}

double distance_or_infinity(Text& in) {
    if (in.peek() != "inf") return in.distance();
    in.word();
    return std::numeric_limits<double>::infinity();
}

void read_numbers(Text& in, Claim& claim) {
    const double infinity = std::numeric_limits<double>::infinity();
    switch (claim.question) {
        case Question::disjoint:
        case Question::miss:
            break;
        case Question::touching:
        case Question::crossing:
            read_upper_end(in, claim, true);
            break;
        case Question::distance:
            claim.number = distance_or_infinity(in);
            if (claim.number == infinity) break;
            read_upper_end(in, claim, claim.number == 0);
            if (claim.number != 0 && !claim.features) in.fail("features expected");
            break;
        case Question::within:
            claim.number = distance_or_infinity(in);
            read_upper_end(in, claim, false);
            break;
        case Question::beyond:
            claim.number = in.distance();
            break;
        case Question::hit:
            claim.number = in.distance();
            if (claim.number > 1) in.fail("a parameter above 1");
            claim.triangles[0] = in.count();
            break;
    }
}

Claim read_claim(Text& in) {
    static constexpr std::pair<std::string_view, Question> questions[] = {
        {"disjoint", Question::disjoint}, {"touching", Question::touching}, {"crossing", Question::crossing},
        {"distance", Question::distance}, {"within", Question::within},     {"beyond", Question::beyond},
        {"hit", Question::hit},           {"miss", Question::miss}};
    Claim claim;
    claim.line = in.line_number();
    in.expect("claim");
    claim.words = in.line().substr(std::min(in.line().size(), sizeof "claim"));
    const std::string_view word = in.word();
    const auto* const found =
        std::find_if(std::begin(questions), std::end(questions), [&](const auto& each) { return each.first == word; });
    if (found == std::end(questions)) in.fail("no such claim");
    claim.question = found->second;
    read_numbers(in, claim);
    in.end_of_line();
    const bool has_zero = claim.question == Question::distance || claim.question == Question::hit;
    claim.has_steps =
        claim.question != Question::crossing && claim.question != Question::within && !(has_zero && claim.number == 0);
    return claim;
}

// A formula's kind is `word`; what follows it is read.
Formula read_formula(Text& in, std::string_view word) {
    static constexpr std::pair<std::string_view, Kind> kinds[] = {{"na", Kind::na}, {"nb", Kind::nb}, {"x", Kind::x},
                                                                  {"ea", Kind::ea}, {"eb", Kind::eb}, {"c", Kind::c},
                                                                  {"vv", Kind::vv}, {"va", Kind::va}, {"vb", Kind::vb}};
    const auto* const found =
        std::find_if(std::begin(kinds), std::end(kinds), [&](const auto& each) { return each.first == word; });
    if (found == std::end(kinds)) in.fail("no such formula");
    Formula formula{found->second, 0, 0};
    if (formula.kind == Kind::na || formula.kind == Kind::nb) return formula;
    formula.i = corner(in);
    if (formula.kind != Kind::c) formula.j = corner(in);
    return formula;
}

AxisLine read_axis(Text& in) {
    AxisLine axis;
    axis.line = in.line_number();
    in.expect("axis");
    if (in.peek() == "na" || in.peek() == "nb") {
        axis.formula.kind = in.word() == "na" ? Kind::na : Kind::nb;
        axis.triangles[axis.formula.kind == Kind::na ? 0 : 1] = in.count();
    } else if (in.peek() == "x") {
        in.word();
        axis.formula.kind = Kind::x;
        axis.triangles[0] = in.count();
        axis.formula.i = corner(in);
        axis.triangles[1] = in.count();
        axis.formula.j = corner(in);
    } else {
        for (double& x : axis.given) x = in.number();
    }
    in.end_of_line();
    return axis;
}

// Reads steps; knows which axes a line has named.
class StepReader {
  public:
    StepReader(Text& in, Proof& proof) : in_(in), proof_(proof) {}

    Step read() {
        Step step;
        step.line = in_.line_number();
        const std::string_view word = in_.word();
        if (word == "t") {
            step.is_formula = true;
            step.formula = read_formula(in_, in_.word());
            in_.end_of_line();
            return step;
        }
        step.opens = {word == "ab" || word == "a", word == "ab" || word == "b"};
        const bool is_opened = step.opens[0] || step.opens[1];
        if (!is_opened && word != "k") in_.fail("no such step");
        step.axes.first = proof_.numbers.size();
        while (!in_.is_at_end() && !in_.begins_with('|') && (is_opened || step.axes.count == 0)) {
            proof_.numbers.push_back(axis(step.line));
            ++step.axes.count;
        }
        if (!is_opened && step.axes.count == 0) in_.fail("an axis is missing");
        if (is_opened && !in_.is_at_end()) read_open(step);
        in_.end_of_line();
        return step;
    }

  private:
    std::uint32_t axis(std::size_t line) {
        const std::uint32_t number = below(in_, static_cast<std::uint32_t>(proof_.axes.size()), "no such axis");
        named_.resize(proof_.axes.size());
        if (std::exchange(named_[number], line) == line) in_.fail("an axis is named twice");
        return number;
    }

    void read_open(Step& step) {
        in_.expect("|");
        step.open.first = proof_.numbers.size();
        do {
            const std::uint32_t pair = in_.count();
            if (step.open.count > 0 && pair <= proof_.numbers.back()) in_.fail("pairs are not ascending");
            proof_.numbers.push_back(pair);
            ++step.open.count;
        } while (!in_.is_at_end());
    }

    Text& in_;
    Proof& proof_;
    std::vector<std::size_t> named_;  // the last line that named each axis
};

}  // namespace

Pose read_pose(Text& in) {
    Pose pose{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (double& x : pose.R[i]) x = in.number();
        pose.t[i] = in.number();
    }
    return pose;
}

PairHead read_pair_head(Text& in) {
    PairHead head;
    in.require_line();
    in.expect("a");
    head.a = read_posed_mesh(in);
    in.require_line();
    if (in.peek() == "b") {
        in.expect("b");
        head.b = read_posed_mesh(in);
        return head;
    }
    in.expect("segment");
    for (auto& point : head.segment) {
        for (double& x : point) x = in.number();
    }
    in.end_of_line();
    return head;
}

void read_proof(Text& in, Proof& proof) {
    in.require_line();
    proof.claim = read_claim(in);
    proof.axes.clear();
    proof.steps.clear();
    proof.numbers.clear();
    StepReader steps(in, proof);
    for (in.require_line(); in.line() != "end"; in.require_line()) {
        if (!proof.claim.has_steps) in.fail("this claim has no steps");
        if (in.peek() == "axis") {
            proof.axes.push_back(read_axis(in));
        } else {
            proof.steps.push_back(steps.read());
        }
    }
    proof.end = in.line_number();
}

}  // namespace certificate_checker
