// Computes the boxes of many bodies at new poses, eight at a time if bodies share a mesh.
//
// The calling thread does all the work. The executor was tried: for 4,096 to 65,536 bodies, two threads took 2 to 16 ns
// a body longer than one thread, because eight boxes are computed sooner than their poses reach another core.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ecods/primitives.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Collects poses in batches, a batch for each of the last few shapes, and computes the boxes of a batch as soon as it
// has eight poses. Shapes may be added in any order.
class MovedBoxes {
  public:
    // Stores the results in `boxes`, which must stay valid until finish() returns.
    explicit MovedBoxes(std::vector<Aabb>& boxes) noexcept : boxes_(boxes) {}
    MovedBoxes(const MovedBoxes&) = delete;
    MovedBoxes& operator=(const MovedBoxes&) = delete;

    // Adds a pose of the shape. Returns true if boxes[index] will be set to the shape's box, at the latest by finish();
    // `pose` must outlive this object. Returns false if the caller must call shape.box() itself: the shape is of a
    // caller's class, whose answer must be checked and which may throw.
    bool add(const Shape& shape, const Pose& pose, std::size_t index);

    // Computes the boxes of all batches that have fewer than eight poses.
    void finish();

  private:
    static constexpr std::size_t batch_size = 8;
    struct Batch {
        const Shape* shape = nullptr;
        const MeshShape* mesh = nullptr;  // null if add() must return false for `shape`
        std::size_t count = 0;            // poses whose boxes are not computed yet
        std::array<const Pose*, batch_size> poses;
        std::array<std::size_t, batch_size> indices;
    };
    void find(Batch& batch);

    std::vector<Aabb>& boxes_;
    std::array<Batch, 8> batches_;
};

}  // namespace ecods
