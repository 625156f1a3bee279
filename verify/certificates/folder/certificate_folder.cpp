#include "certificates/folder/certificate_folder.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

namespace ecods::certificates {

CertificateFolder::CertificateFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::filesystem::create_directories(folder_);
    const auto file = folder_ / "certificates.txt";
    certificates_.open(file, std::ios::binary);
    check(certificates_, file);
}

void CertificateFolder::add_mesh(const MeshShape& shape) {
    const std::string digest = certified_mesh_digest(shape);
    if (!digests_.insert(digest).second) return;
    const auto file = folder_ / (digest + ".mesh");
    std::ofstream out(file, std::ios::binary);
    write_certified_mesh(out, shape);
    out.flush();
    check(out, file);
}

void CertificateFolder::add(const Certificate& certificate) {
    add(certificate.to_string());
}

void CertificateFolder::add(const WorldCertificate& certificate) {
    for (const auto& shape : certificate.shapes()) add_mesh(*shape);
    add(certificate.to_string());
}

void CertificateFolder::add(const std::string& certificate) {
    certificates_ << certificate;
    certificates_.flush();
    check(certificates_, folder_ / "certificates.txt");
    ++certificate_count_;
}

void CertificateFolder::check(const std::ofstream& out, const std::filesystem::path& file) const {
    if (!out) throw std::system_error(errno, std::generic_category(), file.string() + ": cannot be written");
}

}  // namespace ecods::certificates
