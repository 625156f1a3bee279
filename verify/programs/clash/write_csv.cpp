// The report as CSV (RFC 4180, but that lines end with LF): a header, then a line for each clash. What a clash has not
// is empty. A name that a spreadsheet would take for a formula has an apostrophe before it.
#include <fmt/format.h>

#include <cmath>
#include <ostream>
#include <string>

#include "process/csv_field.hpp"
#include "programs/clash/write.hpp"

namespace ecods::clash {
namespace {

std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : value > 0 ? "inf" : "-inf";
}

}  // namespace

void write_csv(std::ostream& out, const ClashReport& report) {
    out << "kind,relation,a,b,file_a,file_b,group_a,group_b,distance,depth_lower,depth_upper,min_x,min_y,min_z,max_x,"
           "max_y,max_z\n";
    for (const Clash& clash : report.clashes) {
        const Part& a = report.parts[clash.a];
        const Part& b = report.parts[clash.b];
        out << fmt::format("{},{},{},{},{},{},{},{},{},{},{}", name_of(clash.kind), clash.relation,
                           process::csv_name(a.name), process::csv_name(b.name), process::csv_name(a.file),
                           process::csv_name(b.file), a.group, b.group, clash.distance ? number(*clash.distance) : "",
                           clash.depth ? number(clash.depth->lower) : "",
                           clash.depth ? number(clash.depth->upper) : "");
        for (const Vec3& corner : {clash.place.box.min, clash.place.box.max}) {
            for (int axis = 0; axis < 3; ++axis) out << ',' << number(corner[axis]);
        }
        out << '\n';
    }
}

}  // namespace ecods::clash
