#include "ecods/certificate.hpp"

#include <ostream>
#include <utility>

#include "query/certificate/certificate_content.hpp"

namespace ecods {

Certificate::Certificate(std::shared_ptr<const Content> content) noexcept : content_(std::move(content)) {}

Certificate::Claim Certificate::claim() const noexcept {
    return content_->claim;
}
double Certificate::value() const noexcept {
    return content_->value;
}
std::size_t Certificate::step_count() const noexcept {
    return content_->proof.step_count;
}
std::size_t Certificate::axis_count() const noexcept {
    return content_->proof.axes.size();
}

std::string Certificate::to_string() const {
    std::string text = "ecods-certificate 2\na ";
    append_body(text, *content_->shape_a, content_->pose_a);
    if (content_->shape_b != nullptr) {
        text.append("b ");
        append_body(text, *content_->shape_b, content_->pose_b);
    } else {
        text.append("segment");
        for (const Vec3& end : {content_->segment.a, content_->segment.b}) append_coordinates(text, end);
        text.push_back('\n');
    }
    append_proof(text, *content_);
    return text;
}

void Certificate::write(std::ostream& out) const {
    const std::string text = to_string();
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace ecods
