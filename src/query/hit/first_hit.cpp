#include <algorithm>
#include <bit>
#include <tuple>
#include <utility>

#include "base/next.hpp"
#include "query/hit/hit_memory.hpp"
#include "query/hit/hit_search.hpp"

namespace ecods {
namespace {

// BodySearch finds the least hit of one body with a line, up to a limit. Triangles that are certainly hit inside their
// faces are collected with bounds in doubles, and compared exactly at the end. Other triangles are decided in integers
// at once, and the least of their hits is kept.
class BodySearch {
  public:
    BodySearch(const Posed<MeshShape>& body, HitMemory& memory, const ScaledLine& line, double limit, HitCounts& counts)
        : body_(body),
          triangles_(body.what->mesh().triangles().data()),
          vertices_(body.what->mesh().vertices().data()),
          memory_(memory),
          faces_(memory.faces),
          line_(line),
          counts_(counts) {
        faces_.start({.at_most = limit});
    }

    // Returns an upper bound of the scaled parameter of the least hit of this body and of all earlier bodies.
    double parameter_limit() const noexcept { return faces_.bound(); }

    // Makes the walk test `triangle` before all others. If floats exclude all triangles, `triangle` is not tested at
    // all.
    void try_first(std::uint32_t triangle) noexcept { waiting_ = triangle; }

    void walk(LineAxes::Place place) {
        set_ratio();
        if (place == LineAxes::Place::unknown) try_waiting();
        memory_.walk(body_, place, *this);
    }

    // walk_line() calls the following functions.
    float limit() const noexcept { return ratio_; }
    void visit_node() noexcept { ++box_tests_; }
    void visit(const TreeLeaf& leaf, const FoundInLeaf& found) {
        counts_.triangle_tests += leaf.count;
        if (found.may_meet == 0) return;
        try_waiting();
        for (std::uint32_t lanes = found.may_meet; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            const Triangle& vertices = leaf.vertices[lane];
            const std::uint32_t triangle = leaf.triangle[lane], bit = lanes & -lanes;
            if (triangle == tried_) continue;
            if ((found.inside & bit) != 0 && memory_.axes.is_within(found.low[lane], found.high[lane])) {
                take_face(triangle, vertices, memory_.axes.parameter_below(found.low[lane]),
                          memory_.axes.parameter_above(found.high[lane]));
                continue;
            }
            if ((found.cross & bit) == 0 || !ties_at_shared(triangle, vertices)) visit(triangle, vertices);
        }
    }
    void visit(std::uint32_t triangle) { visit(triangle, triangles_[triangle]); }
    void visit(std::uint32_t triangle, const Triangle& vertices);

    // Drops faces whose hits doubles prove not to be the first. Call this function when all triangles have been
    // visited.
    void settle();
    // If the only candidate is a face, and its hit can be rounded cheaply, sets `hit` to this hit and returns true.
    // Otherwise returns false.
    bool round_only_face(Hit& hit);
    // Compares the remaining candidates exactly. Returns true if there is a hit; memory.own is then the least hit, and
    // triangle() is its triangle.
    bool finish();
    std::uint32_t triangle() const noexcept { return least_; }
    std::uint64_t box_tests() const noexcept { return box_tests_; }

