// The table of what a World answers about two bodies, by their kinds, and its table of one body. world.hpp and
// rounded.hpp have it in words.
#include <sstream>
#include <tuple>

#include "unit/query/kinds.hpp"

namespace ecods::kinds {
namespace {

// A world of both bodies of a case.
struct TwoBodies {
    explicit TwoBodies(const Case& c)
        : a(world.create_body(c.a.shape, c.a.pose)),
          b(world.create_body(c.b.shape, c.b.pose)),
          left(c.is_turned ? b : a) {}

    World world;
    BodyId a, b, left;
};

// Asks a world of both bodies, updated; and expects that both are in the answer exactly if they are that close.
template <class Ask>
auto lists(const Ask& ask, double greatest_gap) {
    return [=](const Case& c) {
        TwoBodies bodies(c);
        bodies.world.update();
        const std::size_t count = ask(bodies);
        if (c.is_known()) {
            EXPECT_EQ(count, c.gap <= greatest_gap ? 1U : 0U);
        }
    };
}
template <class Ask>
auto asks(const Ask& ask) {
    return [=](const Case& c) {
        TwoBodies bodies(c);
        bodies.world.update();
        std::ignore = ask(bodies);
    };
}
// Asks for the distance of the bodies.
template <class Ask>
auto measures(const Ask& ask) {
    return [=](const Case& c) {
        TwoBodies bodies(c);
        const double got = ask(bodies);
        if (c.is_known()) {
            EXPECT_EQ(got, c.gap);
        }
    };
}
// Asks when the first body, which goes to the second one by 2, meets it.
template <class Ask>
auto casts(const Ask& ask, double at_gap_one) {
    return [=](const Case& c) {
        TwoBodies bodies(c);
        bodies.world.update();
        const auto got = ask(bodies, 2 * c.toward());
        if (!c.is_known()) return;
        ASSERT_TRUE(got.has_value());
        EXPECT_EQ(*got, c.gap > 0 ? at_gap_one : 0);
    };
}

std::optional<double> time_of(const std::optional<BodyContact>& met) {
    return met ? std::optional(met->contact.time) : std::nullopt;
}
std::optional<double> time_of(const std::vector<Meeting>& met) {
    return met.empty() ? std::nullopt : std::optional(met.front().contact.time);
}

std::vector<Row> pairs() {
    return {
        // of            M       S      C     F    K   R  H
        // and           MSCFKRH SCFKRH CFKRH FKRH KRH RH H
        {"create_body", "+++++++ ++++++ +++++ ++++ +++ ++ +", asks([](TwoBodies& w) { return w.world.statistics(); })},
        {"intersects", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         lists([](TwoBodies& w) { return w.world.intersects(w.a, w.b); }, 0)},
        {"relation", "+++++a+ ++++a+ +++a+ ++a+ +a+ a+ +",
         lists([](TwoBodies& w) { return w.world.relation(w.a, w.b) != Relation::apart; }, 0)},
        {"distance", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         measures([](TwoBodies& w) { return w.world.distance(w.a, w.b); })},
        {"within", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         lists([](TwoBodies& w) { return w.world.within(w.a, w.b, 1); }, 1)},
        {"closest", "+++++++ ++++++ +++++ ++++ +++ ++ x",
         measures([](TwoBodies& w) { return w.world.closest(w.a, w.b).distance; })},
        {"signed_distance", "xxxxaa+ xxxaa+ +++a+ ++a+ +a+ a+ x",
         measures([](TwoBodies& w) { return w.world.signed_distance(w.a, w.b).distance; })},
        {"depth", "xxxxxxx xxxxxx +++xx ++xx +xx xx x",
         lists([](TwoBodies& w) { return w.world.depth(w.a, w.b).has_value(); }, 0)},
        {"depth_bounds", "xxxxxxx +++xxx ++xxx +xxx xxx xx x",
         lists([](TwoBodies& w) { return w.world.depth_bounds(w.a, w.b).has_value(); }, 0)},
        {"contact_patch", "xxxxxxx xxxxxx +++x+ ++x+ +x+ xx x",
         measures([](TwoBodies& w) { return w.world.contact_patch(w.a, w.b).distance; })},
        {"intersecting_triangles", "++++xxx +++xxx ++xxx +xxx xxx xx x",
         asks([](TwoBodies& w) { return w.world.intersecting_triangles(w.a, w.b); })},
        {"intersections", "++++xxx +++xxx ++xxx +xxx xxx xx x",
         asks([](TwoBodies& w) { return w.world.intersections(w.a, w.b); })},
        {"close_features", "++++xxx +++xxx ++xxx +xxx xxx xx x",
         asks([](TwoBodies& w) { return w.world.close_features(w.a, w.b, 1); })},
    };
}

std::vector<Row> everything() {
    return {
        // of            M       S      C     F    K   R  H
        // and           MSCFKRH SCFKRH CFKRH FKRH KRH RH H
        {"colliding_pairs, began", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         lists(
             [](TwoBodies& w) {
                 EXPECT_EQ(w.world.colliding_pairs().size(), w.world.began().size());
                 return w.world.colliding_pairs().size();
             },
             0)},
        {"set_clearance, close_pairs", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         lists(
             [](TwoBodies& w) {
                 w.world.set_clearance(1);
                 w.world.update();
                 return w.world.close_pairs().size();
             },
             1)},
        {"set_relations, relations", "+++++x+ ++++x+ +++x+ ++x+ +x+ x+ +",
         lists(
             [](TwoBodies& w) {
                 w.world.set_relations(true);
                 w.world.update();
                 return w.world.relations().size();
             },
             0)},
        {"intersecting_bodies", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         lists([](TwoBodies& w) { return w.world.intersecting_bodies(w.a).size(); }, 0)},
        {"nearest", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         lists([](TwoBodies& w) { return std::size_t{w.world.nearest(w.a, 1).has_value()}; }, 1)},
        {"closest_pair", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         lists([](TwoBodies& w) { return std::size_t{w.world.closest_pair(1).has_value()}; }, 1)},
        {"closest_pairs", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         lists([](TwoBodies& w) { return w.world.closest_pairs(1).size(); }, 1)},
        {"signed_distances", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         lists([](TwoBodies& w) { return w.world.signed_distances(1).size(); }, 1)},
        {"depths", "+++++++ ++++++ +++++ ++++ +++ ++ +", asks([](TwoBodies& w) { return w.world.depths(); })},
        {"contact_patches", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         asks([](TwoBodies& w) { return w.world.contact_patches(); })},
        {"certify", "+xxxxxx xxxxxx xxxxx xxxx xxx xx x", asks([](TwoBodies& w) { return w.world.certify(); })},
        {"trace_to", "+++++++ ++++++ +++++ ++++ +++ ++ +", asks([](TwoBodies& w) {
             std::ostringstream out;
             w.world.trace_to(out);
             w.world.end_trace();
             return out.str();
         })},
    };
}

std::vector<Row> motions() {
    const Turn quarter = {{1, 0, 0, 1}, {3, 7, 5}, {3, 7, 5}};
    return {
        // of            M       S      C     F    K   R  H
        // and           MSCFKRH SCFKRH CFKRH FKRH KRH RH H
        {"cast of a translation", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         casts([](TwoBodies& w, double by) { return time_of(w.world.cast(w.a, Vec3(by, 0, 0))); }, 0.5)},
        {"cast of a Straight, translated", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         casts([](TwoBodies& w,
                  double by) { return time_of(w.world.cast(w.a, Straight{moved(w.world.pose(w.a), Vec3(by, 0, 0))})); },
               0.5)},
        {"cast of a Straight, turned", "++++sxs +++sxs ++sxs +sss sss xs s",
         asks([](TwoBodies& w) { return w.world.cast(w.left, Straight{turned(w.world.pose(w.left))}); })},
        {"cast of a Turn", "++++xxx +++xxx ++xxx +xxx xxx xx x",
         asks([=](TwoBodies& w) { return w.world.cast(w.a, quarter); })},
        {"cast_to_distance", "++++++x +++++x ++++x +++x ++x +x x",
         casts([](TwoBodies& w, double by) { return time_of(w.world.cast_to_distance(w.a, Vec3(by, 0, 0), 0.5)); },
               0.25)},
        {"entering", "+xxxxxx ++xxxx +xxxx xxxx xxx xx x",
         asks([](TwoBodies& w) { return w.world.entering(w.a, Vec3(1, 0, 0)); })},
        {"meetings at poses, translated", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         casts(
             [](TwoBodies& w, double by) {
                 const std::vector<BodyId> listed{w.a};
                 return time_of(w.world.meetings(listed, std::vector<Pose>{moved(w.world.pose(w.a), Vec3(by, 0, 0))}));
             },
             0.5)},
        {"meetings at poses, turned", "++++sxs +++sxs ++sxs +sss sss xs s", asks([](TwoBodies& w) {
             const std::vector<BodyId> listed{w.left};
             return w.world.meetings(listed, std::vector<Pose>{turned(w.world.pose(w.left))});
         })},
        {"meetings of translations", "++++xxx +++xxx ++xxx +xxx xxx xx x",
         casts(
             [](TwoBodies& w, double by) {
                 const std::vector<BodyId> listed{w.a};
                 return time_of(w.world.meetings(listed, std::vector<Motion>{Translation{{by, 0, 0}}}));
             },
             0.5)},
        {"meetings of turns", "++++xxx +++xxx ++xxx +xxx xxx xx x", asks([=](TwoBodies& w) {
             const std::vector<BodyId> listed{w.a};
             return w.world.meetings(listed, std::vector<Motion>{quarter});
         })},
    };
}

TEST(KindsInAWorld, Pairs) {
    expect_table(pairs());
}

TEST(KindsInAWorld, Everything) {
    expect_table(everything());
}

TEST(KindsInAWorld, Motions) {
    expect_table(motions());
}

}  // namespace
}  // namespace ecods::kinds
