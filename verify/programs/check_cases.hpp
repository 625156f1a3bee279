// Known configurations with their exact answers (verify/scenes/io/hard_case_file.hpp), asked in every way.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "certificates/folder/certificate_folder.hpp"

namespace ecods::check {

struct CaseAnswer {
    std::string id;
    bool intersects = false;
    std::size_t triangle_pair_count = 0;
    bool is_ok = false;  // as expected in both orders of arguments, each way of asking, and the oracle if asked
};

struct CasesReport {
    std::vector<CaseAnswer> cases;
    std::size_t skipped = 0;
};

// Each case is also certified, if there is a folder for that. Throws scenes::ReadError.
CasesReport run_cases(const std::filesystem::path& file, bool with_oracle,
                      certificates::CertificateFolder* folder = nullptr);

}  // namespace ecods::check