  private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    void set_ratio() noexcept { ratio_ = memory_.axes.ratio_above(faces_.bound()); }
    void take_upper(double upper, std::uint32_t triangle) noexcept {
        if (faces_.take_upper(upper, {triangle, 0})) set_ratio();
    }
    // Tests the waiting triangle, and stores it in tried_, so that the walk will skip this triangle.
    void try_waiting() {
        if (waiting_ == none) return;
        tried_ = std::exchange(waiting_, none);
        visit(tried_);
    }
    // Adds a triangle that is certainly hit inside its face, at a parameter from `lower` to `upper`.
    void take_face(std::uint32_t triangle, const Triangle& vertices, double lower, double upper) {
        if (!faces_.counts(lower)) return;
        for (const std::uint32_t vertex : vertices) __builtin_prefetch(&vertices_[vertex]);
        faces_.add({{lower, upper, vertices}, {triangle, 0}});
        take_upper(upper, triangle);
    }
    void decide(std::uint32_t triangle, const Triangle& vertices, const HitEnclosure& enclosure);
    void keep_least(std::uint32_t triangle, const Triangle& vertices) noexcept;
    void set_shared(const Triangle& corners, const exact::LineHit& hit) noexcept;
    bool ties_at_shared(std::uint32_t triangle, const Triangle& vertices) noexcept;
    bool ties_along(std::uint32_t triangle, const Triangle& vertices) noexcept;
    void take_tie(std::uint32_t triangle, Feature::Kind feature, std::uint32_t corner) noexcept;

