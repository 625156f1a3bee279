// Any call of the table (trace/calls.hpp), drawn: by the generator of motions, and from a coverage-guided fuzzer's
// bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "fuzz/script/script.hpp"

namespace ecods::fuzz {

// The visitor that draws the fields of a call. The source has below(count), next_label(), and any_body(), any_part(),
// any_pose(), any_filter() and any_clearance().
template <class Source>
struct FieldDrawer {
    Source& source;
    Label last = 0;
    bool is_possible = true;

    void created(Label& body) const { body = source.next_label(); }
    void destroyed(Label& body) const { body = source.any_body(); }
    void body(Label& body) { last = body = source.any_body(); }
    void other_body(Label& body) {
        body = source.any_body();
        is_possible = body != last;
    }
    void shape(Part& part) const { part = source.any_part(); }
    void pose(Pose& pose) const { pose = source.any_pose(); }
    void posed_bodies(std::vector<Label>& bodies, std::vector<Pose>& poses) const {
        for (std::uint32_t i = 0, count = source.below(4); i < count; ++i) {
            bodies.push_back(source.any_body());
            poses.push_back(source.any_pose());
        }
    }
    void filter(CollisionFilter& filter) const { filter = source.any_filter(); }
    void flag(bool& flag) const { flag = source.below(2) == 0; }
    void data(std::uint64_t& data) const { data = source.below(100) * 0x100000001u; }
    void clearance(std::optional<double>& clearance) const { clearance = source.any_clearance(); }
};

// There must be a body. A pair may be drawn as one body twice: then there is no call.
template <class Source>
std::optional<Call> any_call(Source& source) {
    using Row = calls::Call<InScript>;
    Row call;
    calls::emplace_row(call, source.below(static_cast<std::uint32_t>(std::variant_size_v<Row>)));
    return std::visit(
        [&](auto& row) {
            FieldDrawer<Source> drawer{source};
            row.fields(drawer, row);
            return drawer.is_possible ? std::optional<Call>(std::move(row)) : std::nullopt;
        },
        call);
}

}  // namespace ecods::fuzz
