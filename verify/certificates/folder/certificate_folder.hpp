// A file of certificates, and beside it a file DIGEST.mesh for each mesh that they are about. What is in its folder is
// checked by `ecods_check_certificate FOLDER/FILE FOLDER/*.mesh`.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "ecods/certificate.hpp"
#include "ecods/shape.hpp"

namespace ecods::certificates {

class CertificateFolder {
  public:
    // Makes the file of certificates, or overwrites it, and the folder it is in if there is none. `place` is the file;
    // where it is a folder that exists, or ends with a separator, the file is certificates.txt in it. Throws
    // std::system_error here and below where a file cannot be written.
    explicit CertificateFolder(const std::filesystem::path& place);

    // Writes the mesh of a shape, unless it is there.
    void add_mesh(const MeshShape& shape);

    void add(const Certificate& certificate);

    // The text of one.
    void add(const std::string& certificate);

    // Of a world, with the meshes.
    void add(const WorldCertificate& certificate);

    std::size_t certificate_count() const noexcept { return certificate_count_; }
    std::size_t mesh_count() const noexcept { return digests_.size(); }

  private:
    void check(const std::ofstream& out, const std::filesystem::path& file) const;

    std::filesystem::path file_;
    std::ofstream certificates_;
    std::set<std::string> digests_;
    std::size_t certificate_count_ = 0;
};

}  // namespace ecods::certificates
