#include "scenes/io/read_bytes.hpp"

#include <fstream>

namespace ecods::scenes {

void require_regular_file(const std::filesystem::path& file) {
    // The system would read a path up to its first zero byte: another file.
    if (file.native().find('\0') != std::string::npos) throw ReadError(file, "", "no such file");
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::none) throw ReadError(file, "", "cannot be read");
    if (!std::filesystem::exists(status)) throw ReadError(file, "", "no such file");
    if (std::filesystem::is_directory(status)) throw ReadError(file, "", "is a folder");
    // Opening a pipe would wait for somebody to write to it.
    if (!std::filesystem::is_regular_file(status)) throw ReadError(file, "", "not a regular file");
}

std::string read_bytes(const std::filesystem::path& file) {
    require_regular_file(file);
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    const std::streamoff size = stream ? std::streamoff(stream.tellg()) : -1;
    if (size < 0) throw ReadError(file, "", "cannot be read");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    stream.seekg(0);
    stream.read(bytes.data(), size);
    if (stream.gcount() != size) throw ReadError(file, "", "cannot be read");
    return bytes;
}

}  // namespace ecods::scenes
