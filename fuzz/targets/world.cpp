// Calls of a world against the naive model: every pair of bodies asked of the oracle at every update.
//
// Two worlds are given the same calls, one of them with brute force; the first writes a trace, which is run again at
// the end.
#include <algorithm>
#include <limits>
#include <sstream>

#include "ecods/replay.hpp"
#include "ecods/world.hpp"
#include "fuzz/targets/bytes.hpp"
#include "fuzz/targets/model.hpp"
#include "fuzz/targets/require.hpp"
#include "scenes/numbers_of.hpp"

namespace ecods::fuzz {
namespace {

constexpr std::array kinds = {BroadPhaseKind::sweep_and_prune, BroadPhaseKind::kept_candidates,
                              BroadPhaseKind::automatic};

template <class Wanted, class Call>
void expect_error(Call call, const char* what) {
    try {
        call();
    } catch (const Wanted&) {
        return;
    }
    require(false, what);
}

template <class Call>
void expect_invalid(Call call, Argument argument, const char* what) {
    try {
        call();
    } catch (const InvalidArgument& error) {
        return require(error.argument == argument, what);
    }
    require(false, what);
}

class Session {
  public:
    Session(const std::uint8_t* data, std::size_t size)
        : bytes_(data, size),
          worlds_{World({.broad_phase = kinds[bytes_.byte() % kinds.size()]}),
                  World({.broad_phase = BroadPhaseKind::brute_force})} {
        worlds_[0].trace_to(trace_);
        for (auto& mesh : meshes_) mesh = bytes_.mesh(6, 4);
        for (std::uint32_t i = 0, count = 1 + bytes_.below(4); i < count; ++i) create();
    }

    void run() {
        for (int calls = 0; !bytes_.empty() && calls < 200; ++calls) call();
        update();
        worlds_[0].end_trace();
        std::istringstream in(trace_.str());
        const ReplayReport report = replay(in, {.validates = true});
        require(!report.difference, "the trace replays");
        require(report.body_count == model_.bodies.size(), "the replay ends with as many bodies");
    }

  private:
    static constexpr std::size_t bodies_max = 24;

    std::shared_ptr<const Mesh> any_mesh() { return meshes_[bytes_.byte() % meshes_.size()]; }
    ModelBody& any_body() { return model_.bodies[bytes_.byte() % model_.bodies.size()]; }

    void create() {
        const auto mesh = any_mesh();
        const Pose pose = bytes_.pose();
        // As written down: each world takes it for its own.
        const BodyId id = numbers_of(worlds_[0].create_body(mesh, pose));
        require(numbers_of(worlds_[1].create_body(mesh, pose)) == id, "two worlds give the same ids");
        model_.bodies.push_back({.id = id, .mesh = mesh, .pose = pose});
    }

    void destroy() {
        const std::size_t index = bytes_.byte() % model_.bodies.size();
        const BodyId id = model_.bodies[index].id;
        for (World& world : worlds_) world.destroy_body(id);
        model_.forget(index);
        for (World& world : worlds_) {
            require(!world.is_alive(id), "a destroyed body is gone");
            expect_error<StaleBody>([&] { world.set_pose(id, Pose()); }, "a stale id is refused");
        }
    }

    // The last of the two has the later pose if it is one body.
    void set_two_poses() {
        ModelBody& a = any_body();
        ModelBody& b = any_body();
        const std::array ids = {a.id, b.id};
        const std::array poses = {bytes_.pose(), bytes_.pose()};
        for (World& world : worlds_) world.set_poses(ids, poses);
        a.move_to(poses[0]);
        b.move_to(poses[1]);
    }

    void set_shape() {
        ModelBody& body = any_body();
        body.set_mesh(any_mesh());
        for (World& world : worlds_) world.set_shape(body.id, body.mesh);
    }

