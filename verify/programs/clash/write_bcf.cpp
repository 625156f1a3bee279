// The report as BCF 2.1. The zip file's entries have no time of their own: the first that the format can say.
#include <zip.h>

#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "programs/clash/bcf_documents.hpp"
#include "programs/clash/write.hpp"

namespace ecods::clash {
namespace {

struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
    void operator()(zip_source_t* source) const { zip_source_free(source); }
};

// An archive in memory. What is added must stay where it is until bytes() is called.
class Archive {
  public:
    Archive() {
        zip_error_t error;
        zip_error_init(&error);
        bytes_.reset(zip_source_buffer_create(nullptr, 0, 0, &error));
        if (!bytes_) fail(zip_error_strerror(&error));
        zip_source_keep(bytes_.get());  // the archive frees one of the two
        archive_.reset(zip_open_from_source(bytes_.get(), ZIP_TRUNCATE, &error));
        if (!archive_) {
            zip_source_free(bytes_.get());
            fail(zip_error_strerror(&error));
        }
    }

    void add(const std::string& name, const std::string& content, bool is_compressible) {
        zip_t* archive = archive_.get();
        zip_source_t* source = zip_source_buffer(archive, content.data(), content.size(), 0);
        if (source == nullptr) fail(zip_strerror(archive));
        const zip_int64_t at = zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
        if (at < 0) {
            zip_source_free(source);
            fail(zip_strerror(archive));
        }
        const auto index = static_cast<zip_uint64_t>(at);
        constexpr zip_uint16_t first_day = 1 << 5 | 1;  // of January 1980
        const zip_int32_t method = is_compressible ? ZIP_CM_DEFLATE : ZIP_CM_STORE;
        if (zip_set_file_compression(archive, index, method, is_compressible ? 1 : 0) != 0 ||
            zip_file_set_dostime(archive, index, 0, first_day, 0) != 0) {
            fail(zip_strerror(archive));
        }
    }

    std::string bytes() {
        if (zip_close(archive_.get()) != 0) fail(zip_strerror(archive_.get()));
        static_cast<void>(archive_.release());  // gone with the call
        zip_source_t* source = bytes_.get();
        zip_stat_t status;
        if (zip_source_stat(source, &status) != 0 || zip_source_open(source) != 0)
            fail(zip_error_strerror(zip_source_error(source)));
        std::string result(status.size, '\0');
        const zip_int64_t count = zip_source_read(source, result.data(), result.size());
        zip_source_close(source);
        if (count < 0 || static_cast<zip_uint64_t>(count) != status.size) fail("cannot be read back");
        return result;
    }

  private:
    [[noreturn]] static void fail(const std::string& why) { throw std::runtime_error("BCF: " + why); }

    std::unique_ptr<zip_source_t, Discard> bytes_;
    std::unique_ptr<zip_t, Discard> archive_;
};

}  // namespace

bool can_write_bcf() noexcept {
    return true;
}

void write_bcf(std::ostream& out, const ClashReport& report, std::span<const Picture> pictures,
               const std::string& date) {
    std::vector<std::string> texts;  // which the archive refers to
    texts.reserve(2 * report.clashes.size() + 1);
    Archive archive;
    archive.add("bcf.version", texts.emplace_back(bcf_version()), true);
    for (std::size_t i = 0; i < report.clashes.size(); ++i) {
        const std::string folder = topic_guid(report, report.clashes[i]) + "/";
        const bool has_picture = i < pictures.size();
        const Camera camera = has_picture ? pictures[i].camera : camera_without_picture(report, report.clashes[i]);
        archive.add(folder + "markup.bcf", texts.emplace_back(bcf_markup(report, i, has_picture, date)), true);
        archive.add(folder + "viewpoint.bcfv", texts.emplace_back(bcf_viewpoint(report, i, camera)), true);
        if (has_picture) archive.add(folder + "snapshot.png", pictures[i].png, false);
    }
    const std::string bytes = archive.bytes();
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace ecods::clash
