#include "ecods/certificate.hpp"

#include <utility>

#include "ecods/error.hpp"
#include "geometry/words.hpp"
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
    const Content& c = *content_;
    std::string text = "ecods-certificate 2\n";
    append_line(text, "a", certified_mesh_digest(*c.shape_a), c.pose_a);
    if (c.shape_b != nullptr) {
        append_line(text, "b", certified_mesh_digest(*c.shape_b), c.pose_b);
    } else {
        append_line(text, "segment", c.segment.a, c.segment.b);
    }
    append_proof(text, c);
    return text;
}

void require_surface(const MeshShape& shape) {
    if (shape.form() != MeshForm::surface)
        throw NotSupported("a certificate is about a surface: ask about surface_of(solid)");
}

void Certificate::write(std::ostream& out) const {
    write_text(out, to_string());
}

}  // namespace ecods