    void deform() {
        ModelBody& body = any_body();
        std::vector<Vec3> vertices(body.mesh->vertices().begin(), body.mesh->vertices().end());
        vertices[bytes_.byte() % vertices.size()] = bytes_.point();
        const auto shape = worlds_[0].shape(body.id);
        const auto soft = refit(static_cast<const MeshShape&>(*shape), std::move(vertices));
        body.set_mesh(soft->mesh_ptr());
        for (World& world : worlds_) world.set_shape(body.id, soft);
    }

    void set_filter() {
        ModelBody& body = any_body();
        body.filter = {.groups = bytes_.below(4), .mask = bytes_.below(4)};
        for (World& world : worlds_) world.set_filter(body.id, body.filter);
    }

    void switch_pair() {
        const BodyId a = any_body().id, b = any_body().id;
        const bool on = bytes_.below(2) == 0;
        if (a == b) {
            for (World& world : worlds_) {
                expect_error<SameBody>([&] { world.set_pair_enabled(a, b, on); }, "one body is no pair");
            }
            return;
        }
        model_.set_enabled(a, b, on);
        for (World& world : worlds_) world.set_pair_enabled(a, b, on);
    }

    void give_bad_input() {
        Pose bad = bytes_.pose();
        bad.t[bytes_.below(3)] = std::numeric_limits<double>::quiet_NaN();
        const BodyId id = any_body().id;
        for (World& world : worlds_) {
            expect_invalid([&] { world.set_pose(id, bad); }, Argument::pose, "a pose that is none is refused");
            expect_invalid([&] { world.create_body(meshes_[0], bad); }, Argument::pose,
                           "a body without a pose is refused");
        }
    }

    void ask_about_a_pair() {
        ModelBody& a = any_body();
        ModelBody& b = any_body();
        if (a.id == b.id) return;
        const oracle::Verdict expected = oracle::verdict(a.exact(), b.exact());
        for (World& world : worlds_) {
            require(world.relation(a.id, b.id) == expected.relation, "the relation of two bodies");
            require(world.intersecting_triangles(a.id, b.id) == expected.triangles, "the triangles of two bodies");
        }
    }

    void call() {
        const std::uint32_t what = bytes_.below(16);
        if (model_.bodies.empty() || (what == 0 && model_.bodies.size() < bodies_max)) return create();
        switch (what) {
            case 0:
            case 1:
                return destroy();
            case 2:
                return set_two_poses();
            case 3:
                return set_shape();
            case 4:
                return deform();
            case 5:
                return set_filter();
            case 6:
                return switch_pair();
            case 7:
                return give_bad_input();
            case 8:
                return ask_about_a_pair();
            case 9:
            case 10:
            case 11:
                return update();
            default: {
                ModelBody& body = any_body();
                const Pose pose = bytes_.pose();
                body.move_to(pose);
                for (World& world : worlds_) world.set_pose(body.id, pose);
            }
        }
    }

    void update() {
        for (World& world : worlds_) world.update();
        model_.update();
        for (World& world : worlds_) {
            for (ModelBody& body : model_.bodies) {
                require(oracle::box_contains(world.box(body.id), body.exact()), "a box contains its body");
            }
            require(std::ranges::equal(numbers_of(world.overlapping_pairs()), model_.overlapping(world)),
                    "overlapping pairs");
            require(std::ranges::equal(numbers_of(world.colliding_pairs()), model_.colliding()), "colliding pairs");
            require(std::ranges::equal(numbers_of(world.began()), model_.began()), "the pairs that began");
            require(std::ranges::equal(numbers_of(world.ended()), model_.ended()), "the pairs that ended");
            world.validate();
        }
        require(worlds_[0].digest() == worlds_[1].digest(), "the digests of two worlds");
    }

    Bytes bytes_;
    std::ostringstream trace_;
    std::array<World, 2> worlds_;
    std::array<std::shared_ptr<const Mesh>, 4> meshes_;
    Model model_;
};

}  // namespace
}  // namespace ecods::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ecods::fuzz::Session(data, size).run();
    return 0;
}
