#include "scenes/cast_workloads.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "ecods/cast.hpp"
#include "scenes/approach.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"

namespace ecods::scenes {

namespace {

// What comes to what: a, and b where it is another mesh.
struct Meeting {
    NamedMesh a;
    std::optional<NamedMesh> b = {};
    bool is_hull = false;

    const NamedMesh& resting() const { return b ? *b : a; }
    std::string name() const { return b ? a.name + " to " + b->name : a.name; }
};

CastWorkload empty_workload(const Meeting& meeting, const std::string& name) {
    CastWorkload workload{meeting.name() + ", " + name, {meeting.resting()}, {}, true, meeting.is_hull};
    if (meeting.b) workload.meshes.push_back(meeting.a);
    return workload;
}

class Motions {
  public:
    Motions(const Meeting& meeting, std::uint32_t seed)
        : meeting_(meeting), random_(seed), approach_(meeting.resting().mesh, meeting.a.mesh) {}

    // Ends where the distance is that share of the diameter, then goes on by another share.
    CastWorkload slides(const std::string& name, double gap, double beyond, std::size_t count) {
        return fill(empty_workload(meeting_, name), count, [&]() -> std::optional<CastQuery> {
            draw();
            const auto stop = approach_.stop_at(gap * approach_.diameter());
            if (!stop) return std::nullopt;
            const double end = *stop - beyond * approach_.diameter();
            return slide(approach_.at(end).b.pose, -approach_.diameter() * approach_.line);
        });
    }

    CastWorkload grazing(std::size_t count) {
        bool is_to_meet = false;
        return fill(empty_workload(meeting_, "grazing"), count, [&] {
            is_to_meet = !is_to_meet;
            return graze(is_to_meet);
        });
    }

    CastWorkload turns(const std::string& name, double gap, double beyond, std::size_t count) {
        CastWorkload workload = empty_workload(meeting_, name);
        workload.is_translation = false;
        return fill(std::move(workload), count, [&]() -> std::optional<CastQuery> {
            draw();
            const auto stop = approach_.stop_at(gap * approach_.diameter());
            if (!stop) return std::nullopt;
            const Pose end = approach_.at(*stop - beyond * approach_.diameter()).b.pose;
            approach_.moving = product(turn_about(random_.direction(), 0.05), approach_.moving);
            const MeshQuery start = approach_.at(*stop + approach_.diameter());
            return CastQuery{start.b, start.a, Vec3::Zero(), end};
        });
    }

  private:
    void draw() {
        approach_.resting = random_.rotation().toRotationMatrix();
        approach_.moving = random_.rotation().toRotationMatrix();
        approach_.line = random_.direction();
    }

    template <class Make>
    static CastWorkload fill(CastWorkload workload, std::size_t count, const Make& make) {
        while (workload.queries.size() < count)
            if (const std::optional<CastQuery> query = make()) workload.queries.push_back(*query);
        return workload;
    }

    // To `end`, or as near to it as doubles allow.
    CastQuery slide(const Pose& end, const Vec3& motion) const {
        const MeshQuery anywhere = approach_.at(0);
        CastQuery query{anywhere.b, anywhere.a, motion, end};
        query.a.pose = {end.R, end.t - motion};
        query.a_end.t = query.a.pose.t + motion;
        return query;
    }

    std::optional<CastQuery> graze(bool is_to_meet) {
        draw();
        // Any direction across the line.
        Vec3 aside = random_.direction();
        const Vec3& line = approach_.line;
        aside -= ((aside.x() * line.x() + aside.y() * line.y()) + aside.z() * line.z()) * line;
        const auto at = [&](double offset) {
            Pose end = approach_.at(-1.5 * approach_.diameter()).b.pose;
            end.t += offset * aside;
            return slide(end, -3 * approach_.diameter() * line);
        };
        double near = 0, far = 8 * approach_.diameter();
        if (!meets(at(near)) || meets(at(far))) return std::nullopt;
        for (int i = 0; i < 43; ++i) {
            const double middle = near + (far - near) / 2;
            (meets(at(middle)) ? near : far) = middle;
        }
        return at(is_to_meet ? near : far);
    }

    bool meets(const CastQuery& query) {
        return cast({moving_shape_, query.a.pose}, query.motion, {resting_shape_, query.b.pose}, 1, memory_)
            .has_value();
    }

    Meeting meeting_;
    Random random_;
    Approach approach_;
    MeshShape moving_shape_{meeting_.a.mesh}, resting_shape_{meeting_.resting().mesh};
    QueryMemory memory_;
};

}  // namespace

std::vector<CastWorkload> cast_workloads(WorkloadSize size) {
    const bool is_tiny = size == WorkloadSize::tiny;
    const NamedMesh of_ship{"ship", ship()}, torus_10k{"torus 10k", torus(100, 50, 0.4)}, ball{"ball", sphere(12, 8)};
    struct Case {
        Meeting meeting;
        std::size_t count;
        bool has_turns;
    };
    std::vector<Case> cases = {{{of_ship}, 100, true}};
    if (!is_tiny) {
        cases.push_back({{torus_10k}, 12, true});
        cases.push_back({{{"torus 100k", torus(400, 125, 0.4)}}, 20, false});
        cases.push_back({{ball, torus_10k, true}, 20, false});
    }
    cases.push_back({{.a = ball, .is_hull = true}, 40, false});
    std::vector<CastWorkload> workloads;
    for (const auto& [meeting, full_count, has_turns] : cases) {
        const std::size_t count = is_tiny ? 3 : full_count;
        Motions motions(meeting, 21);
        workloads.push_back(motions.slides("to a gap of 1e-4", 1e-4, 0, count));
        workloads.push_back(motions.slides("to a gap of 1e-12", 1e-12, 0, count));
        workloads.push_back(motions.slides("into contact", 1e-4, 0.05, count));
        workloads.push_back(motions.grazing(count));
        if (!has_turns) continue;
        workloads.push_back(motions.turns("turned, to a gap of 1e-4", 1e-4, 0, count));
        workloads.push_back(motions.turns("turned, into contact", 1e-4, 0.05, count));
    }
    return workloads;
}

}  // namespace ecods::scenes
