#include "query/cast/triangle_contacts.hpp"

#include <algorithm>

#include "exact/measure/contact/contact_times.hpp"
#include "exact/measure/contact/enclose_contact.hpp"
#include "exact/measure/distance/measure_pair.hpp"
#include "exact/measure/distance/name_features.hpp"
#include "exact/point/integer_points.hpp"

namespace ecods {

using namespace exact;

void TriangleContacts::bind(const BodyRef& a, const Vec3& motion, const BodyRef& b) {
    motion_ = motion;
    scaled_ = scaled_motion(motion);
    BitRange digits;
    for (int k = 0; k < 3; ++k) digits.include(decode(motion[k]));
    points_.bind_pair(a, b, digits);
    triangles_ = {a.mesh->triangles().data(), b.mesh->triangles().data()};
    // The motion is stored like a difference of points, so it must fit into as many bits.
    is_exact_ = points_.is_exact() && digits.low >= points_.unit() &&
                digits.high - points_.unit() < IntegerFrame::difference_bits;
    if (!is_exact_) return;
    for (std::size_t k = 0; k < 3; ++k) {
        const Dyadic d = decode(motion[static_cast<Eigen::Index>(k)]);
        integer_motion_[k] = d.m == 0 ? 0 : Int128{d.m} << (d.e - points_.unit());
    }
}

IntegerPair TriangleContacts::integers(std::uint32_t i, std::uint32_t j) {
    return integer_pair(points_, triangles_[0][i], triangles_[1][j]);
}

ContactInterval TriangleContacts::enclose(std::uint32_t i, std::uint32_t j) {
    const IntegerPair pair = integers(i, j);
    const ContactGuess guess = guess_contact(pair, scaled_);
    const Enclosure enclosure = enclose_contact(pair, scaled_, guess);
    ContactInterval interval;
    interval.lower = enclosure.lower;
    interval.upper = enclosure.upper;
    interval.is_certain = enclosure.is_certain;
    if (enclosure.is_certain) {
        name_features(interval.contact, guess.features, {i, j});
        interval.a = feature_key(interval.contact.a, triangles_[0][i]);
        interval.b = feature_key(interval.contact.b, triangles_[1][j]);
    }
    return interval;
}

// Calls use(pair) with the TranslatedPair of two triangles, in the narrowest kernel that holds their points and the
// motion. The motion is passed as the difference of two more points, of a body that is only translated.
template <class Use>
auto TriangleContacts::with_integers(std::uint32_t i, std::uint32_t j, Use&& use) {
    const auto in_kernel = [&]<class Kernel>(const IntegerPoints<Kernel, 8>& points) {
        constexpr int L = Kernel::limb_count;
        const auto at = [&](std::size_t k) {
            return std::array{to_limbs(points.at[k][0]), to_limbs(points.at[k][1]), to_limbs(points.at[k][2])};
        };
        return use(TranslatedPair<L>{{at(0), at(1), at(2), at(3), at(4), at(5)}, difference<L>(at(7), at(6))});
    };
    if (is_exact_) {
        const IntegerPair pair = integers(i, j);
        IntegerPoints<TwoLimbKernel, 8> points;
        points.unit = pair.unit;
        std::copy(pair.at.begin(), pair.at.end(), points.at.begin());
        points.at[6] = points.at[7] = pair.at[0];
        for (std::size_t k = 0; k < 3; ++k) points.at[7][k] += integer_motion_[k];
        return use_narrowest(points, in_kernel);
    }
    const BodyRef &a = points_.body(0), &b = points_.body(1);
    const Pose translated{Mat3::Identity(), a.pose->t};
    const Vec3 origin = Vec3::Zero();
    PosedPoints<8> posed;
    for (std::size_t k = 0; k < 3; ++k) {
        posed[k] = {a.pose, &a.mesh->vertices()[triangles_[0][i][k]]};
        posed[3 + k] = {b.pose, &b.mesh->vertices()[triangles_[1][j][k]]};
    }
    posed[6] = {&translated, &origin};
    posed[7] = {&translated, &motion_};
    return exact::with_integers(posed, in_kernel);
}

std::optional<FirstContact> TriangleContacts::contact(std::uint32_t i, std::uint32_t j, const ContactInterval& known) {
    return with_integers(i, j, [&]<int L>(const TranslatedPair<L>& pair) -> std::optional<FirstContact> {
        if (known.is_certain) {
            const auto time = ContactTimes<L>::time_of(features_named(known.contact), pair);
            if (!ContactTimes<L>::is_by_one(time)) return std::nullopt;
            FirstContact result = known.contact;
            result.time = round_fraction(time.size());
            return result;
        }
        const ContactTimes<L> times(pair);
        const auto first = times.first();
        if (!first) return std::nullopt;
        FirstContact result;
        result.a = {Feature::Kind::face, i, 0};
        result.b = {Feature::Kind::face, j, 0};
        if (first->sign() > 0) name_features(result, times.first_features(*first), {i, j});
        result.time = round_fraction(first->size());
        return result;
    });
}

bool TriangleContacts::meet_by(std::uint32_t i, std::uint32_t j, double latest) {
    return with_integers(i, j, [&]<int L>(const TranslatedPair<L>& pair) {
        const auto first = ContactTimes<L>(pair).first();
        return first && compare(first->size(), latest) <= 0;
    });
}

TriangleContacts::Entry TriangleContacts::entry(std::uint32_t i, std::uint32_t j, double end, bool with_edges) {
    return with_integers(i, j, [&]<int L>(const TranslatedPair<L>& pair) {
        const ContactTimes<L> times(pair);
        Entry entry;
        if (times.meets_properly()) {
            auto interval = times.interval();
            if (!interval || interval->last.sign() <= 0) return entry;
            if (interval->first.sign() < 0) interval->first.num = {};
            if (compare(interval->first.size(), end) < 0) entry.time = round_fraction(interval->first.size());
        } else if (with_edges) {
            for (std::size_t edge = 0; edge < 6; ++edge) {
                if (times.slides_in_plane(edge / 3, edge % 3)) {
                    entry.sliding_edges |= static_cast<std::uint8_t>(1U << edge);
                }
            }
        }
        return entry;
    });
}

}  // namespace ecods
