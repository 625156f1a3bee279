// Implements the functions of rounded.hpp for points. A point counts as a body of one vertex, without a radius.
#include "base/double_key.hpp"
#include "ecods/rounded.hpp"
#include "query/body/rounded_pair.hpp"
#include "query/body/starts_inside.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/mesh_body.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {
namespace {

// AskedPoint computes the distance of a point from a rounded body: from the surface of its core, less the radius.
class AskedPoint {
  public:
    // Throws InvalidArgument unless the point is finite.
    AskedPoint(const Vec3& point, const Posed<Rounded>& rounded, QueryMemory& memory)
        : point_(point), core_(CoreAndRadius(rounded).core), radius_(rounded.what->radius()), memory_(memory) {
        require_valid(point);
        at_.t = point;
        is_in_core_ = is_inside(point, core_, memory);
    }

    bool is_in_core() const noexcept { return is_in_core_; }
    double signed_distance() const {
        const exact::ExactSum margin(is_in_core_ ? -radius_ : radius_);
        const double distance = surface::signed_beyond(body(), core_.boundary(), margin, memory_);
        return is_in_core_ ? opposite(distance) : distance;
    }
    ClosestPoint closest() const {
        const ClosestPoints points = surface::closest(body(), core_.boundary(), memory_, {0, radius_});
        ClosestPoint result{points.distance, points.b, points.point_b};
        core_.rename(result.feature);
        return result;
    }

  private:
    Posed<MeshShape> body() const { return {point_shape(), at_}; }

    Vec3 point_;
    Pose at_;
    PosedBody core_;
    double radius_;
    QueryMemory& memory_;
    bool is_in_core_ = false;
};

// Calls use(asked) with the point asked about, as one query.
template <class Use>
auto ask_about(const Vec3& point, const Posed<Rounded>& body, const Ask& ask, const Use& use) {
    Asking asking(ask);
    return as_one_query(asking.memory(), [&] { return use(AskedPoint(point, body, asking.memory())); });
}

}  // namespace

ClosestPoint closest(const Eigen::Ref<const Vec3>& point, const Posed<Rounded>& body, const Ask& ask) {
    const Vec3 at = point;
    if (key_of(body.what->radius()) == 0) return closest(at, CoreAndRadius(body).core, ask);
    return ask_about(at, body, ask, [&](const AskedPoint& asked) {
        const double distance = asked.is_in_core() ? -1 : asked.signed_distance();
        if (key_of(distance) > 0) return asked.closest();
        return ClosestPoint{0, key_of(distance) < 0 ? no_feature : asked.closest().feature, hit_inside(at).point};
    });
}

double signed_distance(const Eigen::Ref<const Vec3>& point, const Posed<Rounded>& body, const Ask& ask) {
    const Vec3 at = point;
    if (key_of(body.what->radius()) == 0) return signed_distance(at, CoreAndRadius(body).core, ask);
    return ask_about(at, body, ask, [](const AskedPoint& asked) { return asked.signed_distance(); });
}

Location locate(const Eigen::Ref<const Vec3>& point, const Posed<Rounded>& body, const Ask& ask) {
    const Vec3 at = point;
    const PosedBody core(CoreAndRadius(body).core);
    if (key_of(body.what->radius()) == 0 && core.has_inside()) return locate(at, core.solid(), ask);
    return ask_about(at, body, ask, [](const AskedPoint& asked) -> Location {
        const std::int64_t key = asked.is_in_core() ? -1 : key_of(asked.signed_distance());
        if (key > 0) return {};
        if (key < 0) return {Side::inside, {}};
        return {Side::on, asked.closest().feature};
    });
}

}  // namespace ecods
