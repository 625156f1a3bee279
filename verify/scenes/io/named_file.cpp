#include "scenes/io/named_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "scenes/io/json_place.hpp"

namespace ecods::scenes {

bool is_within(const std::filesystem::path& folder, const std::filesystem::path& file) {
    std::error_code folder_error, file_error;
    // The folder of "a.gltf" is "", which is no path to the system.
    const auto outer = std::filesystem::weakly_canonical(folder.empty() ? "." : folder, folder_error);
    const auto inner = std::filesystem::weakly_canonical(file, file_error);
    return !folder_error && !file_error &&
           std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

std::filesystem::path named_file(const JsonPlace& place, const std::string& name, NamedFiles allowed) {
    const std::filesystem::path folder = place.file().parent_path();
    std::filesystem::path file = folder / name;
    // A zero byte would end the path here; read_bytes() opens no such file.
    const bool has_zero = name.find('\0') != std::string::npos;
    if (allowed == NamedFiles::in_folder && !has_zero && !is_within(folder, file)) {
        place.fail(fmt::format("names {}, which is outside of the folder of {}; --untrusted", name,
                               place.file().filename().string()));
    }
    return file;
}

}  // namespace ecods::scenes
