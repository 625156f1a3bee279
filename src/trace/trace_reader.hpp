// Reads a trace and returns its lines as data, one after the other. Throws InvalidTrace if a line names an unknown body
// or shape, or if a list has another number of items than it announces.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "ecods/mesh.hpp"
#include "trace/mesh_form.hpp"
#include "trace/questions.hpp"
#include "trace/trace_lines.hpp"
#include "trace/trace_text.hpp"

namespace ecods {

using TracedCall = calls::Call<calls::InOrder>;
using TracedQuestion = calls::Question<calls::InOrder>;

struct TracedUpdate {
    struct Result {
        std::uint64_t digest;
        std::uint64_t colliding_count;
    };
    std::optional<Result> result;  // empty if the update failed, or the program ended during it
    bool has_failed = false;
};

// A TracedMesh holds a mesh; TracedHalfSpace holds a half space, TracedRounded a rounded shape, and TracedShape a shape
// of the caller's own. All are numbered in one sequence, calls::InOrder::Shape.
struct TracedMesh {
    std::shared_ptr<const Mesh> mesh;
    MeshForm form = MeshForm::surface;
};
struct TracedShape {
    ShapeKind kind;
    std::string text;
};
// `core` is the number of an earlier mesh in this sequence.
struct TracedRounded {
    std::size_t core = 0;
    double radius = 0;
};

struct TracedHalfSpace {
    Vec3 normal;
    double offset;
};

struct TracedNote {
    std::string text;
};

using TraceItem = std::variant<TracedCall, TracedQuestion, TracedUpdate, TracedMesh, TracedHalfSpace, TracedShape,
                               TracedRounded, TracedNote>;

// TracedNames holds the names of the bodies and shapes in the part of a trace that has been read.
struct TracedNames {
    struct BodyHash {
        std::size_t operator()(const TracedBody& body) const noexcept {
            return std::hash<std::uint64_t>()(std::uint64_t{body.generation} << 32 | body.slot);
        }
    };
    std::unordered_map<TracedBody, calls::Label, BodyHash> bodies;  // labels of living bodies
    std::vector<TracedBody> created;                                // names of all bodies, by label
    std::unordered_map<std::uint64_t, std::size_t> shapes;  // values of calls::InOrder::Shape, by number in the text
};

// A FieldReader reads the fields of a call or a question. The rows of calls.hpp and questions.hpp pass their fields to
// the FieldReader.
class FieldReader {
  public:
    FieldReader(TraceLines& lines, TracedNames& names) : lines_(lines), names_(names) {}

    void created(calls::Label& body);
    void destroyed(calls::Label& body);
    void body(calls::Label& body) { last_body_ = body = known_body()->second; }
    void other_body(calls::Label& body);
    void shape(std::size_t& shape);
    void pose(Pose& pose) { pose = lines_.pose(); }
    void posed_bodies(std::vector<calls::Label>& bodies, std::vector<Pose>& poses);
    void filter(CollisionFilter& filter) { filter = lines_.filter(); }
    void flag(bool& flag) { flag = lines_.decimal("0 or 1", 1) == 1; }
    void data(std::uint64_t& data) { data = lines_.hex("user data"); }
    void clearance(std::optional<double>& clearance) { clearance = lines_.clearance(); }
    void answer(std::uint64_t& digest) { digest = lines_.hex("a digest"); }
    void line(Segment& segment);
    void line(Ray& ray);
    void motion(Vec3& motion) { motion = lines_.point(); }
    void motion(Motion& motion);
    void moved_bodies(std::vector<calls::Label>& bodies, std::vector<Pose>& poses) { posed_bodies(bodies, poses); }
    void moved_bodies(std::vector<calls::Label>& bodies, std::vector<Motion>& motions);
    void point(Vec3& point) { point = lines_.point(); }
    void number(double& number) { number = lines_.number(); }
    void optional_filter(std::optional<CollisionFilter>& filter) { filter = lines_.optional_filter(); }
    void groups(std::uint64_t& groups) { groups = lines_.hex("groups"); }

  protected:
    TraceLines& lines() noexcept { return lines_; }

  private:
    decltype(TracedNames::bodies)::iterator known_body();
    Quaternion quaternion();

    TraceLines& lines_;
    TracedNames& names_;
    calls::Label last_body_ = 0;
};

class TraceReader {
  public:
    // Reads the header of the trace. Throws InvalidTrace if it is malformed.
    explicit TraceReader(std::istream& in);

    BroadPhaseKind broad_phase() const noexcept { return broad_phase_; }
    // Returns true if the traced world had given no id to a body before the trace began.
    bool begins_empty() const noexcept { return begins_empty_; }

    // Returns true if the trace is of version 1, in which solids collide as their surfaces.
    bool is_of_version_1() const noexcept { return is_of_version_1_; }

    // Returns the next item of the trace, or nullopt at the end. Throws InvalidTrace, also for a mesh that Mesh::create
    // rejects.
    std::optional<TraceItem> next();

    // Returns the number, from 1, of the last line of the last item.
    std::size_t line() const noexcept { return lines_.number(); }
    [[noreturn]] void fail(const std::string& reason) const { lines_.fail(reason); }

    // Returns the names of bodies and shapes, with which a caller can read fields in notes.
    TracedNames& names() noexcept { return names_; }

  private:
    TraceItem read_item();
    TracedUpdate read_update();
    TracedMesh read_mesh(MeshForm form);
    TracedHalfSpace read_half_space();
    TracedShape read_shape();
    TracedRounded read_rounded();
    void number_next_shape(std::uint64_t number, const char* kind);

    TraceLines lines_;
    TracedNames names_;
    BroadPhaseKind broad_phase_;
    bool begins_empty_;
    bool is_of_version_1_;
};

}  // namespace ecods
