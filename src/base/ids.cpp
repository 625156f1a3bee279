#include "ecods/ids.hpp"

#include <ostream>
#include <string>

#include "base/kind_name.hpp"

namespace ecods {
namespace {

std::string text_of(BodyId body) {
    return std::to_string(body.slot).append(".").append(std::to_string(body.generation));
}

std::string text_of(const std::string& a, const std::string& b) {
    return std::string("(").append(a).append(", ").append(b).append(")");
}

}  // namespace

// Each operator below writes one string. So a width that is set on the stream applies to the whole text, and digits are
// not grouped as in the stream's locale.

std::ostream& operator<<(std::ostream& out, BodyId body) {
    return out << text_of(body);
}

std::ostream& operator<<(std::ostream& out, const BodyPair& pair) {
    return out << text_of(text_of(pair.a), text_of(pair.b));
}

std::ostream& operator<<(std::ostream& out, const TrianglePair& pair) {
    return out << text_of(std::to_string(pair.a), std::to_string(pair.b));
}

std::ostream& operator<<(std::ostream& out, ShapeKind kind) {
    return out << name_of(kind);
}

std::string name_of(ShapeKind kind) {
    if (kind == ShapeKind::mesh()) return "mesh";
    if (kind == ShapeKind::rounded()) return "rounded";
    if (kind == ShapeKind::rounded_convex()) return "rounded convex";
    if (kind == ShapeKind::half_space()) return "half space";
    return "kind " + std::to_string(kind.value);
}

}  // namespace ecods
