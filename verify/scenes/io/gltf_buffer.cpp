#include <fmt/format.h>

#include <cctype>

#include "scenes/io/gltf_model.hpp"
#include "scenes/io/read_bytes.hpp"

namespace ecods::scenes {
namespace {

int value_of(char c, std::string_view digits) {
    const std::size_t value = digits.find(c);
    return value == std::string_view::npos ? -1 : static_cast<int>(value);
}

// Padding may be left out; anything but the 64 characters is an error.
std::string decode_base64(const JsonPlace& uri, std::string_view text) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
    if (text.size() % 4 == 1) uri.fail("the base64 text is cut off");
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const int value = value_of(text[i], digits);
        if (value < 0) uri.fail(fmt::format("character {} of the base64 text is none of base64", i));
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        if (i % 4 != 0) bytes += static_cast<char>(bits >> (6 - 2 * (i % 4)));
    }
    return bytes;
}

std::string decode_percents(const JsonPlace& uri, std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto digit = [&](std::size_t i) {
        return i < text.size() ? value_of(static_cast<char>(std::tolower(static_cast<unsigned char>(text[i]))), digits)
                               : -1;
    };
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded += text[i];
            continue;
        }
        if (digit(i + 1) < 0 || digit(i + 2) < 0) uri.fail("a % is not followed by two hexadecimal digits");
        decoded += static_cast<char>(digit(i + 1) * 16 + digit(i + 2));
        i += 2;
    }
    return decoded;
}

// What comes before the first colon, if that makes it a URI of its own and not a path.
std::string_view scheme_of(std::string_view uri) {
    const std::size_t end = uri.find_first_of(":/?#");
    return end == std::string_view::npos || uri[end] != ':' ? std::string_view() : uri.substr(0, end);
}

// Two files are named: that which cannot be read, and that which names it.
std::string read_buffer_file(const JsonPlace& uri, const std::filesystem::path& file) {
    try {
        return read_bytes(file);
    } catch (const ReadError& error) {
        uri.fail(error.what());
    }
}

}  // namespace

std::shared_ptr<const std::string> GltfBuffers::read_uri(const JsonPlace& place) {
    const std::string uri = place.text();
    const std::string_view scheme = scheme_of(uri);
    if (scheme.empty()) {
        const std::filesystem::path file = named_file(place, decode_percents(place, uri), allowed_);
        auto& bytes = files_[file.lexically_normal()];
        if (!bytes) {
            bytes = std::make_shared<const std::string>(read_buffer_file(place, file));
            file_bytes_ += bytes->size();
        }
        return bytes;
    }
    constexpr std::string_view marker = ";base64,";
    const std::size_t comma = std::min(uri.find(','), uri.size());
    if (scheme != "data" || !std::string_view(uri).substr(0, comma + 1).ends_with(marker))
        place.fail("neither the path of a file nor data in base64");
    return std::make_shared<const std::string>(decode_base64(place, std::string_view(uri).substr(comma + 1)));
}

std::shared_ptr<const std::string> GltfBuffers::read(const JsonPlace& buffer, std::string_view embedded) {
    const std::uint64_t size = buffer.at("byteLength").count();
    const auto uri = buffer.find("uri");
    auto bytes = uri ? read_uri(*uri) : nullptr;
    const std::size_t byte_count = uri ? bytes->size() : embedded.size();
    // A chunk is padded to a multiple of four bytes.
    const std::uint64_t padding_max = uri ? 0 : 3;
    if (byte_count < size || byte_count - size > padding_max)
        buffer.fail(fmt::format("there are {} bytes, and byteLength is {}", byte_count, size));
    return uri ? bytes : std::make_shared<const std::string>(embedded.substr(0, size));
}

}  // namespace ecods::scenes
