#include "scenes/building/building_relations.hpp"

#include <numeric>
#include <stdexcept>

#include "scenes/building/element_blocks.hpp"
#include "scenes/building/pipe_contact.hpp"

namespace ecods::scenes {
namespace {

// How much of `block` the others cover. They have disjoint interiors.
Length covered(const Block& block, const Blocks& others) {
    Length sum = 0;
    for (const Block& other : others) sum += measure(common(block, other), block);
    return sum;
}

Length volume(const Blocks& blocks) {
    Length sum = 0;
    for (const Block& block : blocks) sum += measure(block, block);
    return sum;
}

bool share_a_point(const Blocks& a, const Blocks& b) {
    for (const Block& one : a) {
        for (const Block& other : b) {
            if (!is_empty(common(one, other))) return true;
        }
    }
    return false;
}

Contact contact_of_blocks(const Blocks& a, const Blocks& b) {
    Length shared = 0;
    for (const Block& one : a) shared += covered(one, b);
    if (shared == 0) return share_a_point(a, b) ? Contact::touching : Contact::apart;
    const bool is_inside = shared == volume(a);
    if (shared == volume(b)) return is_inside ? Contact::equal : Contact::contains;
    return is_inside ? Contact::inside : Contact::overlapping;
}

// A face in the plane between two blocks of a solid would be inside it, though inside none of them.
void require_no_seam(const Block& face, const Blocks& solid) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (face.min[axis] < face.max[axis]) continue;
        const auto begins = [&](const Block& block) {
            return block.min[axis] == face.min[axis] && !is_empty(common(block, face));
        };
        const auto ends = [&](const Block& block) {
            return block.max[axis] == face.min[axis] && !is_empty(common(block, face));
        };
        if (std::any_of(solid.begin(), solid.end(), begins) && std::any_of(solid.begin(), solid.end(), ends))
            throw std::logic_error("a face lies in a seam of a solid");
    }
}

// Whether inner points of the face are inside the block, of which it may be a face.
bool reaches_into(const Block& face, const Block& block) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool is_flat = face.min[axis] == face.max[axis];
        if (is_flat && (face.min[axis] <= block.min[axis] || face.min[axis] >= block.max[axis])) return false;
        if (std::max(face.min[axis], block.min[axis]) >= std::min(face.max[axis], block.max[axis]) && !is_flat)
            return false;
    }
    return true;
}

Contact contact_of_surface(const Blocks& faces, const Blocks& solid) {
    bool is_in = false;
    bool is_all_covered = true;
    for (const Block& face : faces) {
        require_no_seam(face, solid);
        for (const Block& block : solid) is_in = is_in || reaches_into(face, block);
        is_all_covered = is_all_covered && covered(face, solid) == measure(face, face);
    }
    if (is_in) return is_all_covered ? Contact::inside : Contact::partly_inside;
    return share_a_point(faces, solid) ? Contact::touching : Contact::apart;
}

bool are_equal(const Block& a, const Block& b) {
    return a.min == b.min && a.max == b.max;
}

Contact exchanged(Contact contact) {
    if (contact == Contact::inside) return Contact::contains;
    return contact == Contact::contains ? Contact::inside : contact;
}

// Whichever way the elements are cut into triangles.
Contact contact_of(const Element& a, const Element& b) {
    const bool is_surface_a = a.defect != Defect::none;
    const bool is_surface_b = b.defect != Defect::none;
    if (a.is_pipe() || b.is_pipe()) {
        if (is_surface_a || is_surface_b) throw std::logic_error("a surface is at a pipe");
        if (a.is_pipe() && b.is_pipe()) return contact_of_pipes(a, b);
        return a.is_pipe() ? contact_of_pipe(a, solid_of(b)) : exchanged(contact_of_pipe(b, solid_of(a)));
    }
    if (is_surface_a && is_surface_b) {
        if (a.defect == b.defect && are_equal(bounds_of(a), bounds_of(b))) return Contact::equal;
        throw std::logic_error("two surfaces meet");
    }
    if (is_surface_a) return contact_of_surface(faces_of(a), solid_of(b));
    if (is_surface_b) return exchanged(contact_of_surface(faces_of(b), solid_of(a)));
    return contact_of_blocks(solid_of(a), solid_of(b));
}

Blocks blocks_of(const Element& element) {
    if (element.is_pipe()) return {bounds_of(element)};
    return element.defect == Defect::none ? solid_of(element) : faces_of(element);
}

// The distance of elements that are apart, if it is at most the clearance. A pipe is the box around it, where that is
// the same.
std::optional<double> distance_of(const Element& a, const Element& b, Length clearance) {
    std::optional<double> least;
    for (const Block& one : blocks_of(a)) {
        for (const Block& other : blocks_of(b)) {
            const Block between = common(one, other);
            Length square = 0;
            std::size_t gap_count = 0;
            double gap = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Length length = between.min[axis] - between.max[axis];
                if (length <= 0) continue;
                square += length * length;
                ++gap_count;
                gap = meters(between.min[axis]) - meters(between.max[axis]);
            }
            if (square > clearance * clearance) continue;
            if (gap_count != 1 || square == clearance * clearance) throw std::logic_error("a distance is not known");
            if (a.is_pipe()) require_extreme_at(a, other);
            if (b.is_pipe()) require_extreme_at(b, one);
            if (!least || gap < *least) least = gap;
        }
    }
    return least;
}

bool is_box(const Element& element) {
    return element.defect == Defect::none && element.filled.size() == 1;
}

// Of two boxes.
double depth_of(const Block& a, const Block& b) {
    double least = meters(a.max[0]) - meters(b.min[0]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        least = std::min(least, meters(a.max[axis]) - meters(b.min[axis]));
        least = std::min(least, meters(b.max[axis]) - meters(a.min[axis]));
    }
    return least;
}

std::optional<KnownRelation> relate(const std::vector<Element>& elements, std::size_t a, std::size_t b,
                                    Length clearance) {
    const Element& one = elements[a];
    const Element& other = elements[b];
    KnownRelation known{a, b};
    // A surface at a pipe is asked about only where the boxes meet.
    const Block shared = common(bounds_of(one), bounds_of(other));
    if (!is_empty(shared)) known.contact = contact_of(one, other);
    if (known.contact == Contact::apart) {
        known.distance = distance_of(one, other, clearance);
        if (!known.distance) return std::nullopt;
    } else if (is_box(one) && is_box(other)) {
        known.common = shared;
        if (known.contact != Contact::touching) known.depth = depth_of(bounds_of(one), bounds_of(other));
    }
    return known;
}

}  // namespace

std::vector<KnownRelation> known_relations(const std::vector<Element>& elements, Length clearance) {
    std::vector<Block> bounds;
    for (const Element& element : elements) bounds.push_back(bounds_of(element));
    std::vector<std::size_t> order(elements.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return bounds[a].min[0] < bounds[b].min[0]; });
    std::vector<KnownRelation> relations;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Block& one = bounds[order[i]];
        for (std::size_t j = i + 1; j < order.size() && bounds[order[j]].min[0] <= one.max[0] + clearance; ++j) {
            Block wide = bounds[order[j]];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                wide.min[axis] -= clearance;
                wide.max[axis] += clearance;
            }
            if (is_empty(common(one, wide))) continue;
            const auto known = relate(elements, std::min(order[i], order[j]), std::max(order[i], order[j]), clearance);
            if (known) relations.push_back(*known);
        }
    }
    std::sort(relations.begin(), relations.end(),
              [](const KnownRelation& x, const KnownRelation& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    return relations;
}

}  // namespace ecods::scenes
