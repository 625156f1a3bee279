#include <stdexcept>

#include "programs/clash/picture/image.hpp"

#ifdef ECODS_CLASH_PNG
#include <png.h>
#endif

namespace ecods::clash {

#ifdef ECODS_CLASH_PNG

namespace {

// libpng may leave the functions by a jump: so nothing here has a destructor that it would skip.
bool write_rows(png_structp png, png_infop info, const Image& image) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB | PNG_FILTER_UP);
    png_set_compression_level(png, 5);
    png_write_info(png, info);
    for (std::size_t y = 0; y < image.height; ++y)
        png_write_row(png, reinterpret_cast<png_const_bytep>(image.pixels.data() + y * image.width));
    png_write_end(png, nullptr);
    return true;
}

void append(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

}  // namespace

bool can_write_png() noexcept {
    return true;
}

std::string to_png(const Image& image) {
    std::string bytes;
    // Enough for what cannot be compressed: an allocation that fails must not throw through libpng.
    bytes.reserve(image.pixels.size() * 4 + image.height * 16 + 65536);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
    if (info != nullptr) png_set_write_fn(png, &bytes, append, nullptr);
    const bool is_written = info != nullptr && write_rows(png, info, image);
    png_destroy_write_struct(&png, &info);
    if (!is_written) throw std::runtime_error("libpng cannot write a picture");
    return bytes;
}

#else

bool can_write_png() noexcept {
    return false;
}

std::string to_png(const Image&) {
    throw std::runtime_error("this ecods_clash was built without libpng, which pictures need");
}

#endif

}  // namespace ecods::clash
