#include "fuzz/shrink/simpler.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace ecods::fuzz {
namespace {

template <class Visitor>
void visit_fields(Call& call, Visitor&& visitor) {
    std::visit([&](auto& row) { row.fields(visitor, row); }, call);
}

struct PartVisitor : NoField {
    const std::function<void(Part&)>& act;
    void shape(Part& part) const { act(part); }
};

void for_each_part(Script& script, const std::function<void(Part&)>& act) {
    for (Call& call : script) visit_fields(call, PartVisitor{{}, act});
}

struct PoseVisitor : NoField {
    const std::function<void(Pose&)>& act;
    void pose(Pose& pose) const { act(pose); }
    void posed_bodies(auto&, std::vector<Pose>& poses) const { std::ranges::for_each(poses, act); }
};

// Gives one field, of those that are not at their simplest, its simplest value.
struct FieldSimplifier : NoField {
    std::size_t index;
    bool has_changed = false;

    void shape(Part& part) {
        offer(part.refits, false);
        offer(part.form, MeshForm::surface);
        offer(part.kind, ShapeKind::mesh());
    }
    void filter(CollisionFilter& filter) { offer(filter, CollisionFilter()); }
    void data(std::uint64_t& data) { offer(data, std::uint64_t{0}); }
    void clearance(std::optional<double>& clearance) { offer(clearance, std::optional<double>()); }
    void option(bool& option) { offer(option, false); }

    template <class Field>
    void offer(Field& field, const Field& simplest) {
        if (field == simplest || index-- != 0) return;
        field = simplest;
        has_changed = true;
    }
};

// Bits from the first to the last that is set.
int digits(double x) {
    if (x == 0) return 0;
    int exponent = 0;
    const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::abs(std::frexp(x, &exponent)), 53));
    return 53 - std::countr_zero(mantissa);
}

double leading_bits(double x, int count) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return std::ldexp(std::round(std::ldexp(mantissa, count)), exponent - count);
}

// The fields that a call sets of one body.
struct FieldsOfBody : NoField {
    std::optional<Label> of = {};
    std::optional<Part> part_set = {};
    std::optional<Pose> pose_set = {};
    std::optional<CollisionFilter> filter_set = {};
    std::optional<std::uint64_t> data_set = {};

    void body(const Label& body) { of = body; }
    void shape(const Part& part) { part_set = part; }
    void pose(const Pose& pose) { pose_set = pose; }
    void filter(const CollisionFilter& filter) { filter_set = filter; }
    void data(const std::uint64_t& data) { data_set = data; }
};

// Sets those of them that a call has.
struct FieldSetter : NoField {
    const FieldsOfBody& fields;
    bool has_set = false;

    void shape(Part& part) { set(part, fields.part_set); }
    void pose(Pose& pose) { set(pose, fields.pose_set); }
    void filter(CollisionFilter& filter) { set(filter, fields.filter_set); }
    void data(std::uint64_t& data) { set(data, fields.data_set); }

    template <class Field>
    void set(Field& field, const std::optional<Field>& value) {
        if (!value) return;
        field = *value;
        has_set = true;
    }
};

}  // namespace

double rounder(double x, int roundness) {
    constexpr std::array<int, roundness_count> bits = {0, 0, 1, 4, 10, 26};
    const double y = roundness == 0   ? 0.0
                     : roundness == 1 ? std::round(x)
                                      : leading_bits(x, bits[static_cast<std::size_t>(roundness)]);
    // Plus zero is rounder than minus zero.
    return std::isfinite(y) && digits(y) < digits(x) ? y + 0.0 : x;
}

bool simplify_field(Call& call, std::size_t index) {
    FieldSimplifier simplifier{{}, index};
    visit_fields(call, simplifier);
    return simplifier.has_changed;
}

bool fields_to_creation(Script& script, std::size_t call) {
    FieldsOfBody fields;
    visit_fields(script[call], fields);
    if (!fields.of) return false;
    FieldSetter setter{{}, fields};
    for (Call& creation : script) {
        if (created_body(creation) == fields.of) visit_fields(creation, setter);
    }
    if (!setter.has_set) return false;
    script.erase(script.begin() + static_cast<std::ptrdiff_t>(call));
    return true;
}

void for_each_pose(Script& script, const std::function<void(Pose&)>& act) {
    for (Call& call : script) visit_fields(call, PoseVisitor{{}, act});
}

void for_each_number(Script& script, const std::function<void(double&)>& act) {
    for_each_pose(script, [&](Pose& pose) {
        if (!pose.R.isIdentity(0)) std::ranges::for_each(pose.R.reshaped(), act);
        std::ranges::for_each(pose.t, act);
    });
    for (const auto& mesh : meshes_of(script)) {
        std::vector<Vec3> vertices(mesh->vertices().begin(), mesh->vertices().end());
        for (Vec3& vertex : vertices) std::ranges::for_each(vertex, act);
        if (std::ranges::equal(vertices, mesh->vertices())) continue;
        const auto triangles = mesh->triangles();
        replace_mesh(script, mesh.get(), Mesh::create(std::move(vertices), {triangles.begin(), triangles.end()}));
    }
}

std::vector<std::shared_ptr<const Mesh>> meshes_of(const Script& script) {
    std::vector<std::shared_ptr<const Mesh>> meshes;
    Script copy = script;
    for_each_part(copy, [&](Part& part) {
        if (std::ranges::find(meshes, part.mesh) == meshes.end()) meshes.push_back(part.mesh);
    });
    return meshes;
}

bool have_their_forms(const Script& script) {
    std::map<std::pair<const Mesh*, MeshForm>, bool> known;
    bool have_all = true;
    Script copy = script;
    for_each_part(copy, [&](Part& part) {
        const auto [at, is_new] = known.try_emplace({part.mesh.get(), part.form}, true);
        if (is_new) at->second = has_form(part.mesh, part.form);
        have_all = have_all && at->second;
    });
    return have_all;
}

void replace_mesh(Script& script, const Mesh* old, const std::shared_ptr<const Mesh>& mesh) {
    for_each_part(script, [&](Part& part) {
        if (part.mesh.get() == old) part.mesh = mesh;
    });
}

std::shared_ptr<const Mesh> without_triangles(const Mesh& mesh, std::size_t begin, std::size_t count) {
    std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
    const std::size_t end = std::min(begin + count, triangles.size());
    triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(begin),
                    triangles.begin() + static_cast<std::ptrdiff_t>(end));
    if (triangles.empty()) return nullptr;
    std::map<std::uint32_t, std::uint32_t> kept;  // old index to new
    std::vector<Vec3> vertices;
    for (Triangle& triangle : triangles) {
        for (std::uint32_t& corner : triangle) {
            const auto [place, is_new] = kept.emplace(corner, static_cast<std::uint32_t>(vertices.size()));
            if (is_new) vertices.push_back(mesh.vertices()[corner]);
            corner = place->second;
        }
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

}  // namespace ecods::fuzz
