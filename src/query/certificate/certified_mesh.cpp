#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "base/number_text.hpp"
#include "base/sha256.hpp"
#include "bvh/walks/tree_view.hpp"
#include "ecods/certificate.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {
namespace {

// Writes a mesh's canonical text (verify/certificates/README.md), piece by piece, to a sink: a stream or a digest.
template <class Sink>
class MeshText {
  public:
    MeshText(const MeshShape& shape, Sink& sink)
        : mesh_(shape.mesh()), tree_(MeshShapeAccess::tree(shape).boxes), sink_(sink) {}

    void write() {
        put("ecods-mesh 1\nvertices").put(mesh_.vertices().size()).put(" triangles").put(mesh_.triangles().size());
        put(" nodes").put(tree_.nodes.size() + tree_.leaves.size()).end_line();
        for (const Vec3& v : mesh_.vertices()) {
            for (int axis = 0; axis < 3; ++axis) {
                if (axis > 0) text_.push_back(' ');
                append_hex(text_, v[axis]);
            }
            end_line();
        }
        visit([&](TreeRef ref) {
            if (ref.is_leaf()) write_triangles(tree_.leaves[ref.index()]);
        });
        visit([&](TreeRef ref) {
            put(ref.is_leaf() ? "l" : "n");
            put(ref.is_leaf() ? tree_.leaves[ref.index()].count : tree_.nodes[ref.index()].count).end_line();
        });
        sink_(text_);
    }

  private:
    static constexpr std::size_t piece = 1 << 16;

    MeshText& put(const char* word) {
        text_.append(word);
        return *this;
    }
    MeshText& put(std::uint64_t x) {
        text_.push_back(' ');
        append(text_, x);
        return *this;
    }
    void end_line() {
        text_.push_back('\n');
        if (text_.size() < piece) return;
        sink_(text_);
        text_.clear();
    }

    void write_triangles(const TreeLeaf& leaf) {
        for (std::size_t lane = 0; lane < leaf.count; ++lane) {
            const Triangle& corners = mesh_.triangles()[leaf.triangle[lane]];
            append(text_, corners[0]);
            put(corners[1]).put(corners[2]).put(leaf.triangle[lane]).end_line();
        }
    }

    // Visits the nodes and leaves in pre-order.
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
    const auto sink = [&](std::string_view text) { out.write(text.data(), static_cast<std::streamsize>(text.size())); };
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
