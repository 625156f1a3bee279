// usage: make_corpus FILE     writes the corpus: some cases of every family, of meshes one triangle

#include <array>
#include <cstdio>
#include <fstream>
#include <variant>

#include "environment/corpus.hpp"
#include "scenes/cast_cases.hpp"
#include "scenes/distance_cases.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/hit_cases.hpp"

namespace {

using namespace ecods;
using environment::Asked;

using Corners = std::array<Vec3, 3>;

// What a record holds; what its kind does not ask for is zero.
struct Case {
    Asked asked;
    Pose a;
    Corners corners_a;
    Pose b = {};
    Corners corners_b = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    Pose to_a = {}, to_b = {};
    Vec3 first = Vec3::Zero(), second = Vec3::Zero();
    double limit = 0;
};

class Writer {
  public:
    explicit Writer(const char* name) : file_(name, std::ios::binary) {}

    void write(const Case& made) {
        out_ = record_.data();
        add(static_cast<double>(made.asked));
        add(made.a, made.corners_a, made.to_a);
        add(made.b, made.corners_b, made.to_b);
        add(made.first);
        add(made.second);
        add(made.limit);
        file_.write(reinterpret_cast<const char*>(record_.data()), sizeof record_);
    }
    bool is_good() const { return file_.good(); }

  private:
    void add(double x) { *out_++ = x; }
    void add(const Vec3& v) {
        for (int k = 0; k < 3; ++k) add(v[k]);
    }
    void add(const Pose& pose) {
        for (int row = 0; row < 3; ++row) add(Vec3(pose.R.row(row)));
        add(pose.t);
    }
    void add(const Pose& pose, const Corners& corners, const Pose& to) {
        add(pose);
        for (const Vec3& v : corners) add(v);
        add(to);
    }

    std::ofstream file_;
    environment::Record record_;
    double* out_ = nullptr;
};

Corners any_triangle(const Mesh& mesh, scenes::Random& random) {
    const Triangle& t = mesh.triangles()[random.below(static_cast<std::uint32_t>(mesh.triangles().size()))];
    return {mesh.vertices()[t[0]], mesh.vertices()[t[1]], mesh.vertices()[t[2]]};
}

Case pair_of_triangles(const scenes::PosedPair& made, scenes::Random&) {
    return {.asked = Asked::pair, .a = made.pose_a, .corners_a = made.a, .b = made.pose_b, .corners_b = made.b};
}

Case pair_of(const scenes::DistanceCase& made, scenes::Random& random) {
    return {.asked = Asked::pair,
            .a = made.pose_a,
            .corners_a = any_triangle(*made.a, random),
            .b = made.pose_b,
            .corners_b = any_triangle(*made.b, random)};
}

Case line_of(const scenes::HitCase& made, scenes::Random& random) {
    Case line{.asked = Asked::segment, .a = made.pose, .corners_a = any_triangle(*made.mesh, random)};
    if (const auto* ray = std::get_if<Ray>(&made.line)) {
        line.asked = Asked::ray;
        line.first = ray->origin;
        line.second = ray->direction;
        line.limit = ray->max_parameter;
    } else {
        line.first = std::get<Segment>(made.line).a;
        line.second = std::get<Segment>(made.line).b;
    }
    return line;
}

Case translation_of(const scenes::CastCase& made, scenes::Random& random) {
    return {.asked = Asked::translation,
            .a = made.pose_a,
            .corners_a = any_triangle(*made.a, random),
            .b = made.pose_b,
            .corners_b = any_triangle(*made.b, random),
            .first = made.motion};
}

Case motion_of(const scenes::MoveCase& made, scenes::Random& random) {
    return {.asked = Asked::motion,
            .a = made.from_a,
            .corners_a = any_triangle(*made.a, random),
            .b = made.from_b,
            .corners_b = any_triangle(*made.b, random),
            .to_a = made.to_a,
            .to_b = made.to_b};
}

// `of` makes a record of a case.
template <class Case, class Of>
void write(Writer& writer, scenes::Families<Case> families, scenes::Random& random, int count, const Of& of) {
    for (const auto& family : families) {
        for (int i = 0; i < count; ++i) writer.write(of(family.make(random), random));
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: make_corpus FILE\n", stderr);
        return 2;
    }
    Writer writer(argv[1]);
    scenes::Random random(2026);
    write(writer, scenes::hard_families(), random, 400, pair_of_triangles);
    write(writer, scenes::distance_families(), random, 150, pair_of);
    write(writer, scenes::hit_families(), random, 400, line_of);
    write(writer, scenes::cast_families(), random, 300, translation_of);
    write(writer, scenes::move_families(), random, 150, motion_of);
    return writer.is_good() ? 0 : 1;
}
