// TranslatedPairs bounds the times at which nodes and pairs of triangles of two meshes first share a point while one
// mesh is translated. All pair questions about translations derive from this class.
#pragma once

#include <cstdint>

#include "bvh/axes/swept_axes.hpp"
#include "ecods/ask.hpp"
#include "query/cast/triangle_contacts.hpp"
#include "query/shape/mesh_body.hpp"

namespace ecods {

class TranslatedPairs {
  public:
    // Binds two bodies, the first of which is translated by `motion`. Returns false if there is certainly no contact
    // from time 0 to `latest`. All objects that the arguments refer to must outlive this object.
    bool bind(const MeshPair& bodies, const Vec3& motion, double latest, CastCounts& counts) {
        const MeshBody &a = bodies.a, &b = bodies.b;
        counts_ = &counts;
        if (!axes_.bind({a.tree.boxes, a.pose.R}, {b.tree.boxes, b.pose.R}, b.pose.t - a.pose.t, motion, latest)) {
            return false;
        }
        contacts_.bind(a.ref(), motion, b.ref());
        return true;
    }

    // Search calls the next two functions (query/search).
    float limit_above(double time) const noexcept { return axes_.window_above(time); }
    template <class X, class Y>
    std::uint64_t find_near(const X& x, const Y& y, float limit, LaneBounds& times) const noexcept {
        return swept_mask(axes_.sets(), limit, x, y, times);
    }

  protected:
    // Return the interval that TriangleContacts computes in doubles, and a TriangleContacts for one exact decision.
    // Both functions count the work.
    ContactInterval enclosed(const TrianglePair& pair) {
        ++counts_->enclosures;
        return contacts_.enclose(pair.a, pair.b);
    }
    TriangleContacts& exact_contacts() noexcept {
        ++counts_->exact;
        return contacts_;
    }

  private:
    SweptAxes axes_;
    TriangleContacts contacts_;
    CastCounts* counts_ = nullptr;
};

}  // namespace ecods
