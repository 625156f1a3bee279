// Distances of two triangles, with every pair of features for the closest; and the times of their first contact, with
// every such pair for the one that meets, leaves or passes.
#include <optional>

#include "exact/measure/contact/enclose_contact.hpp"
#include "exact/measure/distance/enclose_distance.hpp"
#include "oracle/first_contact.hpp"
#include "oracle/nearest.hpp"
#include "property/guesses/features.hpp"
#include "property/guesses/soups.hpp"

namespace ecods::guesses {
namespace {

using namespace exact;

// The first triangle of each body, for the library.
class FirstTriangles {
  public:
    explicit FirstTriangles(const Bodies& bodies)
        : bodies_(bodies), extent_a_(measure(*bodies.a)), extent_b_(measure(*bodies.b)) {}

    IntegerPair integers(const BitRange& others = {}) {
        points_.bind_pair({bodies_.a.get(), &extent_a_, &bodies_.pose_a},
                          {bodies_.b.get(), &extent_b_, &bodies_.pose_b}, others);
        return integer_pair(points_, {0, 1, 2}, {0, 1, 2});
    }

  private:
    const Bodies& bodies_;
    MeshExtent extent_a_, extent_b_;
    IntegerFrame points_;
};

}  // namespace

void ask_distance(Case& c) {
    const Bodies bodies = some_bodies(c.random, 1);
    const oracle::MeshDistances truth(soup_of(*bodies.a, bodies.pose_a), soup_of(*bodies.b, bodies.pose_b));
    const oracle::ExactClosest closest = truth.closest(0, 0);
    FirstTriangles pair(bodies);
    for_each_mode([&](const environment::FloatMode& mode) {
        for (const FeaturePair& features : feature_pairs) {
            const Enclosure e = in_mode(mode, [&] { return enclose_distance(pair.integers(), features); });
            c.require(e.lower >= 0 && compare(closest.distance, e.lower) >= 0, "a lower end above the distance",
                      mode.name);
            c.require(e.upper >= 0 && compare(closest.distance, e.upper) <= 0, "an upper end below the distance",
                      mode.name);
            c.require(!e.is_certain || are_features(features, closest), "features that are not the closest", mode.name);
            c.tally.telling += (e.lower > 0) + (e.upper <= 0x1p1000) + e.is_certain;
        }
    });
}

void ask_contact(Case& c) {
    using What = ContactGuess::What;
    const Bodies bodies = some_bodies(c.random, 1);
    const Vec3 motion = some_motion(c.random, bodies);
    const auto contact =
        oracle::first_contact(soup_of(*bodies.a, bodies.pose_a), motion, soup_of(*bodies.b, bodies.pose_b));
    const auto is_from = [&](double lower) { return !contact || contact->time.compare(mpq_class(lower)) >= 0; };
    const auto is_up_to = [&](double upper) {
        return contact ? contact->time.compare(mpq_class(upper)) <= 0 : upper > 1;
    };
    FirstTriangles pair(bodies);
    for_each_mode([&](const environment::FloatMode& mode) {
        for (const What what : {What::meeting, What::leaving, What::passing}) {
            for (const FeaturePair& features : feature_pairs) {
                const Enclosure e = in_mode(mode, [&] {
                    const ScaledVector m = scaled_motion(motion);
                    return enclose_contact(pair.integers({m.shift, m.shift + 53}), m, {what, features});
                });
                c.require(std::isfinite(e.lower) ? is_from(e.lower) : !contact, "a lower end above the time",
                          mode.name);
                c.require(!std::isfinite(e.upper) || is_up_to(e.upper), "an upper end below the time", mode.name);
                c.require(!e.is_certain || !contact || are_features(features, *contact),
                          "features that do not meet first", mode.name);
                c.tally.telling += (e.lower > 0) + std::isfinite(e.upper) + e.is_certain;
            }
        }
    });
}

}  // namespace ecods::guesses
