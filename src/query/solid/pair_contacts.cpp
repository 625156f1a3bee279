#include "query/solid/pair_contacts.hpp"

#include "exact/sign/frame_signs.hpp"
#include "exact/simplex/triangle_filter.hpp"

namespace ecods {

using namespace exact;

PairContacts::PairContacts(Frame& frame, StageCounts& counts)
    : frame_(frame), counts_(counts), bound_(orient3d_bound(frame)) {}

TriangleContact PairContacts::contact(const Triangle& a, const Triangle& b) {
    constexpr TriangleContact crossing{ContactKind::segment, TriangleContact::face, TriangleContact::face};
    ++counts_.triangle_tests;
    if (frame_.arithmetic() >= Arithmetic::differences) {
        ++counts_.local_passes;
        return decide(a, b);
    }
    const Points<6> points = frame_.rounded(corners_of(a, b));
    FilterTrace trace;
    FilterAnswer answer = filter(points, bound_, trace);
    if (answer != FilterAnswer::unknown) {
        ++counts_.filter_passes;
        return answer == FilterAnswer::crossing ? crossing : TriangleContact{};
    }
    frame_.find_arithmetic();
    if (frame_.arithmetic() >= Arithmetic::differences) {
        ++counts_.local_passes;
        return decide(a, b);
    }
    answer = filter_again(points, determinant_bounds(points, frame_.delta()).orient3d, trace);
    if (answer != FilterAnswer::unknown) {
        ++counts_.semi_static_passes;
        return answer == FilterAnswer::crossing ? crossing : TriangleContact{};
    }
    ++(frame_.arithmetic() == Arithmetic::one_limb    ? counts_.one_limb
       : frame_.arithmetic() == Arithmetic::two_limbs ? counts_.two_limbs
                                                      : counts_.many_limbs);
    return decide(a, b);
}

TriangleContact PairContacts::decide(const Triangle& a, const Triangle& b) {
    return with_signs(frame_, corners_of(a, b), [](auto& signs) { return triangle_contact(signs); });
}

}  // namespace ecods
