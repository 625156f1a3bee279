#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "ecods/error.hpp"
#include "fuzz/base/user_shape.hpp"
#include "fuzz/script/trace.hpp"
#include "trace/trace_reader.hpp"

namespace ecods::fuzz {
namespace {

// Reads the fields of a call that stands in a note.
class NoteReader : public FieldReader {
  public:
    using FieldReader::FieldReader;
    void number(std::uint32_t& number) {
        number = static_cast<std::uint32_t>(lines().decimal("a number", ~std::uint32_t{0}));
    }
    void text(std::string& text) { text = lines().rest(); }
};

class Reader {
  public:
    explicit Reader(std::istream& in) : reader_(in) {}
    Script read();

  private:
    void take(const TracedCall& call);
    void take(const TracedUpdate& update);
    void take(const TracedQuestion&) {}  // questions are asked by the checks
    void take(const TracedMesh& mesh) { parts_.push_back({.mesh = mesh.mesh, .form = mesh.form}); }
    void take(const TracedHalfSpace&) { reader_.fail("no script has half spaces"); }
    void take(const TracedShape& shape);
    void take(const TracedRounded& shape) { parts_.push_back(rounded_part(parts_[shape.core], shape.radius)); }
    void take(const TracedNote& note);

    TraceReader reader_;
    Script script_;
    std::vector<Part> parts_;  // by their order in the trace
    bool refits_ = false;      // the next shape is a refit
    bool fails_ = false;       // of the next update, tests throw
    bool is_quiet_ = false;    // the next update is
};

Script Reader::read() {
    while (const auto item = reader_.next()) {
        try {
            std::visit([&](const auto& one) { take(one); }, *item);
        } catch (const InvalidTrace&) {
            throw;
        } catch (const Error& error) {
            reader_.fail(error.what());
        }
    }
    return std::move(script_);
}

void Reader::take(const TracedCall& call) {
    const auto part_of = [&](std::size_t index) {
        Part part = parts_[index];
        part.refits = std::exchange(refits_, false);
        return part;
    };
    std::visit(
        [&](const auto& row) {
            script_.emplace_back(calls::renamed<InScript>(
                row, [](Label label) { return label; }, part_of));
        },
        call);
}

void Reader::take(const TracedShape& shape) {
    if (shape.kind != first_user_kind && shape.kind != second_user_kind) {
        reader_.fail("there is no such kind of shape here");
    }
    parts_.push_back({read_user_mesh(shape.text), shape.kind});
}

// Notes that are none of these are for people.
void Reader::take(const TracedNote& note) {
    if (note.text == "refit") refits_ = true;
    if (note.text == "failing") fails_ = true;
    if (note.text == "quiet") is_quiet_ = true;

    std::istringstream in(note.text);
    TraceLines words(in, reader_.line() - 1);
    NoteCall call;
    if (!words.next() || words.at_end() || !calls::emplace_row(call, words.word("a note"))) return;
    std::visit(
        [&](auto& row) {
            row.fields(NoteReader(words, reader_.names()), row);
            script_.emplace_back(std::move(row));
        },
        call);
}

// An update that failed because tests threw is a part of the one that follows; of any other, and of a crash, the
// result that it should have had is not known.
void Reader::take(const TracedUpdate& traced) {
    Update update{.fails = fails_, .is_quiet = is_quiet_};
    if (traced.has_failed) {
        if (!fails_) script_.emplace_back(update);
        return;
    }
    if (traced.result) update.digest = traced.result->digest;
    fails_ = is_quiet_ = false;
    script_.emplace_back(update);
}

}  // namespace

Script read_trace(std::istream& in) {
    return Reader(in).read();
}

}  // namespace ecods::fuzz
