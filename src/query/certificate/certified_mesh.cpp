#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "base/number_text.hpp"
#include "ecods/certificate.hpp"
#include "exact/number/limbs.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {
namespace {

// What takes text piece by piece: a stream, or a digest.
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

    // In pre-order.
    template <class Visit>
    void visit(Visit&& each) {
        stack_.assign(1, tree_.root);
        while (!stack_.empty()) {
            const TreeRef top = stack_.back();
            stack_.pop_back();
            each(top);
            if (top.is_leaf()) continue;
            const BvhNode& node = tree_.nodes[top.index()];
            for (std::size_t lane = node.count; lane-- > 0;) stack_.push_back(node.child[lane]);
        }
    }

    const Mesh& mesh_;
    const MeshBvh& tree_;
    Sink& sink_;
    std::string text_;
    std::vector<TreeRef> stack_;
};

// The number that has the bytes of a text as its digits to base 256, modulo 2^128 - 159.
class TextDigest {
    using Uint128 = exact::Uint128;

  public:
    void operator()(std::string_view text) {
        for (const char c : text) {
            word_ = word_ << 8 | static_cast<unsigned char>(c);
            if (++byte_count_ == 8) take_word();
        }
    }
    MeshShapeAccess::Digest get() {
        take_word();
        return {static_cast<std::uint64_t>(value_ >> 64), static_cast<std::uint64_t>(value_)};
    }

  private:
    // value 2^(8 bytes) + word. 2^128 is 159, so what is shifted out comes back times that: below 2^72 once, and below
    // 159 (2^7 + 1) < 2^15 the second time, which cannot carry again.
    void take_word() {
        if (byte_count_ == 0) return;
        const int bits = 8 * byte_count_;
        add_reduced(static_cast<std::uint64_t>(value_ >> (128 - bits)), value_ << bits, word_);
        word_ = 0;
        byte_count_ = 0;
    }
    void add_reduced(std::uint64_t high, Uint128 low, std::uint64_t word) {
        const Uint128 more = Uint128{high} * 159 + word;
        value_ = low + more;
        if (value_ < more) value_ += 159;
        if (value_ >= modulus) value_ -= modulus;
    }

    static constexpr Uint128 modulus = ~Uint128{0} - 158;
    Uint128 value_ = 0;
    std::uint64_t word_ = 0;
    int byte_count_ = 0;
};

}  // namespace

void write_certified_mesh(std::ostream& out, const MeshShape& shape) {
    const auto sink = [&](std::string_view text) { out.write(text.data(), static_cast<std::streamsize>(text.size())); };
    MeshText(shape, sink).write();
}

std::string certified_mesh_digest(const MeshShape& shape) {
    const auto& digest = MeshShapeAccess::digest(shape, [](const MeshShape& of) {
        TextDigest sink;
        MeshText(of, sink).write();
        return sink.get();
    });
    std::string text;
    for (const std::uint64_t word : digest) {
        std::string digits;
        append_hex(digits, word);
        text.append(16 - digits.size(), '0').append(digits);
    }
    return text;
}

}  // namespace ecods
