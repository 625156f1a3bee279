#include "mesh.hpp"

#include <openssl/crypto.h>
#include <openssl/evp.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "text.hpp"
#include "vectors.hpp"

namespace certificate_checker {
namespace {

constexpr std::string_view first_line = "ecods-mesh 1\n";
constexpr std::size_t depth_max = 200;

// SHA-256. No configuration file is read: one could put another implementation in the place of OpenSSL's own.
std::string digest_of(std::string_view bytes) {
    std::array<unsigned char, 32> digest{};
    OPENSSL_init_crypto(OPENSSL_INIT_NO_LOAD_CONFIG, nullptr);
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1) {
        throw Unreadable{"libcrypto gives no SHA-256"};
    }
    std::string digits;
    for (const unsigned char byte : digest) {
        digits += {"0123456789abcdef"[byte >> 4], "0123456789abcdef"[byte & 15]};
    }
    return digits;
}

// Throws Refusal unless the text may hold so many lines of so many bytes each: nothing is allocated for more.
std::size_t plausible(const Text& in, std::string_view text, std::uint32_t count, std::size_t line_bytes) {
    if (count > text.size() / line_bytes) in.fail("more than the file can hold");
    return count;
}

void read_triangles(Text& in, Mesh& mesh) {
    constexpr std::uint32_t unset = std::numeric_limits<std::uint32_t>::max();
    std::fill(mesh.position.begin(), mesh.position.end(), unset);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        in.require_line();
        for (std::uint32_t& corner : mesh.triangles[i]) {
            corner = in.count();
            if (corner >= mesh.vertices.size()) in.fail("no such vertex");
        }
        const std::uint32_t number = in.count();
        if (number >= mesh.position.size() || mesh.position[number] != unset) in.fail("not a permutation");
        mesh.position[number] = i;
        in.end_of_line();
    }
}

void read_tree(Text& in, Mesh& mesh) {
    const auto node_count = static_cast<std::uint32_t>(mesh.nodes.size());
    std::uint32_t next_node = 1;
    std::uint32_t next_triangle = node_count;  // as a part
    std::vector<Node> open = {{0, 1}};         // on the way from the root: the nodes that have no line yet
    for (std::uint32_t i = 0; i < node_count; ++i) {
        in.require_line();
        while (!open.empty() && open.back().count == 0) open.pop_back();
        if (open.empty()) in.fail("more nodes than the tree has");
        Node& node = mesh.nodes[open.back().first++];
        --open.back().count;
        const std::string_view kind = in.word();
        node.count = in.count();
        in.end_of_line();
        if ((kind != "n" && kind != "l") || node.count == 0 || node.count > parts_max) in.fail("not a node or a leaf");
        std::uint32_t& next = kind == "n" ? next_node : next_triangle;
        const std::size_t end = kind == "n" ? node_count : node_count + mesh.triangles.size();
        if (node.count > end - next) in.fail("more parts than there are");
        node.first = next;
        next += node.count;
        if (kind == "n") open.push_back(node);
        if (open.size() > depth_max + 1) in.fail("too deep");
    }
    if (next_node != node_count || next_triangle - node_count != mesh.triangles.size()) in.fail("the tree lacks parts");
}

// Lets the box of a node contain what lies in these bounds along axis k.
void include(Mesh& mesh, std::size_t node, std::size_t k, double low, double high) {
    mesh.boxes[0][k][node] = std::min(mesh.boxes[0][k][node], low);
    mesh.boxes[1][k][node] = std::max(mesh.boxes[1][k][node], high);
}

