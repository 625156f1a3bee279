// HitCollector finds all triangles of a body that a line hits. Their order is not promised.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "query/hit/hit_memory.hpp"

namespace ecods {

// HitCollector calls add(triangle, hit) for each triangle that is hit, with the exact points that the triangle shares
// with the line. The collector's limit excludes no part of the line.
template <class Add>
class HitCollector {
  public:
    HitCollector(HitMemory& memory, QueryCounts& counts, const Mesh& mesh, Add& add)
        : memory_(memory), counts_(counts), mesh_(mesh), add_(add) {}

    float limit() const noexcept { return 1; }
    void visit_node() noexcept { ++counts_.box_tests; }
    void visit(const TreeLeaf& leaf, const FoundInLeaf& found) {
        counts_.hits.triangle_tests += leaf.count;
        for (std::uint32_t lanes = found.may_meet; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            visit(leaf.triangle[lane], leaf.vertices[lane]);
        }
    }
    void visit(std::uint32_t triangle) { visit(triangle, mesh_.triangles()[triangle]); }
    void visit(std::uint32_t triangle, const Triangle& vertices) {
        ++counts_.hits.enclosures;
        const HitEnclosure enclosure = memory_.triangles.enclose(vertices);
        if (enclosure.verdict == HitEnclosure::Verdict::none) return;
        ++counts_.hits.exact;
        if (enclosure.verdict == HitEnclosure::Verdict::face) {
            memory_.triangles.find_crossing(vertices, *memory_.other);
        } else if (!memory_.triangles.find(vertices, *memory_.other)) {
            return;
        }
        add_(triangle, *memory_.other);
    }

  private:
    HitMemory& memory_;
    QueryCounts& counts_;
    const Mesh& mesh_;
    Add& add_;
};

// Calls add(triangle, hit) for each triangle of the body that the line hits.
template <class Add>
void collect_hits(const Line& line, const ScaledLine& scaled, const Posed<MeshShape>& body, HitMemory& memory,
                  QueryCounts& counts, Add&& add) {
    ++counts.queries;
    const LineAxes::Place place = memory.bind(line, scaled, scaled.end_high, body);
    HitCollector collector(memory, counts, body.what->mesh(), add);
    memory.walk(body, place, collector);
}

}  // namespace ecods
