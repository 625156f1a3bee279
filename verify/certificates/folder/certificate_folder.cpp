#include "certificates/folder/certificate_folder.hpp"

#include <cerrno>
#include <system_error>

namespace ecods::certificates {

CertificateFolder::CertificateFolder(const std::filesystem::path& place) : file_(place) {
    if (std::filesystem::is_directory(place) || !place.has_filename()) file_ /= "certificates.txt";
    if (file_.has_parent_path()) std::filesystem::create_directories(file_.parent_path());
    certificates_.open(file_, std::ios::binary);
    check(certificates_, file_);
}

void CertificateFolder::add_mesh(const MeshShape& shape) {
    const std::string digest = certified_mesh_digest(shape);
    if (!digests_.insert(digest).second) return;
    const auto file = file_.parent_path() / (digest + ".mesh");
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
    check(certificates_, file_);
    ++certificate_count_;
}

void CertificateFolder::check(const std::ofstream& out, const std::filesystem::path& file) const {
    if (!out) throw std::system_error(errno, std::generic_category(), file.string() + ": cannot be written");
}

}  // namespace ecods::certificates
