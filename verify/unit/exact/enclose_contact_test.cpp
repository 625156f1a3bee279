// Enclosures contain the time of the first contact, in every floating-point environment, whatever is guessed; they are
// narrow where the guess is right.
#include "exact/measure/contact/enclose_contact.hpp"

#include <gtest/gtest.h>

#include "measured_pairs.hpp"
#include "oracle/first_contact.hpp"

namespace ecods::exact::enclose_contact_test {
namespace {

using What = ContactGuess::What;

// A pair whose first triangle is translated, and the oracle's view of it.
struct Translated {
    PosedPair pair;
    Vec3 motion;

    std::optional<oracle::ExactContact> first_contact() const {
        const std::vector<Vec3> a(pair.a.begin(), pair.a.end()), b(pair.b.begin(), pair.b.end());
        const std::vector<Triangle> triangle{{0, 1, 2}};
        return oracle::first_contact({a, triangle, pair.pose_a}, motion, {b, triangle, pair.pose_b});
    }
};

// A point of one triangle goes to one of the other, and beyond it, or not quite there; to another one of its own; or
// anywhere.
Vec3 some_motion(Random& random, const PosedPair& pair) {
    const auto corner = [&](const Pose& pose, const std::array<Vec3, 3>& corners) {
        return Vec3(pose.R * corners[random.below(3)] + pose.t);
    };
    const Vec3 p = corner(pair.pose_a, pair.a), q = corner(pair.pose_b, pair.b);
    const std::array shares{0.5, 1.0, 1.5, 4.0};
    Vec3 motion = shares[random.below(4)] * (q - p);
    if (random.below(3) == 0) motion += 0.25 * (corner(pair.pose_a, pair.a) - p);
    if (random.below(6) == 0) motion = std::ldexp(1.0, static_cast<int>(random.below(80)) - 40) * random_point(random);
    // Of numbers beyond the largest double.
    for (int k = 0; k < 3; ++k) {
        if (!std::isfinite(motion[k])) motion[k] = random.uniform(-1, 1);
    }
    if (motion == Vec3::Zero()) motion[0] = 1;
    return motion;
}

IntegerPair integers(IntegerFrame& points, const OnePair& meshes, const ScaledVector& motion) {
    points.bind_pair(meshes.a(), meshes.b(), {motion.shift, motion.shift + 53});
    return integer_pair(points, {0, 1, 2}, {0, 1, 2});
}

// Where there is no contact, it is not said that there is.
bool contains(const Enclosure& e, const std::optional<oracle::ExactContact>& contact) {
    if (!contact) return e.upper > 1;
    if (!std::isfinite(e.lower) || contact->time.compare(mpq_class(e.lower)) < 0) return false;
    return !std::isfinite(e.upper) || contact->time.compare(mpq_class(e.upper)) <= 0;
}

// What the oracle calls the features that it chooses.
bool are_features(const FeaturePair& f, const oracle::ExactContact& contact) {
    const bool is_face = f.kind == FeatureKind::vertex_face;
    const int lesser = is_face ? 0 : 1, greater = is_face ? 2 : 1;
    const bool is_turned = f.vertex_side == 1;
    return contact.a == oracle::NamedFeature{is_turned ? greater : lesser, 0, f.a} &&
           contact.b == oracle::NamedFeature{is_turned ? lesser : greater, 0, f.b};
}

// With the guess, and with everything that could be guessed in its place.
TEST(EncloseContact, ContainsTheTimeWhateverIsGuessed) {
    Random random(21);
    IntegerFrame points;
    int contact_count = 0, certain_count = 0, late_count = 0, never_count = 0;
    for_each_pair(40, [&](const std::string& name, const PosedPair& pair) {
        const Translated translated{pair, some_motion(random, pair)};
        const OnePair meshes(pair);
        const auto contact = translated.first_contact();
        contact_count += contact && contact->rounded > 0;
        for (const int environment : environments) {
            for (const What what : {What::meeting, What::leaving, What::passing}) {
                for (const FeaturePair& features : feature_pairs) {
                    const Enclosure e = in_environment(environment, [&] {
                        const ScaledVector m = scaled_motion(translated.motion);
                        return enclose_contact(integers(points, meshes, m), m, {what, features});
                    });
                    ASSERT_TRUE(contains(e, contact)) << name << " " << e.lower << " " << e.upper;
                    ASSERT_TRUE(!e.is_certain || !contact || are_features(features, *contact)) << name;
                    certain_count += e.is_certain;
                    never_count += !contact && !std::isfinite(e.lower);
                    late_count += !contact && std::isfinite(e.lower) && e.lower > 1;
                }
            }
        }
    });
    EXPECT_GT(contact_count, 200);
    EXPECT_GT(certain_count, 1000);
    EXPECT_GT(never_count, 1000);
    EXPECT_GT(late_count, 1000);
}

// Of triangles that are apart by at least 2^-27 of their size, far from where coordinates run out of digits.
TEST(EncloseContact, IsNarrow) {
    Random random(22);
    IntegerFrame points;
    int apart_count = 0, certain_count = 0, narrow_count = 0, excluded_count = 0, none_count = 0;
    for (int i = 0; i < 2000; ++i) {
        const int exponent = i % 4 == 0 ? static_cast<int>(random.below(1201)) - 600 : 0;
        const Vec3 motion = 4 * random_point(random);
        const PosedPair pair = scaled_by(at_gap(random, random_pair(random), random.uniform(0x1p-27, 1)), exponent);
        const Translated translated{pair, std::ldexp(1.0, exponent) * motion};
        const auto contact = translated.first_contact();
        if (contact && contact->rounded == 0) continue;
        const OnePair meshes(pair);
        const ScaledVector m = scaled_motion(translated.motion);
        const IntegerPair six = integers(points, meshes, m);
        const Enclosure e = enclose_contact(six, m, guess_contact(six, m));
        apart_count += contact.has_value();
        none_count += !contact;
        excluded_count += !contact && e.lower > 1;
        certain_count += contact && e.is_certain;
        narrow_count += contact && e.lower > 0.9999 * e.upper;
    }
    EXPECT_GT(apart_count, 100);
    EXPECT_GT(excluded_count, none_count * 99 / 100);
    EXPECT_GT(narrow_count, apart_count * 9 / 10);
    EXPECT_GT(certain_count, apart_count * 9 / 10);
}

}  // namespace
}  // namespace ecods::exact::enclose_contact_test