    const Posed<MeshShape>& body_;
    const Triangle* triangles_;
    const Vec3* vertices_;
    HitMemory& memory_;
    HitMemory::FaceSieve& faces_;
    const ScaledLine& line_;
    float ratio_ = 1;
    HitCounts& counts_;
    std::uint64_t box_tests_ = 0;
    std::uint32_t waiting_ = none;
    std::uint32_t tried_ = none;
    std::uint32_t least_ = none;  // triangle of memory.own
    // Names the feature through which the line enters the triangle of memory.own, by vertices of the mesh: one vertex,
    // or the two of an edge; `none` if it is not known.
    std::array<std::uint32_t, 2> shared_{none, none};
    // Names the two vertices of an edge along which the line runs from the entry point on; `none` if no such edge is
    // known. Some triangle of this edge shares nothing else with the line. If memory.own is a hit along an edge, along_
    // names that edge.
    std::array<std::uint32_t, 2> along_{none, none};
};

void BodySearch::visit(std::uint32_t triangle, const Triangle& vertices) {
    ++counts_.enclosures;
    const HitEnclosure enclosure = memory_.triangles.enclose(vertices);
    if (enclosure.verdict == HitEnclosure::Verdict::none || !faces_.counts(enclosure.lower)) return;
    if (enclosure.verdict == HitEnclosure::Verdict::face) {
        take_face(triangle, vertices, enclosure.lower, enclosure.upper);
    } else {
        decide(triangle, vertices, enclosure);
    }
}

void BodySearch::decide(std::uint32_t triangle, const Triangle& vertices, const HitEnclosure& enclosure) {
    if (enclosure.is_crossing && ties_at_shared(triangle, vertices)) return;
    if (enclosure.has_area && ties_along(triangle, vertices)) return;
    ++counts_.exact;
    if (!memory_.triangles.find(vertices, *memory_.other)) return;
    keep_least(triangle, vertices);
    if (least_ != triangle) return;
    double upper = enclosure.upper;
    if (!enclosure.is_crossing) upper = line_.scaled_above(next_up(exact::round_fraction(memory_.own->enter.ref())));
    take_upper(upper, triangle);
}

// Makes memory.other, the hit of `triangle`, the least hit memory.own, unless an earlier hit is less.
void BodySearch::keep_least(std::uint32_t triangle, const Triangle& corners) noexcept {
    const int order = least_ == none ? -1 : compare(memory_.other->enter.ref(), memory_.own->enter.ref());
    if (order > 0) return;
    // If the parameters are equal, shared_ and along_ stay valid: every triangle with this vertex or edge is hit at
    // that parameter.
    if (order < 0) shared_ = along_ = {none, none};
    const exact::LineHit& hit = *memory_.other;
    const bool is_kept = triangle < least_ || order < 0;
    if (hit.is_along && hit.feature == Feature::Kind::edge && (is_kept || along_[0] == none))
        along_ = {corners[hit.corner], corners[(hit.corner + 1) % 3]};
    if (shared_[0] == none) set_shared(corners, hit);
    if (!is_kept) return;
    std::swap(memory_.own, memory_.other);
    least_ = triangle;
}

void BodySearch::set_shared(const Triangle& corners, const exact::LineHit& hit) noexcept {
    if (hit.is_along) {
        if (hit.entry < 3) shared_[0] = corners[hit.entry];
    } else if (hit.feature != Feature::Kind::face) {
        shared_[0] = corners[hit.corner];
        if (hit.feature == Feature::Kind::edge) shared_[1] = corners[(hit.corner + 1) % 3];
    }
}

// Returns the corner at which the triangle's edge with these two vertices begins; 3 if the triangle has no such edge.
std::uint32_t find_edge(const Triangle& corners, const std::array<std::uint32_t, 2>& edge) noexcept {
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t p = corners[i], q = corners[(i + 1) % 3];
        if ((p == edge[0] && q == edge[1]) || (p == edge[1] && q == edge[0])) return i;
    }
    return 3;
}

// Makes `triangle` the triangle of the least hit memory.own, with its feature and corner. The line must hit `triangle`
// at the parameter of the least hit so far.
void BodySearch::take_tie(std::uint32_t triangle, Feature::Kind feature, std::uint32_t corner) noexcept {
    least_ = triangle;
    memory_.own->feature = feature;
    memory_.own->corner = corner;
}

// Returns true if the triangle has the vertex or edge shared_, through which the line enters the triangle of the least
// hit. Call it only if the line crosses the plane of `triangle`. The line then hits `triangle` at shared_ and nowhere
// else, so both hits have the same parameter, and no computation is needed.
bool BodySearch::ties_at_shared(std::uint32_t triangle, const Triangle& corners) noexcept {
    if (shared_[0] == none) return false;
    const bool is_vertex = shared_[1] == none;
    const auto corner = is_vertex ? static_cast<std::uint32_t>(std::ranges::find(corners, shared_[0]) - corners.begin())
                                  : find_edge(corners, shared_);
    if (corner == 3) return false;
    if (triangle < least_) {
        take_tie(triangle, is_vertex ? Feature::Kind::vertex : Feature::Kind::edge, corner);
        memory_.own->is_along = false;
    }
    return true;
}

// Returns true if the triangle has the edge along_, along which the line runs, and so needs no computation. Call it
// only if the triangle's corners are not on one line. Then the triangle shares with the line the same points as the
// other triangle of this edge, from the same parameter on.
bool BodySearch::ties_along(std::uint32_t triangle, const Triangle& corners) noexcept {
    if (along_[0] == none) return false;
    const std::uint32_t corner = find_edge(corners, along_);
    if (corner == 3) return false;
    if (triangle > least_) return true;
    // If memory.own does not run along an edge, the parameter at which the line leaves the edge along_ is no longer
    // stored.
    if (!memory_.own->is_along || memory_.own->feature != Feature::Kind::edge) return false;
    take_tie(triangle, Feature::Kind::edge, corner);
    return true;
}

void BodySearch::settle() {
    faces_.drop();
    // Doubles exclude most of the faces that floats leave open.
    if (faces_.open().size() + (least_ != none) < 2) return;
    for (HitMemory::FaceSieve::Open& face : faces_.open()) {
        ++counts_.enclosures;
        const HitEnclosure enclosure = memory_.triangles.enclose(face.interval.vertices);
        face.interval.lower = std::max(face.interval.lower, enclosure.lower);
        take_upper(enclosure.upper, face.triangles.a);
    }
    faces_.drop();
}

bool BodySearch::round_only_face(Hit& hit) {
    if (least_ != none || faces_.open().size() != 1) return false;
    const HitMemory::FaceSieve::Open& face = faces_.open().front();
    exact::RoundedCrossing crossing;
    if (!memory_.triangles.round_crossing(face.interval.vertices, crossing)) return false;
    ++counts_.exact;
    least_ = face.triangles.a;
    hit.parameter = hit.leave_parameter = crossing.at.parameter;
    hit.point = hit.leave_point = crossing.at.point;
    hit.kind = crossing.facing < 0 ? HitKind::front : HitKind::back;
    hit.feature = {Feature::Kind::face, least_, 0};
    return true;
}

bool BodySearch::finish() {
    for (const HitMemory::FaceSieve::Open& face : faces_.open()) {
        ++counts_.exact;
        memory_.triangles.find_crossing(face.interval.vertices, *memory_.other);
        keep_least(face.triangles.a, face.interval.vertices);
    }
    return least_ != none;
}

}  // namespace

