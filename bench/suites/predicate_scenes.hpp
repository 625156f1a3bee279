// Bodies whose triangle pairs are nothing but generic, or nothing but degenerate: what the exact layer is timed on.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"

namespace ecods::bench {

struct PredicateBody {
    std::shared_ptr<const Mesh> mesh;
    Pose pose;
};

// Two bodies and those pairs of their triangles whose boxes (padded by rounding) overlap.
struct PredicateTask {
    std::size_t a;
    std::size_t b;
    std::vector<TrianglePair> pairs;
};

struct PredicateScene {
    std::string name;
    double must;  // times the time of plain double
    double aim;
    std::vector<PredicateBody> bodies;
    std::vector<PredicateTask> tasks;

    std::size_t pair_count() const {
        std::size_t count = 0;
        for (const PredicateTask& task : tasks) count += task.pairs.size();
        return count;
    }
};

std::vector<PredicateScene> predicate_scenes(std::size_t body_count);

}  // namespace ecods::bench
