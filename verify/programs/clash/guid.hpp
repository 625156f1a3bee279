// Identifiers that are the same for the same names.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace ecods::clash {

// A UUID of version 8 (RFC 9562) in lower case, of a hash of the texts. Texts that differ in how they are cut differ.
std::string guid_of(std::initializer_list<std::string_view> texts);

// The IFC GUID, 22 characters of its base 64, that a part's name is or has as its last piece; otherwise empty. A piece
// begins behind a character that is no digit of the base, or behind '_' where the name begins with "Ifc".
std::string_view ifc_guid_in(std::string_view name);

}  // namespace ecods::clash
