#include "judge/whether_solid.hpp"

#include <fmt/format.h>

#include "ecods/error.hpp"
#include "ecods/solid.hpp"
#include "judge/solid_truth.hpp"

namespace ecods::judge {
namespace {

std::string text(const std::vector<TrianglePair>& pairs) {
    std::string list;
    for (const TrianglePair& pair : pairs) list += fmt::format("({}, {}) ", pair.a, pair.b);
    return list;
}

}  // namespace

WhetherSolid::WhetherSolid(const Mesh& mesh)
    : is_empty_(oracle::bounds_nothing(mesh)),
      open_(oracle::open_edge(mesh)),
      pairs_(oracle::self_intersections(mesh)) {}

std::string WhetherSolid::words() const {
    if (is_empty_) return "nothing";
    if (open_) return fmt::format("open edge {}.{}", open_->triangle, open_->corner);
    return pairs_.empty() ? "a solid" : text({pairs_.front()});
}

std::optional<Wrong> WhetherSolid::ask(const Mesh& mesh) const {
    const std::vector<TrianglePair> got = self_intersections(mesh);
    if (got != pairs_) return Wrong{"self_intersections", text(pairs_), text(got)};
    const std::string expected = words();
    std::string found = "a solid";
    try {
        check_solid(mesh);
    } catch (const NotSolid& error) {
        switch (error.reason) {
            case NotSolid::Reason::no_interior:
                found = "nothing";
                break;
            case NotSolid::Reason::open_edge:
                found = fmt::format("open edge {}.{}", error.triangle, error.corner);
                break;
            default:
                found = text({error.triangles});
        }
    }
    if (found != expected) return Wrong{"check_solid", expected, found};
    return std::nullopt;
}

std::optional<Wrong> ask_whether_solid(const Mesh& mesh) {
    return WhetherSolid(mesh).ask(mesh);
}

}  // namespace ecods::judge
