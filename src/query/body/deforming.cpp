// Implements casts of deforming meshes. A deforming mesh is a surface. It meets a solid at time 0 if the solid contains
// a part of the mesh; otherwise its first contact is that with the solid's boundary.
#include "ecods/cast.hpp"

#include <optional>

#include "base/limits.hpp"
#include "query/body/contained.hpp"
#include "query/cast/cast_until.hpp"
#include "query/cast/deforming.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {
namespace {

// BodyOnItsWay holds a body as a set of points at the start, and the body's boundary at both ends of the motion.
class BodyOnItsWay {
  public:
    explicit BodyOnItsWay(const Deforming& mesh)
        : start_(DeformingAccess::at_start(mesh)), ends_(DeformingAccess::at_ends(mesh)) {}
    explicit BodyOnItsWay(const Moving<MeshShape>& rigid)
        : start_(*rigid.what, rigid.from),
          boundary_(std::in_place, boundary_of(*rigid.what).shape, rigid.from, rigid.to),
          ends_(*boundary_) {}
    explicit BodyOnItsWay(const Posed<MeshShape>& at_rest)
        : BodyOnItsWay(Moving<MeshShape>(*at_rest.what, at_rest.pose, at_rest.pose)) {}
    BodyOnItsWay(const BodyOnItsWay&) = delete;  // `ends_` refers to `boundary_`
    BodyOnItsWay& operator=(const BodyOnItsWay&) = delete;

    const Posed<MeshShape>& start() const noexcept { return start_; }
    const MeshAtEnds& ends() const noexcept { return ends_; }

  private:
    Posed<MeshShape> start_;
    std::optional<Moving<MeshShape>> boundary_;
    MeshAtEnds ends_;
};

std::optional<FirstContact> cast_on_their_way(const BodyOnItsWay& a, const BodyOnItsWay& b, double max_time,
                                              const Ask& ask) {
    const double latest = require_time(max_time);
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    const BodyPairAsked bodies(a.start(), b.start());
    return as_one_query(memory, [&]() -> std::optional<FirstContact> {
        if (const auto features = find_contained(bodies, memory)) {
            return FirstContact{0, ClosestKind::contained, features->a, features->b};
        }
        auto contact = cast_until(a.ends(), b.ends(), latest, memory, asking.witness());
        if (contact) bodies.rename(*contact);
        return contact;
    });
}

}  // namespace

std::optional<FirstContact> cast(const Deforming& a, const Posed<MeshShape>& b, double max_time, const Ask& ask) {
    return cast_on_their_way(BodyOnItsWay(a), BodyOnItsWay(b), max_time, ask);
}
std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Deforming& b, double max_time, const Ask& ask) {
    return cast_on_their_way(BodyOnItsWay(a), BodyOnItsWay(b), max_time, ask);
}
std::optional<FirstContact> cast(const Deforming& a, const Moving<MeshShape>& b, double max_time, const Ask& ask) {
    return cast_on_their_way(BodyOnItsWay(a), BodyOnItsWay(b), max_time, ask);
}
std::optional<FirstContact> cast(const Moving<MeshShape>& a, const Deforming& b, double max_time, const Ask& ask) {
    return cast_on_their_way(BodyOnItsWay(a), BodyOnItsWay(b), max_time, ask);
}
std::optional<FirstContact> cast(const Deforming& a, const Deforming& b, double max_time, const Ask& ask) {
    return cast_on_their_way(BodyOnItsWay(a), BodyOnItsWay(b), max_time, ask);
}

}  // namespace ecods
