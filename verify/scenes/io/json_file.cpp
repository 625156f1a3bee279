#include "scenes/io/json_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "scenes/io/read_bytes.hpp"
#include "scenes/io/text_file.hpp"

namespace ecods::scenes {
namespace {

using Json = nlohmann::json;

// The parser reports no position with its events, so it reads through these; all copies of one count for one reader.
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

// Builds the document from the parser's events, each in constant time but for the search of a key in its object. The
// parser's own callback looks through the list that an object is in at the end of the object: n objects cost n^2.
class DocumentBuilder final : public nlohmann::json_sax<Json> {
  public:
    DocumentBuilder(const std::filesystem::path& file, std::string_view text)
        : file_(file), text_(text), newest_(text.data()) {}

    JsonDocument build() {
        Json::sax_parse(Cursor(text_.data(), &newest_), Cursor(text_.data() + text_.size(), &newest_), this);
        // The parser takes a zero byte for the end. Zeros may pad the text, but nothing may follow them.
        if (text_.find_first_not_of('\0', read_count()) != std::string_view::npos) fail("this is not JSON");
        return std::move(document_);
    }

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(std::int64_t value) override { return put(value); }
    bool number_unsigned(std::uint64_t value) override { return put(value); }
    bool number_float(double value, const std::string& /*text*/) override { return put(value); }
    bool string(std::string& value) override { return put(std::move(value)); }
    bool binary(Json::binary_t& value) override { return put(std::move(value)); }

    bool start_object(std::size_t /*size*/) override { return open(Json::object()); }
    bool start_array(std::size_t /*size*/) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(std::string& key) override {
        const auto [member, is_new] = open_.back()->get_ref<Json::object_t&>().try_emplace(key);
        if (!is_new) fail("the key \"" + shown(key) + "\" is given twice");
        member_ = &member->second;
        return true;
    }

    bool parse_error(std::size_t position, const std::string& /*token*/, const Json::exception& error) override {
        if (dynamic_cast<const Json::out_of_range*>(&error) != nullptr) fail("a number is beyond the largest double");
        throw ReadError(file_, line(std::min(position, text_.size())), "this is not JSON");
    }

  private:
    // The place of the value is the document, the end of the innermost open list, or the newest key of the innermost
    // open object.
    Json& place_of(Json&& value) {
        if (open_.empty()) return *document_ = std::move(value);
        if (open_.back()->is_array()) return open_.back()->get_ref<Json::array_t&>().emplace_back(std::move(value));
        return *member_ = std::move(value);
    }

    bool put(Json&& value) {
        place_of(std::move(value));
        return true;
    }

    bool open(Json&& value) {
        if (open_.size() == json_depth_max)
            fail(fmt::format("more than {} lists and objects are open", json_depth_max));
        open_.push_back(&place_of(std::move(value)));
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    std::size_t read_count() const { return static_cast<std::size_t>(newest_ - text_.data()); }

    // The line of the last byte but one: behind a number, the parser has read one byte that does not belong to it.
    std::string line(std::size_t read) const {
        const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(read, 1) - 1);
        return fmt::format("line {}", 1 + std::count(text_.begin(), text_.empty() ? text_.begin() : end, '\n'));
    }

    [[noreturn]] void fail(const std::string& why) const { throw ReadError(file_, line(read_count()), why); }

    const std::filesystem::path& file_;
    std::string_view text_;
    const char* newest_;  // behind the last byte that the parser has read
    JsonDocument document_;
    std::vector<Json*> open_;  // lists and objects, innermost last; a list gets no element while its last one is open
    Json* member_ = nullptr;   // of the newest key
};

// Empties lists and objects, the innermost first: what is empty asks for no memory at its end.
void take_apart(Json& value) noexcept {
    if (value.is_array()) {
        auto& list = value.get_ref<Json::array_t&>();
        for (Json& element : list) take_apart(element);
        list.clear();
    } else if (value.is_object()) {
        auto& object = value.get_ref<Json::object_t&>();
        for (auto& [key, member] : object) take_apart(member);
        object.clear();
    }
}

}  // namespace

JsonDocument::~JsonDocument() {
    take_apart(value_);
}

JsonDocument parse_json(const std::filesystem::path& file, std::string_view text) {
    return DocumentBuilder(file, text).build();
}

JsonDocument read_json(const std::filesystem::path& file) {
    return parse_json(file, read_bytes(file));
}

}  // namespace ecods::scenes
