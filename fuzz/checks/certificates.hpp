// Certificates of a sample of a world's answers, and the program that checks them, which shares nothing with the
// library.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ecods/certificate.hpp"
#include "ecods/world.hpp"
#include "fuzz/base/counters.hpp"
#include "fuzz/checks/truth.hpp"

namespace ecods::fuzz {

struct CertificateOptions {
    std::filesystem::path checker = {};  // ecods_check_certificate; none: only claims are compared
    std::filesystem::path folder = {};   // where certificates and meshes are kept if one is refused
};

class Certificates {
  public:
    // `spoils`: one proof loses a line, a lie that the checker must find.
    explicit Certificates(CertificateOptions options, bool spoils = false)
        : options_(std::move(options)), spoils_(spoils) {}

    // Certifies an answer about two bodies, of which one has changed if any has, and now and then the lists of an
    // updated world that is small and has meshes only. `frame` chooses the bodies and the question. Throws CheckFailed
    // where the claim is not the plain answer; it may be called in any floating-point environment.
    void ask(const World& world, const Truth& truth, std::uint32_t frame, Counters& counters);

    // Has the program check all that were made. Throws CheckFailed, which names the bodies, where one is refused, or
    // accepted as a claim of something else.
    void check(Counters& counters) const;

  private:
    struct Made {
        std::string about;            // which bodies, when
        std::string words;            // of the claim, as the checker's line begins
        std::optional<double> value;  // that comes behind them
        std::string text;
    };
    struct Pair;

    void ask_pair(const Pair& pair, std::uint32_t frame, Counters& counters);
    void ask_world(const World& world, std::uint32_t frame, Counters& counters);
    void take(const Certificate& certificate, Made plain, Counters& counters);
    void judge(const std::string& lines) const;

    CertificateOptions options_;
    bool spoils_;
    QueryMemory memory_;
    std::vector<Made> made_;
    std::vector<std::shared_ptr<const Shape>> shapes_;
};

}  // namespace ecods::fuzz
