// Names, which may be any bytes, as the text of a format.
#pragma once

#include <string>
#include <string_view>

namespace ecods::clash {

// A JSON string with its quotes. Bytes that are no UTF-8 become U+FFFD.
std::string json_text(std::string_view text);

// The same, for a script element of HTML: with no '<'.
std::string json_text_in_html(std::string_view text);

// The characters, not escaped, with U+FFFD for bytes that are no UTF-8 and for characters that XML 1.0 does not allow.
std::string xml_characters(std::string_view text);

// RFC 4648, section 4.
std::string base64(std::string_view bytes);

}  // namespace ecods::clash