FirstHit::FirstHit(const Line& line, QueryMemory& memory, bool is_alone)
    : line_(line),
      is_alone_(is_alone),
      scaled_(line),
      memory_(HitMemory::of(memory)),
      counts_(QueryMemoryAccess::state(memory).counts),
      limit_(scaled_.end_high) {}

bool FirstHit::is_before_least(const exact::Fraction& at, std::uint64_t key, std::uint32_t triangle) const noexcept {
    if (!found_) return true;
    const int order = compare(at.ref(), memory_.best->enter.ref());
    return order != 0 ? order < 0 : std::tuple(key, triangle) < std::tuple(least_.key, least_.hit.feature.triangle);
}

void FirstHit::ask(const Posed<MeshShape>& body, std::uint64_t key, PairWitness& witness) {
    ++counts_.queries;
    const LineAxes::Place place = memory_.bind(line_, scaled_, limit_, body);
    if (place == LineAxes::Place::apart) return;
    BodySearch search(body, memory_, scaled_, limit_, counts_.hits);
    if (witness.b < body.what->mesh().triangles().size()) search.try_first(witness.b);
    search.walk(place);
    counts_.box_tests += search.box_tests();
    take(search, key, witness);
}

void FirstHit::ask_about(std::span<const std::uint32_t> triangles, const Posed<MeshShape>& body, std::uint64_t key,
                         PairWitness& witness) {
    ++counts_.queries;
    memory_.bind_triangles(line_, scaled_, body);
    BodySearch search(body, memory_, scaled_, limit_, counts_.hits);
    for (const std::uint32_t triangle : triangles) search.visit(triangle);
    take(search, key, witness);
}

template <class Search>
void FirstHit::take(Search& search, std::uint64_t key, PairWitness& witness) {
    search.settle();
    const bool is_rounded = is_alone_ && search.round_only_face(least_.hit);
    if (!is_rounded) {
        if (!search.finish() || !is_before_least(memory_.own->enter, key, search.triangle())) return;
        std::swap(memory_.best, memory_.own);
        least_.hit.feature.triangle = search.triangle();
    }
    if (search.triangle() == witness.b) ++counts_.witness_hits;
    witness.b = search.triangle();
    limit_ = search.parameter_limit();
    found_ = true;
    is_rounded_ = is_rounded;
    least_.key = key;
}

void FirstHit::ask(const Posed<MeshShape>& body, std::uint64_t key) {
    PairWitness witness;
    ask(body, key, witness);
}

void FirstHit::offer(const Hit& hit, std::uint64_t key) {
    const exact::Fraction at = exact::fraction_of(hit.parameter);
    if (!is_before_least(at, key, hit.feature.triangle)) return;
    memory_.best->enter = at;
    limit_ = std::min(limit_, scaled_.scaled_above(hit.parameter));
    least_ = {key, hit};
    found_ = true;
    is_rounded_ = true;
}

FirstHit::Kept FirstHit::keep() const {
    return found_ ? std::make_shared<const exact::LineHit>(*memory_.best) : nullptr;
}

void FirstHit::put_back(const Kept& least) noexcept {
    if (least) *memory_.best = *least;
}

KeyedHit FirstHit::get() const {
    KeyedHit result = least_;
    if (!is_rounded_) result.hit = rounded(line_, *memory_.best, least_.hit.feature.triangle);
    result.hit.rank = 0;
    return result;
}

}  // namespace ecods
