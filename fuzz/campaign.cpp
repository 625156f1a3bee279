#include "fuzz/campaign.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <list>
#include <nlohmann/json.hpp>

#include "process/contained.hpp"
#include "process/progress.hpp"

namespace ecods::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

struct Job {
    std::string profile;
    std::uint32_t seed;
    process::Contained child;
};

class Campaign {
  public:
    explicit Campaign(const CampaignOptions& options) : options_(options), profiles_(profiles_of(options.profile)) {}
    CampaignReport run();

  private:
    bool goes_on() const {
        if (report_.failures.size() >= options_.failures_max) return false;
        return options_.seconds > 0 ? seconds() < options_.seconds : begun_ < options_.runs;
    }
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    void begin_job();
    void take_in(Job& job);
    void wait() const;

    CampaignOptions options_;
    std::vector<std::string> profiles_;
    CampaignReport report_;
    std::list<Job> jobs_;
    std::uint32_t begun_ = 0;
    Clock::time_point start_ = Clock::now();
};

void Campaign::begin_job() {
    const std::uint32_t seed = options_.seed + begun_++;
    const std::string& profile = profiles_[seed % profiles_.size()];
    const PlayOptions play = options_.play;
    jobs_.push_back(
        {profile, seed, contained([=] { return text_of(fuzz::run(profile, seed, play)); }, options_.seconds_max)});
    jobs_.back().child.begin();
}

void Campaign::take_in(Job& job) {
    const process::Outcome outcome = job.child.end();
    ++report_.runs;
    ++report_.runs_of[job.profile];
    RunReport report;
    if (outcome.is_right()) {
        report = report_of(outcome.text);
    } else {
        report.failure = {.profile = job.profile,
                          .seed = job.seed,
                          .where = "somewhere",
                          .check = check_of(outcome),
                          .expected = "an end",
                          .got = outcome.failure};
    }
    for (const auto& [name, count] : report.counters) report_.counters[name] += count;
    if (report.failure) report_.failures.push_back(*report.failure);
}

void Campaign::wait() const {
    std::vector<pollfd> pipes;
    for (const Job& job : jobs_) pipes.push_back({job.child.descriptor(), POLLIN, 0});
    poll(pipes.data(), pipes.size(), 1000);
}

CampaignReport Campaign::run() {
    process::Progress progress;
    while (goes_on() || !jobs_.empty()) {
        while (goes_on() && jobs_.size() < std::max(options_.jobs, 1U)) begin_job();
        wait();
        for (auto job = jobs_.begin(); job != jobs_.end();) {
            if (job->child.receive()) {
                ++job;
                continue;
            }
            take_in(*job);
            job = jobs_.erase(job);
        }
        progress.show(options_.seconds > 0
                          ? fmt::format("{}: {:.0f} of {:.0f} s, {} runs, {} failures", options_.profile, seconds(),
                                        options_.seconds, report_.runs, report_.failures.size())
                          : fmt::format("{}: {} of {} runs, {} failures", options_.profile, report_.runs, options_.runs,
                                        report_.failures.size()));
    }
    std::ranges::sort(report_.failures, {}, &RunFailure::seed);
    report_.seconds = seconds();
    return report_;
}

}  // namespace

CampaignReport run_campaign(const CampaignOptions& options) {
    return Campaign(options).run();
}

std::string to_json(const CampaignOptions& options, const CampaignReport& report) {
    nlohmann::ordered_json json = {{"profile", options.profile}, {"seed", options.seed},
                                   {"runs", report.runs},        {"jobs", options.jobs},
                                   {"seconds", report.seconds},  {"runs_of", report.runs_of}};
    // "motions: one ulp" stands under "motions".
    for (const auto& [name, count] : report.counters) {
        const std::size_t colon = name.find(": ");
        if (colon == std::string::npos) {
            json[name] = count;
        } else {
            json["counts"][name.substr(0, colon)][name.substr(colon + 2)] = count;
        }
    }
    json["failures"] = nlohmann::json::array();
    for (const RunFailure& failure : report.failures) {
        nlohmann::ordered_json one = {{"profile", failure.profile},   {"seed", failure.seed},
                                      {"where", failure.where},       {"check", failure.check},
                                      {"expected", failure.expected}, {"got", failure.got}};
        if (!failure.text.empty()) one["text"] = failure.text;
        if (!failure.trace.empty()) one["trace"] = failure.trace;
        if (!failure.picture.empty()) one["picture"] = failure.picture;
        json["failures"].push_back(one);
    }
    return json.dump(2);
}

}  // namespace ecods::fuzz
