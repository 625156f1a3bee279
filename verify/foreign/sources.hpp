// The sources of expectations. Each is a program that others test themselves with; README.md says where it is.
#pragma once

#include <span>
#include <string_view>

#include "foreign/expectations.hpp"

namespace ecods::foreign {

struct Source {
    std::string_view name;
    void (*ask)(Expectations&);
};

// Each asks all of its expectations.
namespace cgal {
void ask(Expectations& expect);
}
namespace cgal_orders {
void ask(Expectations& expect);
}
namespace coal {
void ask(Expectations& expect);
}
namespace embree {
void ask(Expectations& expect);
}
namespace fcl_boxes {
void ask(Expectations& expect);
}
namespace fcl_projections {
void ask(Expectations& expect);
}
namespace jolt_hulls {
void ask(Expectations& expect);
}
namespace jolt_points {
void ask(Expectations& expect);
}
namespace jolt_rays {
void ask(Expectations& expect);
}
namespace libccd {
void ask(Expectations& expect);
}
namespace mujoco {
void ask(Expectations& expect);
}
namespace parry {
void ask(Expectations& expect);
}
namespace sample_queries {
void ask(Expectations& expect);
}
namespace shen {
void ask(Expectations& expect);
}
namespace trimesh {
void ask(Expectations& expect);
}

std::span<const Source> sources();

}  // namespace ecods::foreign
