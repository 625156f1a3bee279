#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "base/sha256.hpp"
#include "bvh/walks/tree_view.hpp"
#include "ecods/certificate.hpp"
#include "geometry/words.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {
namespace {

// Writes the canonical text of a mesh (verify/certificates/README.md) to `sink`, which is a stream or a digest.
template <class Sink>
class MeshText {
  public:
    MeshText(const MeshShape& shape, Sink& sink)
        : mesh_(shape.mesh()), tree_(MeshShapeAccess::tree(shape).boxes), sink_(sink) {}

    void write() {
        line("ecods-mesh 1");
        line("vertices", mesh_.vertices().size(), "triangles", mesh_.triangles().size(), "nodes",
             tree_.nodes.size() + tree_.leaves.size());
        for (const Vec3& v : mesh_.vertices()) line(v);
        visit([&](TreeRef ref) {
            if (ref.is_leaf()) write_triangles(tree_.leaves[ref.index()]);
        });
        visit([&](TreeRef ref) {
            line(ref.is_leaf() ? "l" : "n",
                 ref.is_leaf() ? tree_.leaves[ref.index()].count : tree_.nodes[ref.index()].count);
        });
        sink_(text_);
    }

  private:
    static constexpr std::size_t piece = 1 << 16;

    template <class... Words>
    void line(const Words&... words) {
        append_line(text_, words...);
        if (text_.size() < piece) return;
        sink_(text_);
        text_.clear();
    }

    void write_triangles(const TreeLeaf& leaf) {
        for (std::size_t lane = 0; lane < leaf.count; ++lane) {
            const Triangle& corners = mesh_.triangles()[leaf.triangle[lane]];
            line(corners[0], corners[1], corners[2], leaf.triangle[lane]);
        }
    }

    // Calls each(ref) for all nodes and leaves of the tree, in pre-order.
    template <class Visit>
    void visit(Visit&& each) {
        const auto all = [&](TreeRef ref) -> std::uint32_t {
            each(ref);
            return ref.is_leaf() ? 0 : tree_.nodes[ref.index()].lanes();
        };
        walk_one<LaneOrder::first_first>(TreeView(tree_), stack_, all, [](TreeRef, std::uint32_t) { return true; });
    }

    const Mesh& mesh_;
    const MeshBvh& tree_;
    Sink& sink_;
    std::string text_;
    std::vector<TreeRef> stack_;
};

}  // namespace

void write_certified_mesh(std::ostream& out, const MeshShape& shape) {
    const auto sink = [&](std::string_view text) { write_text(out, text); };
    MeshText(shape, sink).write();
}

std::string certified_mesh_digest(const MeshShape& shape) {
    return hexadecimal(MeshShapeAccess::digest(shape, [](const MeshShape& of) {
        Sha256 sink;
        MeshText(of, sink).write();
        return sink.finish();
    }));
}

}  // namespace ecods
