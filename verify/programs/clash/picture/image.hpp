// A picture as numbers, and as the bytes of a file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "programs/clash/picture/composite.hpp"

namespace ecods::clash {

// Rows from the top, pixels from the left.
struct Image {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<Rgb> pixels;

    Rgb& at(std::size_t x, std::size_t y) { return pixels[y * width + x]; }
    const Rgb& at(std::size_t x, std::size_t y) const { return pixels[y * width + x]; }
};

// Whether this program was built with libpng.
bool can_write_png() noexcept;

// The bytes of a PNG file. Throws std::runtime_error if there is no libpng.
std::string to_png(const Image& image);

}  // namespace ecods::clash
