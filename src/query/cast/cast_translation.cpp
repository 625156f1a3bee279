#include <memory>

#include "bvh/axes/swept_axes.hpp"
#include "query/cast/cast_search.hpp"
#include "query/cast/cast_until.hpp"
#include "query/cast/contact_at_start.hpp"
#include "query/cast/triangle_contacts.hpp"
#include "query/shape/other_units.hpp"

namespace ecods {
namespace {

// The Motion of a CastSearch.
class Translation {
  public:
    // Returns false if there is certainly no contact until `latest`.
    bool bind(const exact::BodyRef& a, const Vec3& motion, const exact::BodyRef& b, const PosedTree& tree_a,
              const PosedTree& tree_b, double latest) {
        if (!axes_.bind(tree_a, tree_b, b.pose->t - a.pose->t, motion, latest)) return false;
        contacts_.bind(a, motion, b);
        return true;
    }

    float limit_above(double time) const noexcept { return axes_.window_above(time); }
    template <class X, class Y>
    std::uint64_t find_near(const X& x, const Y& y, float limit, LaneTimes& times) const noexcept {
        return swept_mask(axes_.sets(), limit, x, y, times);
    }
    ContactInterval enclose(std::uint32_t i, std::uint32_t j) { return contacts_.enclose(i, j); }
    std::optional<FirstContact> contact(std::uint32_t i, std::uint32_t j, const ContactInterval& known) {
        return contacts_.contact(i, j, known);
    }
    bool meet_by(std::uint32_t i, std::uint32_t j, double latest) { return contacts_.meet_by(i, j, latest); }

  private:
    SweptAxes axes_;
    TriangleContacts contacts_;
};

struct Memory final : QueryMemoryPart {
    CastMemory working;
    Translation translation;
};

Memory& memory_of(QueryMemory& memory) {
    auto& part = QueryMemoryAccess::state(memory).cast;
    if (!part) part = std::make_unique<Memory>();
    return static_cast<Memory&>(*part);
}

bool is_zero(const Vec3& v) {
    return key_of(v[0]) == 0 && key_of(v[1]) == 0 && key_of(v[2]) == 0;
}

// Bodies that do not move meet at time 0 or never.
std::optional<FirstContact> cast_at_rest(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory,
                                         PairWitness& witness) {
    if (!intersects(a, b, memory, witness)) return std::nullopt;
    const FirstContact result = contact_at_start(a, b, memory);
    witness = {result.a.triangle, result.b.triangle};
    return result;
}

}  // namespace

std::optional<FirstContact> cast_until(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                       double latest, QueryMemory& memory, PairWitness& witness) {
    validate_motion(motion);
    if (is_zero(motion)) return cast_at_rest(a, b, memory, witness);
    Memory& working = memory_of(memory);
    ++QueryMemoryAccess::state(memory).counts.queries;
    const MeshTree &tree_a = MeshShapeAccess::tree(*a.what), &tree_b = MeshShapeAccess::tree(*b.what);
    const exact::BodyRef body_a{&a.what->mesh(), &tree_a.extent, &a.pose};
    const exact::BodyRef body_b{&b.what->mesh(), &tree_b.extent, &b.pose};
    if (!working.translation.bind(body_a, motion, body_b, {tree_a.boxes, a.pose.R}, {tree_b.boxes, b.pose.R}, latest)) {
        return std::nullopt;
    }
    const OtherUnits units(a, b, motion);
    if (units.are_better()) {
        return as_part(memory,
                       [&] { return cast_until(units.of(a), units.of(motion), units.of(b), latest, memory, witness); });
    }
    return CastSearch<Translation>(working.translation, a, b, working.working, memory).find(latest, witness);
}

std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                 QueryMemory& memory, PairWitness& witness) {
    return cast_until(a, motion, b, 1, memory, witness);
}

std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                 QueryMemory& memory) {
    PairWitness witness;
    return cast(a, motion, b, memory, witness);
}

}  // namespace ecods
