// Runs from consecutive seeds until enough is done or a check fails.
#pragma once

#include <chrono>
#include <cstdint>

namespace ecods::fuzz {

struct CampaignOptions {
    std::uint32_t seed = 1;
    std::uint32_t runs = 100;
    double seconds = 0;   // if positive, in place of `runs`
    bool canary = false;  // lie about one answer
};

class Campaign {
  public:
    explicit Campaign(const CampaignOptions& options) : options_(options) {}

    bool goes_on() const { return options_.seconds > 0 ? seconds() < options_.seconds : runs_ < options_.runs; }
    std::uint32_t next_seed() { return options_.seed + runs_++; }
    std::uint32_t runs() const { return runs_; }
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  private:
    using Clock = std::chrono::steady_clock;
    CampaignOptions options_;
    std::uint32_t runs_ = 0;
    Clock::time_point start_ = Clock::now();
};

// Each prints a summary in JSON and gives the exit status: 1 if a check failed.
int fuzz_motion(const CampaignOptions& options);
int fuzz_pairs(const CampaignOptions& options);

}  // namespace ecods::fuzz
