#include "fuzz/checks/certificates.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "certificates/folder/certificate_folder.hpp"
#include "ecods/distance.hpp"
#include "ecods/hit.hpp"
#include "ecods/intersection.hpp"
#include "fuzz/base/failure.hpp"
#include "fuzz/checks/any_pair.hpp"
#include "fuzz/checks/text.hpp"
#include "process/program.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

struct Certificates::Pair {
    BodyPair ids;
    Posed<MeshShape> a, b;
};

namespace {

using Claim = Certificate::Claim;

constexpr std::array claims{"disjoint", "touching", "crossing", "distance", "within", "beyond", "hit", "miss"};
// Checking is exact, and takes some microseconds for a pair of triangles that the proof names.
constexpr std::size_t triangle_pairs_max = 20000;
// Lists of a world: one frame of so many, where it has few bodies.
constexpr std::uint32_t frames_a_world = 8;
constexpr std::size_t bodies_max = 12;

// A vertex, as posed in doubles; the origin where that overflows.
Vec3 any_point(const Posed<MeshShape>& body, scenes::Random& random) {
    const auto vertices = body.what->mesh().vertices();
    const Vec3 v = vertices[random.below(static_cast<std::uint32_t>(vertices.size()))];
    const Vec3 point = body.pose.R * v + body.pose.t;
    return point.allFinite() ? point : Vec3(0, 0, 0);
}

// The distance itself and its neighbours are where a proof has no room.
double any_limit(double distance, scenes::Random& random) {
    const std::array limits{distance, std::nextafter(distance, 0), 2 * distance, 0.0};
    return std::min(limits[random.below(limits.size())], std::numeric_limits<double>::max());
}

std::string words(const std::string& claim, const std::optional<double>& value) {
    return value ? fmt::format("{} {:a}", claim, *value) : claim;
}

// The checkers' words about the pairs of bodies that filters and set_pair_enabled() leave out.
std::string words_of_unjudged(const World& world) {
    std::size_t count = 0;
    const auto bodies = world.bodies();
    for (const BodyId a : bodies) {
        for (const BodyId b : bodies) {
            if (!(a < b)) continue;
            if (!may_meet(world, a, b)) ++count;
        }
    }
    return fmt::format("{} {} not judged", count, count == 1 ? "pair" : "pairs");
}

// Without its last step. False: it has none.
bool spoil(std::string& text) {
    const std::size_t end = text.rfind("\nend\n");
    const std::size_t begin = end == 0 || end == std::string::npos ? end : text.rfind('\n', end - 1);
    if (begin == std::string::npos) return false;
    const std::string line = text.substr(begin + 1, end - begin - 1);
    if (line.starts_with("claim ") || line.starts_with("axis ")) return false;
    text.erase(begin, end - begin);
    return true;
}

}  // namespace

void Certificates::ask(const World& world, const Truth& truth, std::uint32_t frame, Counters& counters) {
    if (frame % frames_a_world == 0) ask_world(world, frame, counters);
    scenes::Random random(frame);
    const auto drawn = AnyPair(world, truth).draw(random, triangle_pairs_max);
    if (!drawn) return;
    const auto& [a, b] = *drawn;
    const auto shape_a = surface_shape(world.shape(a->id)), shape_b = surface_shape(world.shape(b->id));
    shapes_.insert(shapes_.end(), {shape_a, shape_b});
    ask_pair({{a->id, b->id}, {*shape_a, a->pose}, {*shape_b, b->pose}}, frame, counters);
}

void Certificates::ask_pair(const Pair& pair, std::uint32_t frame, Counters& counters) {
    const auto& [ids, a, b] = pair;
    const std::string about = fmt::format("bodies {} at update {}", text(ids), frame);
    scenes::Random random(frame);
    const double d = frame % 4 == 1 || frame % 4 == 2 ? distance(a, b, memory_) : 0;
    if (frame % 4 == 0) {
        const Relation plain = relation(a, b, memory_);
        const std::string words = plain == Relation::apart ? "disjoint" : text(plain);  // certificates have that word
        take(certify(a, b, memory_), {about, words, {}, {}}, counters);
    } else if (frame % 4 == 1) {
        take(certify_distance(a, b, memory_), {about, "distance", d, {}}, counters);
    } else if (frame % 4 == 2) {
        const double limit = any_limit(d, random);
        const char* words = within(a, b, limit, memory_) ? "within" : "beyond";
        take(certify_within(a, b, limit, memory_), {about, words, limit, {}}, counters);
    } else {
        const Segment segment{any_point(b, random), any_point(a, random)};
        const auto hit = first_hit(segment, a, memory_);
        Made plain{about, hit ? "hit" : "miss", {}, {}};
        if (hit) plain.value = hit->parameter;
        take(certify_hit(segment, a, memory_), plain, counters);
    }
}

