// The boxes of many bodies at new poses: those of bodies that share a mesh are found some at a time.
//
// By the thread that calls. Handing them to an executor was measured, too: at 4,096 to 65,536 bodies two threads took
// 2 to 16 ns a body longer than one, for eight boxes are found before their poses have come to another core.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ecods/aabb.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Adding is in any order of shapes: some shapes wait side by side, each until eight of its poses are there.
class MovedBoxes {
  public:
    // Boxes are written to `boxes`, which must keep its place until all are found.
    explicit MovedBoxes(std::vector<Aabb>& boxes) noexcept : boxes_(boxes) {}
    MovedBoxes(const MovedBoxes&) = delete;
    MovedBoxes& operator=(const MovedBoxes&) = delete;

    // Takes it on that boxes[index] becomes the box of the shape, and returns true; or returns false where box() has to
    // be asked: what a caller's class answers is checked, and may throw. `pose` must outlive this.
    bool add(const Shape& shape, const Pose& pose, std::size_t index);

    // Finds the boxes that are still missing.
    void finish();

  private:
    static constexpr std::size_t batch_size = 8;
    struct Batch {
        const Shape* shape = nullptr;
        const MeshShape* mesh = nullptr;  // null: its box() is asked
        std::size_t count = 0;            // that wait
        std::array<const Pose*, batch_size> poses;
        std::array<std::size_t, batch_size> indices;
    };
    void find(Batch& batch);

    std::vector<Aabb>& boxes_;
    std::array<Batch, 8> batches_;
};

}  // namespace ecods
