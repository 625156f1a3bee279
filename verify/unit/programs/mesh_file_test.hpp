// Tests that read mesh files.
#pragma once

#include <string>

#include "file_test.hpp"
#include "scenes/io/mesh_file.hpp"

namespace ecods::scenes {

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t position = text.find(from);
    EXPECT_NE(position, std::string::npos) << from;
    return text.replace(position, from.size(), to);
}

class MeshFileTest : public FileTest {
  protected:
    void expect_bad(const std::string& name, const std::string& bytes, const std::string& place,
                    const std::string& text) {
        const auto file = write(name, bytes);
        expect_error([&] { read_mesh_file(file); }, file, place, text);
    }
};

}  // namespace ecods::scenes