void read_lines(Text& in, std::string_view text, Mesh& mesh) {
    in.require_line();
    in.expect("ecods-mesh");
    in.expect("1");
    in.end_of_line();
    in.require_line();
    in.expect("vertices");
    mesh.vertices.resize(plausible(in, text, in.count(), sizeof "0x0p+0 0x0p+0 0x0p+0"));
    in.expect("triangles");
    mesh.triangles.resize(plausible(in, text, in.count(), sizeof "0 0 0 0"));
    mesh.position.resize(mesh.triangles.size());
    in.expect("nodes");
    mesh.nodes.resize(plausible(in, text, in.count(), sizeof "l 1"));
    in.end_of_line();
    if (mesh.triangles.empty() || mesh.nodes.empty()) in.fail("no triangles");
    for (auto& vertex : mesh.vertices) {
        in.require_line();
        for (double& x : vertex) x = in.number();
        in.end_of_line();
    }
    read_triangles(in, mesh);
    read_tree(in, mesh);
    if (in.next_line()) in.fail("more than a mesh");
}

}  // namespace

void measure(Mesh& mesh) {
    for (const auto& vertex : mesh.vertices) {
        mesh.low = std::min(mesh.low, unit_of(vertex));
        for (std::size_t k = 0; k < 3; ++k) {
            mesh.magnitude[k] = std::max(mesh.magnitude[k], std::abs(vertex[k]));
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        mesh.boxes[0][k].assign(mesh.nodes.size(), infinity);
        mesh.boxes[1][k].assign(mesh.nodes.size(), -infinity);
    }
    mesh.leaf_places.resize(mesh.triangles.size());
    for (std::size_t i = mesh.nodes.size(); i-- > 0;) {
        Node& node = mesh.nodes[i];
        node.number = static_cast<std::uint32_t>(i);
        node.first_corner = static_cast<std::uint32_t>(mesh.leaf_corners.size());
        for (std::uint32_t part = node.first; part < node.first + node.count; ++part) {
            if (mesh.is_triangle(part)) {
                for (const auto v : mesh.corners(part)) mesh.leaf_corners.push_back(v);
            } else {
                for (std::size_t k = 0; k < 3; ++k) {
                    include(mesh, i, k, mesh.boxes[0][k][part], mesh.boxes[1][k][part]);
                }
            }
        }
        const auto begin = mesh.leaf_corners.begin() + node.first_corner;
        std::sort(begin, mesh.leaf_corners.end());
        mesh.leaf_corners.erase(std::unique(begin, mesh.leaf_corners.end()), mesh.leaf_corners.end());
        node.corner_count = static_cast<std::uint32_t>(mesh.leaf_corners.size()) - node.first_corner;
        for (auto v = begin; v != mesh.leaf_corners.end(); ++v) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double x = mesh.vertices[*v][k];
                include(mesh, i, k, x, x);
                mesh.leaf_points[k].push_back(x);
            }
        }
        for (std::uint32_t part = node.first; mesh.is_triangle(part) && part < node.first + node.count; ++part) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto place = std::lower_bound(begin, mesh.leaf_corners.end(), mesh.corners(part)[k]) - begin;
                mesh.leaf_places[part - mesh.nodes.size()][k] = static_cast<std::uint8_t>(place);
            }
        }
    }
}

Mesh mesh_of(const std::array<std::array<mpz_class, 3>, 2>& vertices, int low) {
    Mesh mesh;
    for (const auto& vertex : vertices) {
        auto& nearby = mesh.vertices.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            long exponent = 0;
            const double leading = mpz_get_d_2exp(&exponent, vertex[k].get_mpz_t());
            nearby[k] = std::ldexp(leading, static_cast<int>(exponent) + low);
        }
    }
    mesh.triangles = {{0, 1, 1}};
    mesh.position = {0};
    measure(mesh);
    mesh.low = low;
    return mesh;
}

Mesh parse_mesh(std::string_view text) {
    Mesh mesh;
    try {
        Text in(text);
        read_lines(in, text, mesh);
    } catch (const Refusal& refusal) {
        throw Unreadable{"line " + std::to_string(refusal.line) + ": " + refusal.why};
    }
    mesh.digest = digest_of(text);
    measure(mesh);
    return mesh;
}

Mesh read_mesh(const char* path) {
    return parse_mesh(read_file(path, first_line));
}

}  // namespace certificate_checker
