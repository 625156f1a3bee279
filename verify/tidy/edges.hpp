// The map of the house: which rooms there are, and which rooms each may include.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ecods::tidy {

// A folder, and the rooms whose files its files may include beside its own. A row names rows above it only, so rooms
// cannot form a circle.
struct Room {
    std::string_view folder;
    std::vector<std::string_view> below;
};

// From the bottom to the top. Two names stand for public headers: "include" for all of them, "include/plain" for those
// of plain data, which is what the oracle knows of the library.
const std::vector<Room>& rooms();

// The room of a file: the longest folder of the table that leads to it. A public header belongs to the room whose words
// it declares. Nothing: the file is in no room.
const Room* find_room(std::string_view file);

// Whether a public header holds plain data only.
bool is_plain_header(std::string_view file);

}  // namespace ecods::tidy
