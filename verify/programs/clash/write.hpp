// A report in each format. Bytes depend on the report alone; a stream that fails is the caller's to look at.
#pragma once

#include <iosfwd>

#include "programs/clash/report.hpp"

namespace ecods::clash {

void write_table(std::ostream& out, const ClashReport& report);
void write_json(std::ostream& out, const ClashReport& report);
void write_csv(std::ostream& out, const ClashReport& report);

}  // namespace ecods::clash
