#include "query/solid/pair_contacts.hpp"

#include "exact/sign/frame_signs.hpp"
#include "exact/simplex/triangle_filter.hpp"
#include "query/intersection/triangle_relations.hpp"

namespace ecods {

using namespace exact;

PairContacts::PairContacts(Frame& frame, StageCounts& counts)
    : frame_(frame), counts_(counts), bound_(orient3d_bound(frame)) {}

TriangleContact PairContacts::contact(const Triangle& a, const Triangle& b) {
    const auto certain = [](FilterAnswer answer) -> TriangleContact {
        if (answer == FilterAnswer::disjoint) return {};
        return {ContactKind::segment, TriangleContact::face, TriangleContact::face};
    };
    const auto doubles_are_exact = [&] { return frame_.arithmetic() >= Arithmetic::differences; };
    ++counts_.triangle_tests;
    if (!doubles_are_exact()) {
        const Points<6> points = frame_.rounded(corners_of(a, b));
        FilterTrace trace;
        FilterAnswer answer = filter(points, bound_, trace);
        if (answer != FilterAnswer::unknown) {
            ++counts_.filter_passes;
            return certain(answer);
        }
        frame_.find_arithmetic();
        if (!doubles_are_exact()) {
            answer = filter_again(points, determinant_bounds(points, frame_.delta()).orient3d, trace);
            const bool is_open = answer == FilterAnswer::unknown;
            ++(is_open ? integer_stage(counts_, frame_.arithmetic()) : counts_.semi_static_passes);
            return is_open ? decide(a, b) : certain(answer);
        }
    }
    ++counts_.local_passes;
    return decide(a, b);
}

TriangleContact PairContacts::decide(const Triangle& a, const Triangle& b) {
    return with_signs(frame_, corners_of(a, b), [](auto& signs) { return triangle_contact(signs); });
}

}  // namespace ecods
