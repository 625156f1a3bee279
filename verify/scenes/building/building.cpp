#include "scenes/building/building.hpp"

#include <cstdio>

namespace ecods::scenes {
namespace {

constexpr Length meter = 10000;
constexpr Length cm = 100;

// Makes the elements of one bay of one storey; all positions are relative to it, in centimeters where nothing else is
// said.
class Bay {
  public:
    Bay(std::vector<Element>& elements, std::array<int, 3> place) : elements_(elements) {
        origin_ = {place[0] * 6 * meter, place[1] * 5 * meter, place[2] * 3 * meter};
        std::array<char, 40> text{};
        std::snprintf(text.data(), text.size(), "S%02d B%02d-%02d ", place[2], place[0], place[1]);
        prefix_ = text.data();
    }

    // The figure's grid, all of it filled; empty cells are then cut out.
    Element& grid(const char* name, int axis, Length lo, Length hi, const std::vector<Length>& us,
                  const std::vector<Length>& vs) {
        Element& element = add(name, axis, lo, hi);
        for (const Length u : us) element.us.push_back(shifted(u * cm, (axis + 1) % 3));
        for (const Length v : vs) element.vs.push_back(shifted(v * cm, (axis + 2) % 3));
        element.filled.assign((us.size() - 1) * (vs.size() - 1), 1);
        return element;
    }

    Element& box(const char* name, std::array<Length, 3> min, std::array<Length, 3> max) {
        return grid(name, 2, min[2], max[2], {min[0], max[0]}, {min[1], max[1]});
    }

    Element& pipe(const char* name, int axis, Length lo, Length hi, Length u, Length v, Length radius) {
        Element& element = add(name, axis, lo, hi);
        element.u = shifted(u * cm, (axis + 1) % 3);
        element.v = shifted(v * cm, (axis + 2) % 3);
        element.radius = radius * cm;
        return element;
    }

  private:
    Element& add(const char* name, int axis, Length lo, Length hi) {
        Element& element = elements_.emplace_back();
        element.name = prefix_ + name;
        element.axis = axis;
        element.lo = shifted(lo * cm, axis);
        element.hi = shifted(hi * cm, axis);
        return element;
    }

    Length shifted(Length length, int axis) const { return origin_[static_cast<std::size_t>(axis)] + length; }

    std::vector<Element>& elements_;
    std::array<Length, 3> origin_{};
    std::string prefix_;
};

// Walls share the profile from 10 to 30 cm. Wall A and wall B overlap by 50 mm, flush on four sides.
void add_structure(Bay& bay) {
    bay.box("slab", {0, 0, -20}, {600, 500, 0});
    Element& column = bay.grid("column", 2, 0, 280, {0, 5, 35, 40}, {0, 18, 22, 40});
    column.filled = {1, 0, 1, 1, 1, 1, 1, 0, 1};
    Element& door_wall = bay.grid("wall A", 1, 10, 30, {0, 210, 280}, {40, 80, 170, 305});
    door_wall.filled = {1, 1, 0, 1, 1, 1};
    bay.box("wall B", {300, 10, 0}, {600, 30, 280});
    Element& window_wall = bay.grid("wall C", 0, 10, 30, {40, 200, 280, 500}, {0, 100, 200, 280});
    window_wall.filled = {1, 1, 1, 1, 0, 1, 1, 1, 1};
}

void add_furniture(Bay& bay) {
    Element& near = bay.box("cabinet 0.1 mm from the wall", {30, 60, 0}, {90, 110, 90});
    near.us[0] += 1;
    bay.box("cabinet at the wall", {30, 110, 0}, {90, 170, 90});
    bay.box("cabinet 50 mm in the wall", {25, 420, 0}, {90, 490, 90});
    for (const bool is_copy : {false, true}) {
        Element& chair = bay.grid(is_copy ? "chair copy" : "chair", 1, 250, 300, {0, 45, 90}, {250, 255, 300});
        chair.filled = {1, 1, 1, 0};
        chair.is_cut_otherwise = is_copy;
    }
}

void add_pipes(Bay& bay) {
    bay.pipe("conduit in the wall, flush", 2, 0, 280, 20, 320, 2);
    bay.pipe("wire in the wall", 2, 50, 150, 20, 340, 2);
    bay.pipe("pipe through the wall", 1, 2, 300, 230, 450, 5);
    Element& beside = bay.pipe("pipe 0.1 mm from the wall", 0, 310, 590, 35, 150, 5);
    beside.u += 1;
    bay.pipe("pipe at the wall", 0, 310, 450, 35, 120, 5);
    bay.pipe("pipe at the wall, continued", 0, 450, 590, 35, 120, 5);
    bay.pipe("riser", 2, 10, 270, 400, 200, 5);
    bay.pipe("pipe through the riser", 1, 100, 400, 100, 400, 5);
    bay.box("duct through the wall", {2, 350, 230}, {500, 400, 260});
}

// The radiator is a comb of 16 fins. The valve stands between the first two, 0.1 mm from one of them.
void add_radiator(Bay& bay) {
    std::vector<Length> us;
    for (Length i = 0; i < 32; ++i) us.push_back(190 + 3 * i);
    Element& radiator = bay.grid("radiator", 2, 20, 120, us, {35, 37, 45});
    const std::size_t width = us.size() - 1;
    for (std::size_t i = 1; i < width; i += 2) radiator.filled[width + i] = 0;
    Element& valve = bay.box("valve between fins", {193, 38, 60}, {195, 44, 65});
    valve.us[0] += 1;
}

// What bounds no solid.
void add_surfaces(Bay& bay, bool has_crate) {
    const auto lampshade = [&](const char* name) {
        bay.box(name, {200, 200, 250}, {240, 240, 280}).defect = Defect::open;
    };
    lampshade("lampshade");
    bay.box("tray partly in the wall", {20, 285, 110}, {50, 310, 130}).defect = Defect::open;
    bay.box("drawer in the cabinet", {40, 120, 10}, {80, 160, 30}).defect = Defect::open;
    if (has_crate) {
        bay.box("crate", {480, 120, 0}, {520, 160, 40}).defect = Defect::doubled;
    } else {
        lampshade("lampshade copy");
    }
}

}  // namespace

std::vector<Element> make_building(int bays_x, int bays_y, int storeys) {
    std::vector<Element> elements;
    for (int z = 0; z < storeys; ++z) {
        for (int y = 0; y < bays_y; ++y) {
            for (int x = 0; x < bays_x; ++x) {
                Bay bay(elements, {x, y, z});
                add_structure(bay);
                add_furniture(bay);
                add_pipes(bay);
                add_radiator(bay);
                add_surfaces(bay, (x + y + z) % 2 == 0);
            }
        }
    }
    return elements;
}

}  // namespace ecods::scenes
