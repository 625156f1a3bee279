#include <fmt/format.h>

#include <array>
#include <limits>
#include <map>
#include <utility>

#include "scenes/io/gltf_mesh.hpp"
#include "scenes/io/used_vertices.hpp"

namespace ecods::scenes {
namespace {

constexpr std::uint32_t mode_line_strip = 3;  // points and lines before it
constexpr std::uint32_t mode_triangles = 4;
constexpr std::uint32_t mode_strip = 5;
constexpr std::uint32_t mode_fan = 6;

std::uint32_t mode_of(const JsonPlace& primitive) {
    const auto place = primitive.find("mode");
    const std::uint32_t mode = place ? place->index() : mode_triangles;
    if (mode > mode_fan) place->fail(fmt::format("there is no mode {}", mode));
    return mode;
}

GltfElements read_positions(GltfModel& model, const JsonPlace& index) {
    static constexpr std::array types{GltfType::float_, GltfType::byte, GltfType::ubyte, GltfType::short_,
                                      GltfType::ushort};
    return read_accessor(model, index, "VEC3", std::span(types).first(model.is_quantized ? types.size() : 1));
}

// The indices of a primitive, or 0, 1, 2, ... if it has none; each below vertex_count.
std::vector<std::uint32_t> read_corners(GltfModel& model, const JsonPlace& primitive, std::size_t vertex_count) {
    std::vector<std::uint32_t> corners;
    const auto index = primitive.find("indices");
    if (!index) {
        if (vertex_count > std::numeric_limits<std::uint32_t>::max()) primitive.fail("too many vertices");
        model.spend(primitive, vertex_count);
        for (std::size_t i = 0; i < vertex_count; ++i) corners.push_back(static_cast<std::uint32_t>(i));
        return corners;
    }
    const GltfElements elements =
        read_accessor(model, *index, "SCALAR", std::array{GltfType::ubyte, GltfType::ushort, GltfType::uint});
    model.spend(*index, elements.count);
    for (std::size_t i = 0; i < elements.count; ++i) {
        corners.push_back(elements.whole(i));
        if (corners.back() >= vertex_count) {
            index->fail(fmt::format("index {} is out of range: there are {} vertices", corners.back(), vertex_count));
        }
    }
    return corners;
}

MeshSoup cut(const JsonPlace& primitive, std::span<const std::uint32_t> corners) {
    MeshSoup soup;
    const std::uint32_t mode = mode_of(primitive);
    if (mode == mode_triangles && corners.size() % 3 != 0)
        primitive.fail("the number of corners is no multiple of three");
    if (mode == mode_fan) {
        soup.add_fan(corners);
    } else {
        const std::size_t step = mode == mode_strip ? 1 : 3;
        for (std::size_t i = 0; i + 3 <= corners.size(); i += step) soup.add_fan(corners.subspan(i, 3));
    }
    return soup;
}

// Triangles between the elements of one accessor of positions.
struct VertexBlock {
    JsonPlace attributes;
    GltfElements positions;
    std::vector<std::uint32_t> corners = {};  // of all triangles
};

class Primitives {
  public:
    Primitives(GltfModel& model, const std::vector<Pose>* joints) : model_(model), joints_(joints) {}

    void add(const JsonPlace& primitive) {
        const std::size_t block = block_of(primitive.at("attributes"));
        const std::vector<std::uint32_t> corners = read_corners(model_, primitive, blocks_[block].positions.count);
        MeshSoup part = cut(primitive, corners);
        for (const Triangle& triangle : part.triangles)
            blocks_[block].corners.insert(blocks_[block].corners.end(), triangle.begin(), triangle.end());
        parts_.emplace_back(block, std::move(part.triangles));
    }

    MeshSoup take() {
        MeshSoup soup;
        std::vector<UsedVertices> used;
        std::vector<std::size_t> first_vertex;
        for (VertexBlock& block : blocks_) {
            first_vertex.push_back(soup.vertices.size());
            add_vertices(block, used.emplace_back(std::move(block.corners)).old_numbers(), soup.vertices);
        }
        for (const auto& [block, part] : parts_) {
            for (Triangle triangle : part) {
                for (std::uint32_t& corner : triangle)
                    corner = static_cast<std::uint32_t>(first_vertex[block] + used[block].new_number(corner));
                soup.triangles.push_back(triangle);
            }
        }
        return soup;
    }

  private:
    // With a skin, each primitive has weights of its own.
    std::size_t block_of(const JsonPlace& attributes) {
        const JsonPlace position = attributes.at("POSITION");
        const auto next = blocks_.size();
        if (joints_ == nullptr) {
            const auto [entry, is_new] = block_of_accessor_.try_emplace(position.index(), next);
            if (!is_new) return entry->second;
        }
        blocks_.push_back({attributes, read_positions(model_, position)});
        return next;
    }

    void add_vertices(const VertexBlock& block, const std::vector<std::uint32_t>& numbers,
                      std::vector<Vec3>& vertices) {
        std::optional<GltfSkinning> skinning;
        if (joints_ != nullptr) {
            skinning.emplace(model_, block.attributes, *joints_);
            model_.spend(block.attributes, numbers.size() * skinning->set_count());
        }
        if (numbers.size() > std::numeric_limits<std::uint32_t>::max() - vertices.size())
            block.attributes.fail("too many vertices");
        for (const std::uint32_t i : numbers) {
            Vec3 point(block.positions.number(i, 0), block.positions.number(i, 1), block.positions.number(i, 2));
            if (skinning) point = (*skinning)(i, point);
            if (!point.allFinite())
                block.attributes.at("POSITION").fail(fmt::format("vertex {}: a coordinate is not a finite number", i));
            vertices.push_back(point);
        }
    }

    GltfModel& model_;
    const std::vector<Pose>* joints_;  // null: there is no skin
    std::vector<VertexBlock> blocks_;
    std::map<std::uint32_t, std::size_t> block_of_accessor_;
    std::vector<std::pair<std::size_t, std::vector<Triangle>>> parts_;  // of each primitive: its block, its triangles
};

}  // namespace

bool is_points_or_lines(const JsonPlace& primitive) {
    return mode_of(primitive) <= mode_line_strip;
}

MeshSoup read_primitives(GltfModel& model, const JsonPlace& mesh, const std::vector<Pose>* joints) {
    Primitives primitives(model, joints);
    for (const JsonPlace& primitive : mesh.at("primitives").elements()) {
        if (!is_points_or_lines(primitive)) primitives.add(primitive);
    }
    return primitives.take();
}

GltfGeometry geometry_of(const JsonPlace& mesh) {
    GltfGeometry geometry;
    for (const JsonPlace& primitive : mesh.at("primitives").elements()) {
        if (is_points_or_lines(primitive)) continue;
        const auto indices = primitive.find("indices");
        geometry.insert(geometry.end(), {mode_of(primitive), primitive.at("attributes").at("POSITION").index(),
                                         indices ? 1U : 0U, indices ? indices->index() : 0U});
    }
    return geometry;
}

}  // namespace ecods::scenes
