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

    // The triangle 0 0 0, 1 0 0, 0 1 0.
    const std::string obj_ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string off_ = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    const std::string stl_ =
        "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
        "endsolid s\n";
};

}  // namespace ecods::scenes
