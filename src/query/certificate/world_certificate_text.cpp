#include <algorithm>
#include <utility>

#include "geometry/words.hpp"
#include "query/certificate/certificate_content.hpp"
#include "query/certificate/world_certificate_content.hpp"

namespace ecods {
namespace {

using Claim = Certificate::Claim;

bool meets(const Certificate& certificate) {
    return certificate.claim() == Claim::touching || certificate.claim() == Claim::crossing;
}

}  // namespace

WorldCertificate::WorldCertificate(std::shared_ptr<const Content> content) noexcept : content_(std::move(content)) {}

std::size_t WorldCertificate::colliding_count() const noexcept {
    return static_cast<std::size_t>(
        std::ranges::count_if(content_->pairs, [](const auto& pair) { return meets(pair.first); }));
}
std::size_t WorldCertificate::close_count() const noexcept {
    if (!content_->clearance) return 0;
    return static_cast<std::size_t>(std::ranges::count_if(
        content_->pairs, [](const auto& pair) { return meets(pair.first) || pair.second.has_value(); }));
}
std::size_t WorldCertificate::apart_count() const noexcept {
    return static_cast<std::size_t>(std::ranges::count_if(
        content_->pairs, [](const auto& pair) { return !meets(pair.first) && !pair.second.has_value(); }));
}

std::vector<std::shared_ptr<const MeshShape>> WorldCertificate::shapes() const {
    std::vector<std::shared_ptr<const MeshShape>> result;
    for (const auto& body : content_->bodies) {
        if (std::ranges::find(result, body.shape) == result.end()) result.push_back(body.shape);
    }
    return result;
}

std::string WorldCertificate::to_string() const {
    const Content& c = *content_;
    std::string text = "ecods-world-certificate 2\n";
    append_line(text, "clearance", c.clearance);
    for (const auto& body : c.bodies) {
        append_line(text, "body", body.id, certified_mesh_digest(*body.shape), body.filter, body.pose);
    }
    for (const BodyPair& pair : c.off) append_line(text, "off", pair.a, pair.b);
    const auto append_pair = [&](const BodyPair& ids, const Certificate& certificate) {
        append_line(text, "pair", ids.a, ids.b);
        append_proof(text, CertificateAccess::content(certificate));
    };
    for (const auto& pair : c.pairs) {
        append_pair(pair.ids, pair.first);
        if (pair.second) append_pair(pair.ids, *pair.second);
    }
    text.append("end world\n");
    return text;
}

void WorldCertificate::write(std::ostream& out) const {
    write_text(out, to_string());
}

}  // namespace ecods
