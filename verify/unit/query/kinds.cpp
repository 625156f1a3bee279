#include "unit/query/kinds.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "scenes/shapes.hpp"

namespace ecods::kinds {
namespace {

using ShapePtr = std::shared_ptr<const Shape>;

std::shared_ptr<const Mesh> one_triangle(const Vec3& p, const Vec3& q, const Vec3& r) {
    return Mesh::create({p, q, r}, {Triangle{0, 1, 2}});
}

// A cube with a notch in its top, which does not reach the sides: no convex body, and of its greatest x in a face.
std::shared_ptr<const Mesh> notched() {
    std::vector<Vec3> corners;
    const double x[4] = {-1, -0.25, 0.25, 1};
    for (const double y : {-1.0, 1.0}) {
        for (const Vec3& p : {Vec3(x[0], y, -1), Vec3(x[3], y, -1), Vec3(x[3], y, 1), Vec3(x[2], y, 1), Vec3(0, y, 0.5),
                              Vec3(x[1], y, 1), Vec3(x[0], y, 1)}) {
            corners.push_back(p);
        }
    }
    std::vector<Triangle> triangles;
    for (const Triangle& t :
         {Triangle{0, 1, 4}, Triangle{1, 2, 4}, Triangle{2, 3, 4}, Triangle{0, 4, 6}, Triangle{4, 5, 6}}) {
        triangles.push_back(t);
        triangles.push_back({t[0] + 7, t[2] + 7, t[1] + 7});
    }
    for (std::uint32_t i = 0; i < 7; ++i) {
        const std::uint32_t next = (i + 1) % 7;
        triangles.push_back({i, i + 7, next});
        triangles.push_back({next, i + 7, next + 7});
    }
    return Mesh::create(std::move(corners), std::move(triangles));
}

ShapePtr convex(const std::vector<Vec3>& points) {
    return std::make_shared<const ConvexSolid>(points);
}

}  // namespace

std::vector<Body> bodies_at(Place place, double gap) {
    const double x = place == Place::left ? 1 : -1;  // of the extreme point
    Pose pose;
    pose.t[0] = place == Place::left ? 0 : 2 + gap;
    const auto surface = [](const std::shared_ptr<const Mesh>& mesh) {
        return std::make_shared<const MeshShape>(mesh);
    };
    const auto half = std::make_shared<const ConvexSolid>(scenes::cube(0.5));
    std::vector<Body> bodies = {
        {'M', "surface", surface(scenes::cube(1)), pose},
        {'M', "cloud", point_cloud(std::vector<Vec3>{{0, 0.5, 0.5}, {x, 0, 0}, {0, 0, 0}}), pose},
        {'S', "solid", std::make_shared<const Solid>(notched()), pose},
        {'C', "convex", std::make_shared<const ConvexSolid>(scenes::cube(1)), pose},
        {'F', "polygon", convex({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}), pose},
        {'F', "segment", convex({{0, 0, 0}, {x, 0, 0}}), pose},
        {'F', "point", convex({{x, 0, 0}}), pose},
        {'K', "sphere", sphere(0.5, {x / 2, 0, 0}), pose},
        {'K', "capsule", capsule({-x / 2, 0, 0}, {x / 2, 0, 0}, 0.5), pose},
        {'K', "rounded convex", rounded(half, 0.5), pose},
        {'K', "rounded triangle", rounded(surface(one_triangle({x / 2, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5})), 0.5), pose},
        {'R', "rounded surface", rounded(surface(scenes::cube(0.5)), 0.5), pose},
        {'H', "half space", std::make_shared<const HalfSpace>(Vec3(x, 0, 0), 1.0), pose},
    };
    // A height field from x = 0 or x = -1 on; a solid of half the size, rounded.
    Pose beside = pose;
    beside.t += Vec3(x < 0 ? -1 : 0, -1, 0);
    bodies.insert(bodies.begin() + 2,
                  {'M', "height field", height_field(std::vector<double>(6, 0.0), 2, Vec2(1, 1)), beside});
    Pose smaller = pose;
    smaller.R *= 0.5;
    bodies.insert(bodies.end() - 1,
                  {'R', "rounded solid", rounded(std::make_shared<const Solid>(notched()), 0.5), smaller});
    return bodies;
}

namespace {

// Outcomes says how one question about two kinds ended (answered, NotSupported or no such function), for pairs that are
// apart and for pairs that meet.
struct Outcomes {
    void add(char outcome, bool is_apart) { (is_apart ? apart : meeting).insert(outcome); }
    char cell() const {
        std::set<char> all = apart;
        all.insert(meeting.begin(), meeting.end());
        if (all.size() == 1) return *all.begin();
        if (all.contains('-')) return '?';
        return apart == std::set{'+'} ? 'a' : 's';
    }

