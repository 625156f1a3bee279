// A folder of certificates, and of the meshes that they are about: `certificates.txt`, and a file DIGEST.mesh for each
// mesh. What is in it is checked by `ecods_check_certificate FOLDER/certificates.txt FOLDER/*.mesh`.
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
    // Makes the folder, if there is none, and the file of certificates, which is overwritten. Throws std::system_error
    // here and below where a file cannot be written.
    explicit CertificateFolder(std::filesystem::path folder);

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

    std::filesystem::path folder_;
    std::ofstream certificates_;
    std::set<std::string> digests_;
    std::size_t certificate_count_ = 0;
};

}  // namespace ecods::certificates
