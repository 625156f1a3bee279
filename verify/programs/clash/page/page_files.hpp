// The files that every page has in it.
#pragma once

#include <string_view>

namespace ecods::clash {

extern const std::string_view page_css;
extern const std::string_view page_html;
extern const std::string_view page_js;

}  // namespace ecods::clash