    std::set<char> apart, meeting;
};

// Returns how the question is answered: + answered, x NotSupported, - no such function.
template <class Ask>
char outcome_of(const Ask& ask) {
    try {
        ask();
        return '+';
    } catch (const NotSupported&) {
        return 'x';
    } catch (const NoSuchFunction&) {
        return '-';
    }
}

std::size_t letter_index(char letter) {
    return letters.find(letter);
}

std::string without_blanks(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c != ' ') result += c;
    }
    return result;
}

// Returns a row of cells as the tables have it.
std::string row_text(const std::map<std::pair<std::size_t, std::size_t>, char>& cells) {
    std::string text;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        if (i > 0) text += ' ';
        for (std::size_t j = i; j < letters.size(); ++j) {
            const auto found = cells.find({i, j});
            text += found == cells.end() ? '?' : found->second;
        }
    }
    return text;
}

}  // namespace

void expect_table(const std::vector<Row>& rows) {
    std::vector<std::map<std::pair<std::size_t, std::size_t>, Outcomes>> outcomes(rows.size());
    for (const double gap : {1.0, 0.0, -0.25, -1.0}) {
        const std::vector<Body> left = bodies_at(Place::left, gap), right = bodies_at(Place::right, gap);
        for (const Body& a : left) {
            for (const Body& b : right) {
                const std::pair<std::size_t, std::size_t> key =
                    std::minmax(letter_index(a.letter), letter_index(b.letter));
                for (std::size_t i = 0; i < rows.size(); ++i) {
                    const std::string where =
                        std::string(rows[i].name) + ", " + a.name + ", " + b.name + ", gap " + std::to_string(gap);
                    SCOPED_TRACE(where);
                    const char there = outcome_of([&] { rows[i].ask({a, b, gap, false}); });
                    const char back = outcome_of([&] { rows[i].ask({b, a, gap, true}); });
                    EXPECT_EQ(there, back) << "in the two orders of the bodies";
                    for (const char outcome : {there, back}) {
                        outcomes[i][key].add(outcome, gap > 0);
                    }
                }
            }
        }
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::map<std::pair<std::size_t, std::size_t>, char> cells;
        for (const auto& [key, found] : outcomes[i]) cells[key] = found.cell();
        const std::string row = row_text(cells);
        EXPECT_EQ(without_blanks(rows[i].cells), without_blanks(row)) << rows[i].name << " is\n" << row;
    }
}

void expect_table_of_one(const std::vector<RowOfOne>& rows) {
    for (const RowOfOne& row : rows) {
        std::string cells(letters.size(), ' ');
        for (const Body& body : bodies_at(Place::left, 0)) {
            SCOPED_TRACE(std::string(row.name) + ", " + body.name);
            char& cell = cells[letter_index(body.letter)];
            const char outcome = outcome_of([&] { row.ask(body); });
            cell = cell == ' ' || cell == outcome ? outcome : '?';
        }
        EXPECT_EQ(row.cells, cells) << row.name;
    }
}

}  // namespace ecods::kinds
