// Calls of worlds, played with all checks of the fuzzer of motions (script/play.hpp): after every update each pair of
// bodies is asked of the oracle, and at the end a trace is run again.
#include "fuzz/script/play.hpp"

#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/base/mesh_form.hpp"
#include "fuzz/base/user_shape.hpp"
#include "fuzz/script/any_call.hpp"
#include "fuzz/script/bad_calls.hpp"
#include "fuzz/targets/bytes.hpp"
#include "fuzz/targets/require.hpp"

namespace ecods::fuzz {
namespace {

// A script under way; any call draws from it (script/any_call.hpp).
class Drawing {
  public:
    Drawing(const std::uint8_t* data, std::size_t size) : bytes_(data, size) {
        for (Part& part : parts_) part = new_part();
        for (std::uint32_t i = 0, count = 1 + below(4); i < count; ++i) create();
    }

    Script draw() {
        for (int calls = 0; !bytes_.empty() && calls < 200; ++calls) draw_call();
        make(Update{});
        return std::move(script_);
    }

    std::uint32_t below(std::uint32_t count) { return bytes_.below(count); }
    Label next_label() const { return model_.next_label; }
    Label any_body() {
        return std::next(model_.bodies.begin(), below(static_cast<std::uint32_t>(model_.bodies.size())))->first;
    }
    const Part& any_part() { return parts_[bytes_.byte() % parts_.size()]; }
    Pose any_pose() { return bytes_.pose(); }
    CollisionFilter any_filter() { return {.groups = below(4), .mask = below(4)}; }
    std::optional<double> any_clearance() {
        return below(4) == 0 ? std::nullopt : std::optional(std::abs(bytes_.number()));
    }

  private:
    static constexpr std::size_t bodies_max = 24;

    Part new_part() {
        Part part{.mesh = bytes_.mesh(6, 4)};
        const std::uint32_t kind = below(8);
        if (kind < 2) part.kind = kind == 0 ? first_user_kind : second_user_kind;
        for (const MeshForm form : {MeshForm::solid, MeshForm::convex}) {
            if (kind >= 4 && has_form(part.mesh, form)) part.form = form;
        }
        return part;
    }

    void make(Call call) {
        model_.apply(call);
        script_.push_back(std::move(call));
    }

    void create() { make(Create{next_label(), any_part(), any_pose()}); }

    void refit() {
        const Label body = any_body();
        const Part& old = model_.bodies.at(body).part;
        if (old.kind != ShapeKind::mesh()) return;
        std::vector<Vec3> vertices(old.mesh->vertices().begin(), old.mesh->vertices().end());
        vertices[bytes_.byte() % vertices.size()] = bytes_.point();
        const auto mesh =
            Mesh::create(std::move(vertices), {old.mesh->triangles().begin(), old.mesh->triangles().end()});
        make(SetShape{body, {.mesh = mesh, .refits = true}});
    }

    void draw_call() {
        static const std::vector<std::string> bad_calls = bad_call_names();
        const std::uint32_t what = below(16);
        if (model_.bodies.empty()) return create();
        switch (what) {
            case 0:
                return model_.bodies.size() < bodies_max ? create() : make(Destroy{any_body()});
            case 1:
                return refit();
            case 2:
                return make(BadCall{any_body(), bytes_.byte(), bad_calls[bytes_.byte() % bad_calls.size()]});
            case 3:
                return make(MakeAgain{});
            case 4:
            case 5:
            case 6:  // a check costs as much as many calls
                return make(Update{.is_quiet = below(4) != 0});
            case 7:
            case 8:
            case 9:
                return make(SetPose{any_body(), any_pose()});
            default:
                if (auto call = any_call(*this)) make(std::move(*call));
        }
    }

    Bytes bytes_;
    std::array<Part, 4> parts_;
    Model model_;
    Script script_;
};

}  // namespace
}  // namespace ecods::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ecods::fuzz;
    Counters counters;
    try {
        play(Drawing(data, size).draw(), {}, counters);
    } catch (const Failure& failure) {
        const std::string what = failure.check + ": expected " + failure.expected + ", got " + failure.got;
        require(false, what.c_str());
    }
    return 0;
}
