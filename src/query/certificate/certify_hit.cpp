#include <utility>

#include "base/double_key.hpp"
#include "base/next.hpp"
#include "ecods/certificate.hpp"
#include "query/certificate/certificate_content.hpp"
#include "query/certificate/line_proof.hpp"
#include "query/hit/surface_hit.hpp"

namespace ecods {
namespace {

// Returns the midpoint of a positive double and the next double below it; zero for the least positive double.
Parameter midpoint_below(double s) {
    const exact::Dyadic x = exact::decode(s), y = exact::decode(next_down(s));
    if (y.m == 0) return {};
    const int e = std::min(x.e, y.e);
    return {(x.m << (x.e - e)) + (y.m << (y.e - e)), e - 1};
}

bool is_even(double x) {
    return (std::bit_cast<std::uint64_t>(x) & 1) == 0;
}

}  // namespace

Certificate certify_hit(const Segment& segment, const Posed<MeshShape>& body, const Ask& ask) {
    CertificateAccess::Content content;
    content.shape_a = CertificateAccess::shape_of(body);
    const auto hit = surface::first_hit(segment, body, ask);
    content.pose_a = body.pose;
    content.segment = segment;
    if (!hit) {
        content.claim = Certificate::Claim::miss;
        prove_line(body, segment, {1, 0}, ApartBy::strictly, content.proof);
    } else {
        content.claim = Certificate::Claim::hit;
        content.value = hit->parameter;
        content.a = {Feature::Kind::face, hit->triangle(), 0};
        if (key_of(hit->parameter) != 0) {
            const ApartBy apart = is_even(hit->parameter) ? ApartBy::half_open : ApartBy::strictly;
            prove_line(body, segment, midpoint_below(hit->parameter), apart, content.proof);
        }
    }
    return CertificateAccess::make(std::move(content));
}

}  // namespace ecods
