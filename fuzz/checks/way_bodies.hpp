// The bodies that questions about ways are asked of, and what is expected of worlds.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/world.hpp"
#include "fuzz/base/failure.hpp"
#include "fuzz/checks/text.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

// Numbers of bodies of which all pairs are asked one by one.
inline constexpr std::size_t few = 24, very_few = 12;

// The mesh of a body that is not rounded.
Posed<MeshShape> mesh_at(const Shape& shape, const Pose& pose);
Posed<MeshShape> mesh_at(const World& world, BodyId body);

// The mesh of a body, each vertex of which goes to a place near that of the translation; nullopt if one is no double.
std::optional<Deforming> deformed(const Posed<MeshShape>& body, const Vec3& motion, scenes::Random& random);

// A point that bodies are near: a corner of a mesh at its pose, or of a box. Points that are no doubles are left out.
Vec3 any_point(const World& world, const std::vector<BodyId>& bodies, scenes::Random& random);

// True if no number of the bodies is above 2^64 or below 2^-64, but for zero.
bool have_moderate_numbers(const World& world, const std::vector<BodyId>& bodies);

// True if all pairs can be asked in a fraction of a second, by questions that take `factor` times as long as casts of
// translations.
bool are_soon_asked(const World& world, const std::vector<BodyId>& bodies, std::size_t factor = 1);

// Meetings in all worlds are these; where kinds differ, a test may have the features' order of its own.
template <class Item>
void require_meetings(std::span<World* const> worlds, std::vector<Meeting> expected, const std::vector<BodyId>& moved,
                      const std::vector<Item>& ways) {
    std::ranges::stable_sort(expected, {}, [](const Meeting& meeting) { return meeting.contact.time; });
    const World& first = *worlds.front();
    for (World* world : worlds) {
        const auto got = world->meetings(moved, ways);
        const auto fields_of = [&](const Meeting& meeting) {
            return std::tuple(meeting.contact.time, numbers_of(meeting.bodies.a), numbers_of(meeting.bodies.b));
        };
        bool is_same = std::ranges::equal(got, expected, {}, fields_of, fields_of);
        for (std::size_t i = 0; is_same && i < got.size(); ++i) {
            const bool are_meshes = first.shape(expected[i].bodies.a)->kind() == ShapeKind::mesh() &&
                                    first.shape(expected[i].bodies.b)->kind() == ShapeKind::mesh();
            is_same = !are_meshes || got[i].contact == expected[i].contact;
        }
        if (!is_same) throw CheckFailed("meetings", text(expected), text(got));
    }
}

}  // namespace ecods::fuzz
