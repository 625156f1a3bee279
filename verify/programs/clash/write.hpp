// A report in each format. Bytes depend on the report alone; a stream that fails is the caller's to look at.
#pragma once

#include <iosfwd>
#include <span>
#include <string>

#include "programs/clash/picture/pictures.hpp"
#include "programs/clash/report.hpp"

namespace ecods::clash {

void write_table(std::ostream& out, const ClashReport& report);
void write_json(std::ostream& out, const ClashReport& report);
void write_csv(std::ostream& out, const ClashReport& report);

// One page that opens from disk, with the pictures of the first clashes.
void write_html(std::ostream& out, const ClashReport& report, std::span<const Picture> pictures);

// The BIM Collaboration Format, 2.1: a zip file with a topic for each clash, and pictures of the first. `date` is that
// of the topics, as xs:dateTime: the format demands one. Throws std::runtime_error if can_write_bcf() is false.
void write_bcf(std::ostream& out, const ClashReport& report, std::span<const Picture> pictures,
               const std::string& date);

// Whether this program was built with libzip and pugixml.
bool can_write_bcf() noexcept;

}  // namespace ecods::clash
