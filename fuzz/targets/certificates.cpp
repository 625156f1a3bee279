// The C++ checker of certificates: whatever the bytes are, a mesh or a certificate is read, accepted or refused by an
// error of the promised type; the float filter changes no verdict.
//
// The first byte says which of the two the rest is. Certificates are about two small meshes, named by their digests.
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "certificates/checker/claims.hpp"
#include "certificates/checker/mesh.hpp"
#include "fuzz/targets/require.hpp"

namespace {

using namespace certificate_checker;

constexpr std::uint64_t units = std::uint64_t{1} << 22;

const std::map<std::string, Mesh, std::less<>>& meshes() {
    static const auto known = [] {
        const char* const texts[] = {
            "ecods-mesh 1\nvertices 3 triangles 1 nodes 1\n0x0p+0 0x0p+0 0x0p+0\n0x1p+0 0x0p+0 0x0p+0\n"
            "0x0p+0 0x1p+0 0x0p+0\n0 1 2 0\nl 1\n",
            "ecods-mesh 1\nvertices 4 triangles 2 nodes 3\n0x0p+0 0x0p+0 0x0p+0\n0x1p+0 0x0p+0 0x0p+0\n"
            "0x1p+0 0x1p+0 0x0p+0\n0x0p+0 0x1p+0 0x0p+0\n0 2 3 1\n0 1 2 0\nn 2\nl 1\nl 1\n"};
        std::map<std::string, Mesh, std::less<>> result;
        for (const char* text : texts) {
            Mesh mesh = parse_mesh(text);
            result.emplace(mesh.digest, std::move(mesh));
        }
        return result;
    }();
    return known;
}

void find_mesh(PosedMesh& wanted) {
    const auto found = meshes().find(wanted.digest);
    if (found == meshes().end()) throw Refusal{wanted.line, "no mesh has this digest"};
    wanted.mesh = &found->second;
}

void check(Text& in, Budget& budget) {
    in.require_line();
    if (in.line() == world_first_line) {
        WorldHead head = read_world_head(in);
        for (WorldBody& body : head.bodies) find_mesh(body.mesh);
        check_world(in, head, budget);
        return;
    }
    if (in.line() != pair_first_line) in.fail("not the first line of a certificate");
    PairHead head = read_pair_head(in);
    Proof proof;
    read_proof(in, proof);
    find_mesh(head.a);
    if (!head.b) return check_segment(head.a, head.segment, proof, budget);
    find_mesh(*head.b);
    check_pair(head.a, *head.b, proof, budget);
}

// Nothing where the work has no end in sight.
std::optional<bool> is_accepted(std::string_view text, bool has_filter) {
    Budget budget{units, has_filter};
    Text in(text);
    try {
        check(in, budget);
        return true;
    } catch (const Refusal&) {
        return false;
    } catch (const TooCostly&) {
        return std::nullopt;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    if (data[0] % 4 == 0) {
        try {
            const Mesh mesh = parse_mesh(text);
            ecods::fuzz::require(mesh.triangles.size() == mesh.position.size(), "triangles are numbered");
            for (const auto& corner : mesh.boxes) {
                for (const auto& coordinates : corner)
                    ecods::fuzz::require(coordinates.size() == mesh.nodes.size(), "each node has its box");
            }
        } catch (const Unreadable& unreadable) {
            ecods::fuzz::require(!unreadable.why.empty(), "an error says what is wrong");
        }
        return 0;
    }
    const auto fast = is_accepted(text, true), slow = is_accepted(text, false);
    ecods::fuzz::require(!fast || !slow || *fast == *slow, "the filter changes no verdict");
    return 0;
}
