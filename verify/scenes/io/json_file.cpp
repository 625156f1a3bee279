#include "scenes/io/json_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "scenes/io/read_bytes.hpp"
#include "scenes/io/text_file.hpp"

namespace ecods::scenes {
namespace {

// The parser calls back without a position. It reads through these; all copies of one count for the same reader.
class Cursor {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Cursor(const char* at, const char** newest) : at_(at), newest_(newest) {}

    reference operator*() const { return *at_; }
    Cursor& operator++() {
        *newest_ = ++at_;
        return *this;
    }
    bool operator==(const Cursor& other) const { return at_ == other.at_; }

  private:
    const char* at_;
    const char** newest_;  // behind the last byte that was read
};

// The keys of the objects that are open, innermost last.
class OpenKeys {
  public:
    using Event = nlohmann::json::parse_event_t;

    // False for a key that its object has already.
    bool add(Event event, const nlohmann::json& value) {
        if (event == Event::object_start) keys_.emplace_back();
        if (event == Event::object_end) keys_.pop_back();
        return event != Event::key || keys_.back().insert(value.get_ref<const std::string&>()).second;
    }

  private:
    std::vector<std::set<std::string>> keys_;
};

}  // namespace

nlohmann::json parse_json(const std::filesystem::path& file, std::string_view text) {
    const char* newest = text.data();
    // The line of the last byte but one: behind a number, the parser has read one byte that does not belong to it.
    const auto line = [&](std::size_t read) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(read, 1) - 1);
        return fmt::format("line {}", 1 + std::count(text.begin(), text.empty() ? text.begin() : end, '\n'));
    };
    const auto line_here = [&] { return line(static_cast<std::size_t>(newest - text.data())); };
    OpenKeys open;
    try {
        const auto check = [&](int, nlohmann::json::parse_event_t event, const nlohmann::json& value) {
            if (open.add(event, value)) return true;
            throw ReadError(file, line_here(),
                            "the key \"" + shown(value.get_ref<const std::string&>()) + "\" is given twice");
        };
        nlohmann::json document =
            nlohmann::json::parse(Cursor(text.data(), &newest), Cursor(text.data() + text.size(), &newest), check);
        // The parser takes a zero byte for the end. Zeros may pad the text, but nothing may follow them.
        if (text.find_first_not_of('\0', static_cast<std::size_t>(newest - text.data())) != std::string_view::npos)
            throw ReadError(file, line_here(), "this is not JSON");
        return document;
    } catch (const nlohmann::json::parse_error& error) {
        throw ReadError(file, line(std::min(error.byte, text.size())), "this is not JSON");
    } catch (const nlohmann::json::out_of_range&) {
        throw ReadError(file, line_here(), "a number is beyond the largest double");
    } catch (const nlohmann::json::exception& error) {
        throw ReadError(file, line_here(), error.what());
    }
}

nlohmann::json read_json(const std::filesystem::path& file) {
    return parse_json(file, read_bytes(file));
}

}  // namespace ecods::scenes
