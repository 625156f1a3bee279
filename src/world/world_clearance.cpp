#include "base/limits.hpp"
#include "world/world_impl.hpp"

namespace ecods {

void World::set_clearance(std::optional<double> clearance) {
    Impl& w = impl();
    if (clearance) {
        require_finite_distance(*clearance);
        if (key_of(*clearance) == 0) clearance = 0;  // turns -0 into +0; == could take a subnormal number for 0
        w.require_answers(Question::within);
    }
    if (is_same_clearance(clearance, w.closeness.wanted())) return;
    w.closeness.set(clearance);
    if (w.trace) w.trace->write<calls::SetClearance>(clearance);
}

std::optional<double> World::clearance() const {
    return impl().closeness.wanted();
}

std::span<const BodyPair> World::close_pairs() const {
    return impl().closeness.pairs().positive();
}
std::span<const BodyPair> World::close_began() const {
    return impl().closeness.pairs().began();
}
std::span<const BodyPair> World::close_ended() const {
    return impl().closeness.pairs().ended();
}

}  // namespace ecods
