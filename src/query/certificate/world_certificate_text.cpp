#include <algorithm>
#include <ostream>
#include <utility>

#include "base/number_text.hpp"
#include "query/certificate/certificate_content.hpp"
#include "query/certificate/world_certificate_content.hpp"

namespace ecods {
namespace {

using Claim = Certificate::Claim;

void append_id(std::string& text, BodyId id) {
    text.push_back(' ');
    append(text, std::uint64_t{id.slot});
    text.push_back('.');
    append(text, std::uint64_t{id.generation});
}

void append_pair(std::string& text, const char* word, const BodyPair& pair) {
    text.append(word);
    append_id(text, pair.a);
    append_id(text, pair.b);
    text.push_back('\n');
}

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
    std::string text = "ecods-world-certificate 2\nclearance ";
    if (c.clearance) {
        append_hex(text, *c.clearance);
    } else {
        text.append("none");
    }
    text.push_back('\n');
    for (const auto& body : c.bodies) {
        text.append("body");
        append_id(text, body.id);
        text.push_back(' ');
        const std::size_t at = text.size();
        append_body(text, *body.shape, body.pose);
        std::string filter = " ";
        append_hex(filter, body.filter.groups);
        filter.push_back(' ');
        append_hex(filter, body.filter.mask);
        text.insert(at + digest_length, filter);
    }
    for (const BodyPair& pair : c.off) append_pair(text, "off", pair);
    for (const auto& pair : c.pairs) {
        append_pair(text, "pair", pair.ids);
        append_proof(text, CertificateAccess::content(pair.first));
        if (!pair.second) continue;
        append_pair(text, "pair", pair.ids);
        append_proof(text, CertificateAccess::content(*pair.second));
    }
    text.append("end world\n");
    return text;
}

void WorldCertificate::write(std::ostream& out) const {
    const std::string text = to_string();
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace ecods
