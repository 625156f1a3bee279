#include "base/double_key.hpp"
#include "geometry/find_invalid.hpp"
#include "world/world_impl.hpp"

namespace ecods {

void World::set_clearance(std::optional<double> clearance) {
    Impl& w = impl();
    if (clearance) {
        if (!is_from_zero(*clearance) || !is_finite(*clearance)) throw InvalidDistance(*clearance);
        // By the key: no subnormal number is 0, whatever the processor takes it for.
        if (key_of(*clearance) == 0) clearance = 0;  // and not -0
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
