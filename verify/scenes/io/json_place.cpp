#include "scenes/io/json_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

#include "ecods/error.hpp"
#include "ecods/turn.hpp"

namespace ecods::scenes {
namespace {

// Puts the path from one value to another in front of `path`; false, if the other is not in the first. A document is no
// deeper than json_depth_max.
bool find_path(const nlohmann::json& from, const nlohmann::json* wanted, std::string& path) {
    if (&from == wanted) return true;
    if (from.is_array()) {
        for (std::size_t i = 0; i < from.size(); ++i) {
            if (!find_path(from[i], wanted, path)) continue;
            path.insert(0, fmt::format("[{}]", i));
            return true;
        }
    }
    if (from.is_object()) {
        for (const auto& [key, value] : from.get_ref<const nlohmann::json::object_t&>()) {
            if (!find_path(value, wanted, path)) continue;
            path.insert(0, "." + key);
            return true;
        }
    }
    return false;
}

}  // namespace

JsonPlace JsonPlace::within(const nlohmann::json& value) const {
    JsonPlace place = *this;
    place.value_ = &value;
    return place;
}

JsonPlace JsonPlace::at(const std::string& key) const {
    if (auto member = find(key)) return *member;
    fail(fmt::format("\"{}\" is missing", key));
}

std::optional<JsonPlace> JsonPlace::find(const std::string& key) const {
    if (!value_->is_object()) fail("an object is expected");
    const auto member = value_->find(key);
    if (member == value_->end()) return std::nullopt;
    return within(*member);
}

std::vector<JsonPlace> JsonPlace::elements() const {
    std::vector<JsonPlace> places;
    const std::size_t count = size();
    places.reserve(count);
    for (std::size_t i = 0; i < count; ++i) places.push_back(element(i));
    return places;
}

std::vector<JsonPlace> JsonPlace::elements(std::size_t count) const {
    if (!value_->is_array() || value_->size() != count) fail(fmt::format("a list of {} is expected", count));
    return elements();
}

std::size_t JsonPlace::size() const {
    if (!value_->is_array()) fail("a list is expected");
    return value_->size();
}

JsonPlace JsonPlace::element(std::size_t index) const {
    return within((*value_)[index]);
}

std::string JsonPlace::text() const {
    if (!value_->is_string() || value_->get_ref<const std::string&>().empty()) fail("a text is expected");
    return value_->get<std::string>();
}

double JsonPlace::number() const {
    if (!value_->is_number()) fail("a number is expected");
    return value_->get<double>();
}

std::uint32_t JsonPlace::index() const {
    if (!value_->is_number_unsigned()) fail("an index is expected");
    const auto value = value_->get<std::uint64_t>();
    if (value > std::numeric_limits<std::uint32_t>::max()) fail(fmt::format("{} is beyond 32 bits", value));
    return static_cast<std::uint32_t>(value);
}

std::uint64_t JsonPlace::count() const {
    if (!value_->is_number_unsigned()) fail("a whole number is expected");
    const auto value = value_->get<std::uint64_t>();
    if (value >> 53 != 0) fail(fmt::format("{} is beyond 53 bits", value));
    return value;
}

bool JsonPlace::boolean() const {
    if (!value_->is_boolean()) fail("true or false is expected");
    return value_->get<bool>();
}

Vec3 JsonPlace::point() const {
    const auto coordinates = elements(3);
    return {coordinates[0].number(), coordinates[1].number(), coordinates[2].number()};
}

void JsonPlace::check_keys(std::initializer_list<const char*> known) const {
    if (!value_->is_object()) fail("an object is expected");
    for (const auto& [key, value] : value_->items()) {
        if (key.starts_with("_")) continue;
        if (std::find(known.begin(), known.end(), std::string_view(key)) == known.end()) {
            fail(fmt::format("the key \"{}\" is unknown", key));
        }
    }
}

void JsonPlace::fail(const std::string& text) const {
    std::string path;
    find_path(*document_, value_, path);
    throw ReadError(*file_, path.starts_with('.') ? path.substr(1) : path, text);
}

std::shared_ptr<const Mesh> make_mesh(const JsonPlace& place, MeshSoup soup) {
    try {
        return make_mesh(place.file(), "", std::move(soup));
    } catch (const ReadError& error) {
        place.fail(error.text);
    }
}

Pose read_pose(const JsonPlace& place) {
    place.check_keys({"R", "t"});
    Pose pose;
    if (const auto rows = place.find("R")) {
        for (int row = 0; row < 3; ++row) {
            pose.R.row(row) = rows->elements(3)[static_cast<std::size_t>(row)].point().transpose();
        }
    }
    if (const auto translation = place.find("t")) pose.t = translation->point();
    return pose;
}

namespace {

// The angle in radians, which a turn about an axis says in one of two units.
double read_angle(const JsonPlace& place) {
    const auto angle = place.find("angle"), degrees = place.find("degrees");
    if (angle.has_value() == degrees.has_value()) place.fail("one of \"q\", \"degrees\" and \"angle\" is expected");
    return angle ? angle->number() : degrees->number() / 180 * std::numbers::pi;
}

Turn read_quaternion_turn(const JsonPlace& q, const Vec3& pivot) {
    const auto parts = q.elements(4);
    return {{parts[0].number(), parts[1].number(), parts[2].number(), parts[3].number()}, pivot, pivot};
}

Turn read_axis_turn(const JsonPlace& place, const Vec3& pivot) {
    const Vec3 axis = place.at("axis").point();
    return about(axis, read_angle(place), pivot);
}

}  // namespace

Turn read_turn(const JsonPlace& place) {
    const auto q = place.find("q"), pivot = place.find("pivot"), pivot_to = place.find("pivot_to");
    if (q) {
        place.check_keys({"q", "pivot", "pivot_to"});
    } else {
        place.check_keys({"axis", "degrees", "angle", "pivot", "pivot_to"});
    }
    const Vec3 at = pivot ? pivot->point() : Vec3(0, 0, 0);
    try {
        Turn turn = q ? read_quaternion_turn(*q, at) : read_axis_turn(place, at);
        if (pivot_to) turn.pivot_to = pivot_to->point();
        validate(turn);
        return turn;
    } catch (const InvalidArgument& error) {
        place.fail(error.what());
    }
}

std::shared_ptr<const Mesh> read_inline_mesh(const JsonPlace& place) {
    MeshSoup soup;
    for (const JsonPlace& vertex : place.at("vertices").elements()) soup.vertices.push_back(vertex.point());
    for (const JsonPlace& triangle : place.at("triangles").elements()) {
        const auto corners = triangle.elements(3);
        for (const JsonPlace& corner : corners) {
            if (corner.index() >= soup.vertices.size()) {
                corner.fail(fmt::format("index {} is out of range: there are {} vertices", corner.index(),
                                        soup.vertices.size()));
            }
        }
        soup.triangles.push_back({corners[0].index(), corners[1].index(), corners[2].index()});
    }
    return make_mesh(place, std::move(soup));
}

}  // namespace ecods::scenes
