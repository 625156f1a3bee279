#include "fuzz/base/user_shape.hpp"

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "ecods/rounded.hpp"
#include "ecods/turn.hpp"
#include "trace/trace_text.hpp"

namespace ecods::fuzz {
namespace {

const MeshShape& mesh_shape_of(const Shape& shape) {
    if (const auto* user = dynamic_cast<const UserShape*>(&shape)) return user->as_mesh_shape();
    if (const auto* rounded = dynamic_cast<const Rounded*>(&shape)) return rounded->core();
    return dynamic_cast<const MeshShape&>(shape);
}

class UserTest final : public TwoBodyTest {
  public:
    UserTest(ShapeKind a, ShapeKind b, std::shared_ptr<const std::atomic<bool>> is_failing)
        : a_(a), b_(b), is_failing_(std::move(is_failing)) {}

    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        require_order(a, b);
        if (*is_failing_) throw TestFailed();
        return ecods::intersects(posed(a), posed(b), ask);
    }
    bool answers(Question question) const noexcept override {
        return question != Question::intersecting_triangles || b_ != second_user_kind;
    }
    double distance(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        require_order(a, b);
        return ecods::distance(posed(a), posed(b), ask);
    }
    bool within(const Posed<Shape>& a, const Posed<Shape>& b, double d, const Ask& ask) const override {
        require_order(a, b);
        if (*is_failing_) throw TestFailed();
        return ecods::within(posed(a), posed(b), d, ask);
    }
    ClosestPoints closest(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        require_order(a, b);
        return ecods::closest(posed(a), posed(b), ask);
    }
    Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        require_order(a, b);
        return ecods::relation(posed(a), posed(b), ask);
    }
    std::vector<TrianglePair> intersecting_triangles(const Posed<Shape>& a, const Posed<Shape>& b,
                                                     const Ask& ask) const override {
        require_order(a, b);
        if (b_ == second_user_kind) return TwoBodyTest::intersecting_triangles(a, b, ask);
        return ecods::intersecting_triangles(posed(a), posed(b), ask);
    }

    std::vector<TriangleIntersection> intersections(const Posed<Shape>& a, const Posed<Shape>& b,
                                                    const Ask& ask) const override {
        require_order(a, b);
        return ecods::intersections(posed(a), posed(b), ask);
    }
    std::vector<CloseFeatures> close_features(const Posed<Shape>& a, const Posed<Shape>& b, double d,
                                              const Ask& ask) const override {
        require_order(a, b);
        return ecods::close_features(posed(a), posed(b), d, ask);
    }
    std::optional<FirstContact> cast(const Posed<Shape>& a, const Vec3& motion, const Posed<Shape>& b, double max_time,
                                     const Ask& ask) const override {
        require_order(a, b);
        return ecods::cast(posed(a), motion, posed(b), max_time, ask);
    }
    std::optional<FirstContact> cast_moving(const Moving<Shape>& a, const Moving<Shape>& b, double max_time,
                                            const Ask& ask) const override {
        require_order({*a.what, a.from}, {*b.what, b.from});
        return ecods::cast(moving(a), moving(b), max_time, ask);
    }
    std::optional<FirstContact> cast_any_motion(const Posed<Shape>& a, const Motion& motion_of_a, const Posed<Shape>& b,
                                                const Motion& motion_of_b, double max_time,
                                                const Ask& ask) const override {
        require_order(a, b);
        return ecods::cast(posed(a), motion_of_a, posed(b), motion_of_b, max_time, ask);
    }

  private:
    static Moving<MeshShape> moving(const Moving<Shape>& body) {
        return {mesh_shape_of(*body.what), body.from, body.to};
    }
    static Posed<MeshShape> posed(const Posed<Shape>& body) { return {mesh_shape_of(*body.what), body.pose}; }
    void require_order(const Posed<Shape>& a, const Posed<Shape>& b) const {
        if (a.what->kind() != a_ || b.what->kind() != b_) throw std::logic_error("a test was given the wrong kinds");
    }

    ShapeKind a_, b_;
    std::shared_ptr<const std::atomic<bool>> is_failing_;
};

}  // namespace

Aabb UserShape::box(const Pose& pose) const {
    Aabb box = mesh_.box(pose);
    // Where doubles end, it reaches as far already.
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (tampering_ == Tampering::box) box.max[1] = box.max[1] == infinity ? box.min[1] : infinity;
    return box;
}

std::uint64_t UserShape::digest() const noexcept {
    return mesh_.digest() + kind_.value + (tampering_ == Tampering::digest ? 1 : 0);
}

// As Shape wants them: by the parameters that are there, which are rounded, and then by triangle.
static std::vector<Hit> in_order(std::vector<Hit> hits) {
    std::ranges::sort(hits, {}, [](const Hit& hit) { return std::pair(hit.parameter, hit.triangle()); });
    return hits;
}

std::vector<Hit> UserShape::all_hits(const Segment& segment, const Pose& pose, const Ask& ask) const {
    return in_order(mesh_.all_hits(segment, pose, ask));
}

std::vector<Hit> UserShape::all_hits(const Ray& ray, const Pose& pose, const Ask& ask) const {
    return in_order(mesh_.all_hits(ray, pose, ask));
}

std::shared_ptr<const Mesh> mesh_of(const Shape& shape) {
    return mesh_shape_of(shape).mesh_ptr();
}

void UserTests::add_to(World& world) const {
    const auto add = [&](ShapeKind a, ShapeKind b) {
        world.set_test(a, b, std::make_shared<UserTest>(a, b, is_failing_));
    };
    add(ShapeKind::mesh(), first_user_kind);
    add(ShapeKind::mesh(), second_user_kind);
    add(first_user_kind, first_user_kind);
    add(first_user_kind, second_user_kind);
    add(second_user_kind, second_user_kind);
}

std::string write_user_shape(const Shape& shape) {
    const auto mesh = mesh_of(shape);
    std::string text = std::to_string(mesh->vertices().size());
    for (const Vec3& vertex : mesh->vertices()) {
        text.push_back(' ');
        append(text, vertex);
    }
    for (const Triangle& triangle : mesh->triangles()) {
        for (const std::uint32_t corner : triangle) text.append(" ").append(std::to_string(corner));
    }
    return text;
}

std::shared_ptr<const Mesh> read_user_mesh(std::string_view text) {
    std::istringstream words{std::string(text)};
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    std::size_t vertex_count = 0;
    words >> vertex_count;
    std::string word;
    for (std::size_t i = 0; i < vertex_count && words; ++i) {
        Vec3& vertex = vertices.emplace_back();
        for (double& x : vertex) {
            words >> word;
            const auto number = parse_hex_double(word);
            if (!number) throw Error("no coordinate of a user-defined shape: " + word);
            x = *number;
        }
    }
    for (Triangle triangle; words >> triangle[0] >> triangle[1] >> triangle[2];) triangles.push_back(triangle);
    return Mesh::create(std::move(vertices), std::move(triangles));
}

}  // namespace ecods::fuzz
