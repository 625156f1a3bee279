#include "geometry/words.hpp"

#include <limits>

namespace ecods {

void append(std::string& text, Hex x) {
    append_hex(text, x.value);
}

void append(std::string& text, double x) {
    x > std::numeric_limits<double>::max() ? append(text, std::string_view("inf")) : append_hex(text, x);
}

void append(std::string& text, std::string_view word) {
    text.append(word);
}

void append(std::string& text, BodyId body) {
    append(text, body.slot);
    text.push_back('.');
    append(text, body.generation);
}

void append(std::string& text, const CollisionFilter& filter) {
    append(text, Hex{filter.groups});
    text.push_back(' ');
    append(text, Hex{filter.mask});
}

void append(std::string& text, const Vec3& point) {
    for (int axis = 0; axis < 3; ++axis) {
        if (axis != 0) text.push_back(' ');
        append_hex(text, point[axis]);
    }
}

void append(std::string& text, const Pose& pose) {
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            if (row + column != 0) text.push_back(' ');
            append_hex(text, column == 3 ? pose.t[row] : pose.R(row, column));
        }
    }
}

}  // namespace ecods
