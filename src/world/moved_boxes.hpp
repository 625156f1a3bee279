// Finds the boxes of many bodies at new poses, eight at a time for bodies that share a mesh.
//
// The calling thread does all the work. An executor was tried: at 4,096 to 65,536 bodies, two threads took 2 to 16 ns a
// body longer than one, because eight boxes are found before their poses reach another core.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ecods/primitives.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Collects poses in batches, one batch for each of some shapes, and finds the boxes of a batch when it has eight poses.
// Shapes may be added in any order.
class MovedBoxes {
  public:
    // Writes the boxes to `boxes`, which must stay in place until all are found.
    explicit MovedBoxes(std::vector<Aabb>& boxes) noexcept : boxes_(boxes) {}
    MovedBoxes(const MovedBoxes&) = delete;
    MovedBoxes& operator=(const MovedBoxes&) = delete;

    // Returns true if boxes[index] will become the box of the shape; it has its value after finish(). Returns false if
    // the caller must ask box() itself: the answer of a caller's class must be checked, and may be an exception. `pose`
    // must outlive this object.
    bool add(const Shape& shape, const Pose& pose, std::size_t index);

    // Finds the boxes that are still missing.
    void finish();

  private:
    static constexpr std::size_t batch_size = 8;
    struct Batch {
        const Shape* shape = nullptr;
        const MeshShape* mesh = nullptr;  // null: add() returns false
        std::size_t count = 0;            // waiting poses
        std::array<const Pose*, batch_size> poses;
        std::array<std::size_t, batch_size> indices;
    };
    void find(Batch& batch);

    std::vector<Aabb>& boxes_;
    std::array<Batch, 8> batches_;
};

}  // namespace ecods
