#include "harness/judge.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

#include "oracle/oracle.hpp"
#include "process/parallel.hpp"
#include "process/progress.hpp"

namespace ecods::bench {

namespace {

using oracle::OracleMesh;

// Which pose a body has in each frame: that of the move `last_move[frame][body]`, a pointer into the scene; null at
// rest.
using Poses = std::vector<std::vector<const Pose*>>;

Poses poses_of(const scenes::Scene& scene) {
    Poses poses;
    std::vector<const Pose*>& rest = poses.emplace_back();
    for (const scenes::SceneBody& body : scene.bodies) rest.push_back(&body.pose);
    for (const scenes::Frame& frame : scene.frames) {
        poses.push_back(poses.back());
        for (const scenes::Move& move : frame.moves) poses.back()[move.body_index] = &move.pose;
    }
    return poses;
}

struct FrameTruth {
    std::vector<TrueHit> hits;  // of pairs that moved
    std::uint64_t exact_count = 0;
};

class Judge {
  public:
    Judge(const scenes::Scene& scene, Detail detail) : scene_(scene), detail_(detail), poses_(poses_of(scene)) {
        for (std::size_t body = 0; body < scene.bodies.size(); ++body) at_rest_.push_back(make(body, 0));
    }

    std::size_t frame_count() const { return poses_.size(); }

    bool moved(std::size_t frame, std::size_t body) const {
        return frame == 0 || poses_[frame][body] != poses_[frame - 1][body];
    }

    FrameTruth judge(std::size_t frame) const {
        std::vector<OracleMesh> bodies;
        std::vector<Aabb> boxes;
        for (std::size_t body = 0; body < scene_.bodies.size(); ++body) {
            bodies.push_back(poses_[frame][body] == poses_[0][body] ? at_rest_[body] : make(body, frame));
            boxes.push_back(bodies.back().outer_box());
        }
        FrameTruth truth;
        for (const auto& [a, b] : oracle::overlapping_boxes(boxes)) {
            if (!moved(frame, a) && !moved(frame, b)) continue;
            ++truth.exact_count;
            if (std::optional<TrueHit> hit = ask({a, b}, bodies)) truth.hits.push_back(std::move(*hit));
        }
        return truth;
    }

  private:
    OracleMesh make(std::size_t body, std::size_t frame) const {
        return OracleMesh(scene_.meshes[scene_.bodies[body].mesh_index].mesh, *poses_[frame][body]);
    }

    std::optional<TrueHit> ask(const IndexPair& pair, const std::vector<OracleMesh>& bodies) const {
        const OracleMesh &a = bodies[pair.a], &b = bodies[pair.b];
        if (detail_ == Detail::hits_only) {
            if (!oracle::intersects(a, b)) return std::nullopt;
            return TrueHit{pair, nullptr};
        }
        Contact contact{Relation::apart, oracle::intersecting_triangles(a, b)};
        if (contact.triangles.empty()) return std::nullopt;
        contact.relation = oracle::relation(a, b);
        return TrueHit{pair, std::make_shared<const Contact>(std::move(contact))};
    }

    const scenes::Scene& scene_;
    Detail detail_;
    Poses poses_;
    std::vector<OracleMesh> at_rest_;
};

}  // namespace

Truth ask_oracle(const scenes::Scene& scene, Detail detail, const std::string& label) {
    const auto start = std::chrono::steady_clock::now();
    const Judge judge(scene, detail);
    std::vector<FrameTruth> frames(judge.frame_count());
    {
        process::Progress progress(label + ": frames judged by the oracle", frames.size());
        process::for_each_in_parallel(frames.size(), std::max(1u, std::thread::hardware_concurrency()),
                                      [&](std::size_t frame, std::size_t) {
                                          frames[frame] = judge.judge(frame);
                                          progress.step();
                                      });
    }

    Truth truth;
    for (std::size_t frame = 0; frame < frames.size(); ++frame) {
        std::vector<TrueHit> hits = std::move(frames[frame].hits);
        if (frame > 0) {
            for (const TrueHit& hit : truth.hits.back())
                if (!judge.moved(frame, hit.pair.a) && !judge.moved(frame, hit.pair.b)) hits.push_back(hit);
        }
        std::sort(hits.begin(), hits.end(), [](const TrueHit& a, const TrueHit& b) { return a.pair < b.pair; });
        truth.hits.push_back(std::move(hits));
        truth.exact_count += frames[frame].exact_count;
    }
    truth.pair_count = frames.size() * (scene.bodies.size() * (scene.bodies.size() - 1) / 2);
    truth.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return truth;
}

std::vector<IndexPair> Truth::pairs_of(std::size_t frame) const {
    std::vector<IndexPair> pairs;
    for (const TrueHit& hit : hits[frame]) pairs.push_back(hit.pair);
    return pairs;
}

Errors compare(std::span<const std::vector<IndexPair>> reported, const Truth& truth) {
    Errors errors;
    for (std::size_t frame = 0; frame < truth.hits.size(); ++frame)
        errors += compare(reported[frame], truth.pairs_of(frame));
    return errors;
}

}  // namespace ecods::bench
