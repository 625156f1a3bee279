// Exact signs from an integer kernel, for the decision in triangle_pair.hpp.
#pragma once

#include <array>

namespace ecods::exact {

template <class Kernel>
class KernelSigns {
  public:
    explicit KernelSigns(const Kernel& kernel) noexcept : kernel_(kernel) {}

    std::array<int, 3> sides(int triangle) const noexcept {
        const int own = 3 * triangle;
        const int other = 3 - own;
        const auto normal = kernel_.normal(own, own + 1, own + 2);
        return {kernel_.side(normal, own, other), kernel_.side(normal, own, other + 1),
                kernel_.side(normal, own, other + 2)};
    }

    int orient3d(int a, int b, int c, int d) const noexcept { return kernel_.side(kernel_.normal(a, b, c), a, d); }
    int orient2d(int a, int b, int c, int axis) const noexcept { return kernel_.orient2d(a, b, c, axis); }
    int compare(int a, int b, int axis) const noexcept { return kernel_.compare(a, b, axis); }

    int normal_axis(int triangle) const noexcept {
        const int own = 3 * triangle;
        const auto normal = kernel_.normal(own, own + 1, own + 2);
        for (int axis = 0; axis < 3; ++axis) {
            if (!Kernel::is_zero(normal.n[static_cast<std::size_t>(axis)])) return axis;
        }
        return -1;
    }

  private:
    const Kernel& kernel_;
};

}  // namespace ecods::exact