void Certificates::ask_world(const World& world, std::uint32_t frame, Counters& counters) {
    const auto bodies = world.bodies();
    // Certificates of solids are refused.
    const auto is_surface = [&](BodyId body) {
        const auto shape = world.shape(body);
        return shape->kind() == ShapeKind::mesh() && surface_shape(shape) == shape;
    };
    if (bodies.size() > bodies_max || !std::ranges::all_of(bodies, is_surface)) return;
    const WorldCertificate certificate = world.certify(memory_);
    const std::size_t colliding = world.colliding_pairs().size(), close = world.close_pairs().size();
    if (certificate.colliding_count() != colliding || certificate.close_count() != close) {
        throw CheckFailed(
            "lists of a certificate", fmt::format("{} colliding, {} close", colliding, close),
            fmt::format("{} colliding, {} close", certificate.colliding_count(), certificate.close_count()));
    }
    std::string verdict = fmt::format("world of {} bodies, {} colliding, ", bodies.size(), colliding);
    if (world.clearance()) verdict += fmt::format("{} close, ", close);
    const auto shapes = certificate.shapes();
    shapes_.insert(shapes_.end(), shapes.begin(), shapes.end());
    made_.push_back({fmt::format("the world at update {}", frame),
                     verdict + words_of_unjudged(world),
                     {},
                     certificate.to_string()});
    ++counters["certificates: made"];
    ++counters["certificates: claims of world"];
}

// `plain`: but for the text.
void Certificates::take(const Certificate& certificate, Made plain, Counters& counters) {
    const std::string claim = claims[static_cast<std::size_t>(certificate.claim())];
    if (claim != plain.words || (plain.value && certificate.value() != *plain.value)) {
        throw CheckFailed("claim of a certificate", plain.about + ": " + words(plain.words, plain.value),
                          words(claim, certificate.value()));
    }
    plain.text = certificate.to_string();
    made_.push_back(std::move(plain));
    ++counters["certificates: made"];
    ++counters["certificates: claims of " + claim];
}

void Certificates::check(Counters& counters) const {
    if (options_.checker.empty() || made_.empty()) return;
    namespace fs = std::filesystem;
    // Of this process, so that runs at once do not meet; only what was refused stays.
    const fs::path folder = fs::temp_directory_path() / fmt::format("ecods_fuzz-{}.certificates", getpid());
    fs::remove_all(folder);
    certificates::CertificateFolder files(folder / "certificates.txt");
    bool spoils = spoils_;
    for (const Made& made : made_) {
        std::string text = made.text;
        if (spoils && spoil(text)) spoils = false;
        files.add(text);
    }
    for (const auto& shape : shapes_) files.add_mesh(dynamic_cast<const MeshShape&>(*shape));
    std::vector<std::string> command{options_.checker, folder / "certificates.txt"};
    for (const auto& file : fs::directory_iterator(folder)) {
        if (file.path().extension() == ".mesh") command.push_back(file.path());
    }
    const process::ProgramResult result = process::run_program(command);
    try {
        if (result.status > 1) throw CheckFailed("checker of certificates", "an end", result.text());
        judge(result.out);
    } catch (const CheckFailed&) {
        fs::remove_all(options_.folder);
        fs::create_directories(options_.folder);
        fs::copy(folder, options_.folder);
        fs::remove_all(folder);
        throw;
    }
    fs::remove_all(folder);
    counters["certificates: accepted"] += made_.size();
}

// One line each, in their order.
void Certificates::judge(const std::string& lines) const {
    std::istringstream in(lines);
    for (const Made& made : made_) {
        std::string line;
        std::getline(in, line);
        const std::string start = "accepted: " + made.words;
        const bool is_accepted = line.starts_with(start) && (line.size() == start.size() || line[start.size()] == ' ' ||
                                                             line[start.size()] == ',');
        const bool has_value =
            !made.value || (is_accepted && std::strtod(line.c_str() + start.size(), nullptr) == *made.value);
        if (is_accepted && has_value) continue;
        throw CheckFailed("check of a certificate", fmt::format("accepted: {}", words(made.words, made.value)),
                          fmt::format("{}: {}; files are in {}", made.about, line, options_.folder.string()));
    }
}

}  // namespace ecods::fuzz
