#include <nlohmann/json.hpp>
#include <stdexcept>

#include "suites/own_work.hpp"

namespace ecods::bench {

namespace {

template <class Read>
auto parse(const std::string& line, const Read& read) {
    try {
        return read(nlohmann::json::parse(line));
    } catch (const nlohmann::json::exception&) {
        throw std::runtime_error("not an answer of ecods_bench --own: " + line.substr(0, 80));
    }
}

}  // namespace

std::string to_line(const OwnSample& sample) {
    return nlohmann::json{{"ns", sample.ns}, {"counts", sample.counts}, {"answers", sample.answers}}.dump();
}

OwnSample parse_sample(const std::string& line) {
    return parse(line, [](const nlohmann::json& json) {
        OwnSample sample;
        json.at("ns").get_to(sample.ns);
        json.at("counts").get_to(sample.counts);
        json.at("answers").get_to(sample.answers);
        return sample;
    });
}

std::vector<std::string> parse_names(const std::string& line) {
    return parse(line, [](const nlohmann::json& json) { return json.get<std::vector<std::string>>(); });
}

}  // namespace ecods::bench
