// ecods_check_certificate [--exact] [--times] CERTIFICATE [MESH...]   (README.md)
//
// --exact: no doubles are asked, integers decide everything (README.md, section 6); the work has no limit then.
// --times: prints how long the meshes took to read, and of each certificate how long its check took and how many steps
// and units of work it has; and at the end the medians of the certificates behind the first.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <limits>
#include <map>

#include "claims.hpp"
#include "memory.hpp"
#include "mesh.hpp"

namespace certificate_checker {
namespace {

class Program {
  public:
    Program(bool is_exact, bool prints_times) : is_exact_(is_exact), prints_times_(prints_times) {}

    // All throw Unreadable.
    void read(const char* path);
    int check(const char* path);

  private:
    using Clock = std::chrono::steady_clock;
    void find_mesh(PosedMesh& wanted) const;
    std::string check_certificate(Text& in);
    bool print_verdict(Text& in);
    void print_medians();

    static double microseconds(Clock::duration time) { return std::chrono::duration<double, std::micro>(time).count(); }

    bool is_exact_, prints_times_;
    std::map<std::string, Mesh, std::less<>> meshes_;
    double reading_ = 0;          // microseconds
    std::vector<double> checks_;  // likewise, of each certificate
    Budget budget_;
    Proof proof_;
};

void Program::find_mesh(PosedMesh& wanted) const {
    const auto found = meshes_.find(wanted.digest);
    if (found == meshes_.end()) throw Refusal{wanted.line, "no mesh has the digest " + wanted.digest.substr(0, 64)};
    wanted.mesh = &found->second;
}

void Program::read(const char* path) {
    const auto begin = Clock::now();
    try {
        Mesh mesh = read_mesh(path);
        Mesh& place = meshes_[mesh.digest];
        place = std::move(mesh);
    } catch (const Unreadable& problem) {
        throw Unreadable{std::string(path) + ": " + problem.why};
    }
    reading_ += microseconds(Clock::now() - begin);
}

// From its first line, which is the current one. Returns the claim.
std::string Program::check_certificate(Text& in) {
    if (in.line() == world_first_line) {
        proof_ = {};
        WorldHead head = read_world_head(in);
        for (WorldBody& body : head.bodies) find_mesh(body.mesh);
        const WorldCounts counts = check_world(in, head, budget_);
        std::string words = "world of " + std::to_string(head.bodies.size()) + " bodies, " +
                            std::to_string(counts.colliding) + " colliding, ";
        if (head.clearance) words += std::to_string(counts.close) + " close, ";
        return words + std::to_string(counts.unjudged) + (counts.unjudged == 1 ? " pair" : " pairs") + " not judged";
    }
    if (std::ranges::find(old_first_lines, in.line()) != old_first_lines.end()) {
        in.fail("format 1: its mesh digests can be forged; issue the certificate again");
    }
    if (in.line() != pair_first_line) in.fail("not the first line of a certificate");
    PairHead head = read_pair_head(in);
    read_proof(in, proof_);
    find_mesh(head.a);
    if (head.b) {
        find_mesh(*head.b);
        check_pair(head.a, *head.b, proof_, budget_);
    } else {
        check_segment(head.a, head.segment, proof_, budget_);
    }
    return proof_.claim.words;
}

// Ends at the last line of the certificate, or before the first line of the next.
bool Program::print_verdict(Text& in) {
    const auto begin = Clock::now();
    const std::uint64_t budget = budget_.left;
    std::optional<Refusal> refusal;
    std::string claim;
    try {
        claim = check_certificate(in);
    } catch (const Refusal& why) {
        refusal = why;
    } catch (const TooCostly&) {
        refusal = {in.line_number(), "too costly"};
    }
    const double time = microseconds(Clock::now() - begin);
    if (refusal) {
        std::printf("refused: line %zu: %s\n", refusal->line, refusal->why.c_str());
    } else {
        std::printf("accepted: %s\n", claim.c_str());
    }
    checks_.push_back(time);
    if (prints_times_) {
        std::printf("  %.1f us, %zu steps, %llu units\n", time, proof_.steps.size(),
                    static_cast<unsigned long long>(budget - budget_.left));
    }
    return !refusal;
}

void Program::print_medians() {
    const double first = reading_ + checks_.front();
    std::printf("reading the meshes: %.1f us; with the first check: %.1f us (%.2f times)\n", reading_, first,
                first / reading_);
    if (checks_.size() < 2) return;
    const auto middle = checks_.begin() + static_cast<std::ptrdiff_t>(checks_.size() / 2);
    std::nth_element(checks_.begin() + 1, std::max(middle, checks_.begin() + 1), checks_.end());
    std::printf("each further check: %.1f us (median; 1/%.1f)\n", *std::max(middle, checks_.begin() + 1),
                first / *std::max(middle, checks_.begin() + 1));
}

int Program::check(const char* path) {
    std::string text;
    try {
        text = read_file(path);
    } catch (const Unreadable& problem) {
        throw Unreadable{std::string(path) + ": " + problem.why};
    }
    budget_.left = (std::uint64_t{1} << 33) + 4096 * std::uint64_t{text.size()};
    if (is_exact_) budget_ = {std::numeric_limits<std::uint64_t>::max(), false};
    const auto is_first_line = [](const Text& in) {
        return in.line() == pair_first_line || in.line() == world_first_line ||
               std::ranges::find(old_first_lines, in.line()) != old_first_lines.end();
    };
    Text in(text);
    bool is_good = !text.empty();
    if (text.empty()) std::puts("refused: line 1: no certificate");
    for (bool has_line = in.skip_line(); has_line;) {
        const std::size_t first = in.line_number();
        const bool is_accepted = print_verdict(in);
        is_good = is_good && is_accepted;
        // A refused certificate may end anywhere.
        if (is_accepted || in.line_number() == first || !is_first_line(in)) has_line = in.skip_line();
        while (!is_accepted && has_line && !is_first_line(in)) has_line = in.skip_line();
    }
    if (prints_times_ && !checks_.empty()) print_medians();
    return is_good ? 0 : 1;
}

int run(int count, char** arguments) {
    int first = 1;
    bool is_exact = false, prints_times = false;
    for (; first < count && std::strncmp(arguments[first], "--", 2) == 0; ++first) {
        const bool is_times = std::strcmp(arguments[first], "--times") == 0;
        if (!is_times && std::strcmp(arguments[first], "--exact") != 0) count = 0;
        (is_times ? prints_times : is_exact) = true;
    }
    if (count - first < 1) {
        std::fputs("usage: ecods_check_certificate [--exact] [--times] CERTIFICATE [MESH...]\n", stderr);
        return 2;
    }
    try {
        Program program(is_exact, prints_times);
        for (int i = first + 1; i < count; ++i) program.read(arguments[i]);
        return program.check(arguments[first]);
    } catch (const Unreadable& problem) {
        std::printf("unreadable: %s\n", problem.why.c_str());
    } catch (const std::bad_alloc&) {
        std::puts("unreadable: out of memory");
    }
    return 2;
}

}  // namespace
}  // namespace certificate_checker

int main(int count, char** arguments) {
    certificate_checker::keep_memory_of_numbers();
    return certificate_checker::run(count, arguments);
}
