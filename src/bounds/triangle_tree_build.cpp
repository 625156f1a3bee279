#include <algorithm>
#include <numeric>

#include "bounds/next.hpp"
#include "bounds/triangle_tree.hpp"

namespace ecods {
namespace {

struct Range {
    std::uint32_t node;
    std::uint32_t begin;
    std::uint32_t end;
};

class Builder {
  public:
    explicit Builder(const Mesh& mesh) : mesh_(mesh) {
        tree_.order.resize(mesh.triangles().size());
        std::iota(tree_.order.begin(), tree_.order.end(), 0u);
    }

    TriangleTree build() {
        tree_.nodes.emplace_back();
        std::vector<Range> open{{0, 0, static_cast<std::uint32_t>(tree_.order.size())}};
        while (!open.empty()) {
            const Range range = open.back();
            open.pop_back();
            const int axis = set_box(range);
            TreeNode& node = tree_.nodes[range.node];
            if (range.end - range.begin <= TriangleTree::leaf_size) {
                node.begin = range.begin;
                node.count = range.end - range.begin;
                continue;
            }
            const auto child = static_cast<std::uint32_t>(tree_.nodes.size());
            node.begin = child;
            node.count = 0;
            const std::uint32_t middle = split(range, axis);
            tree_.nodes.resize(tree_.nodes.size() + 2);
            open.push_back({child, range.begin, middle});
            open.push_back({child + 1, middle, range.end});
        }
        return std::move(tree_);
    }

  private:
    // Sets the node's box and returns its longest axis.
    int set_box(const Range& range) {
        Vec3 min = corner(tree_.order[range.begin], 0);
        Vec3 max = min;
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                min = min.cwiseMin(corner(tree_.order[i], k));
                max = max.cwiseMax(corner(tree_.order[i], k));
            }
        }
        TreeNode& node = tree_.nodes[range.node];
        // Halved before they are added: the sum of two large coordinates may overflow.
        node.center = 0.5 * min + 0.5 * max;
        for (int k = 0; k < 3; ++k) {
            // A difference is rounded by at most one place, in any rounding mode.
            node.half[k] = next_up(std::max(max[k] - node.center[k], node.center[k] - min[k]));
        }
        Eigen::Index axis = 0;
        node.half.maxCoeff(&axis);
        return static_cast<int>(axis);
    }

    std::uint32_t split(const Range& range, int axis) {
        const std::uint32_t middle = range.begin + (range.end - range.begin) / 2;
        const auto at = [&](std::uint32_t i) { return tree_.order.begin() + i; };
        std::nth_element(at(range.begin), at(middle), at(range.end), [&](std::uint32_t a, std::uint32_t b) {
            const double x = middle_of(a, axis), y = middle_of(b, axis);
            return x < y || (x == y && a < b);
        });
        return middle;
    }

    const Vec3& corner(std::uint32_t triangle, std::size_t k) const {
        return mesh_.vertices()[mesh_.triangles()[triangle][k]];
    }

    double middle_of(std::uint32_t triangle, int axis) const {
        const double a = corner(triangle, 0)[axis], b = corner(triangle, 1)[axis], c = corner(triangle, 2)[axis];
        return 0.5 * std::min({a, b, c}) + 0.5 * std::max({a, b, c});
    }

    const Mesh& mesh_;
    TriangleTree tree_;
};

}  // namespace

TriangleTree build_triangle_tree(const Mesh& mesh) {
    return Builder(mesh).build();
}

}  // namespace ecods
