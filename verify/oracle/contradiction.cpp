#include <cmath>

#include "oracle/float_environment.hpp"
#include "oracle/turn_subdivision.hpp"

namespace ecods::oracle {

std::optional<std::string> contradiction(const TurningSoup& a, const Soup& b,
                                         const std::optional<ExactContact>& contact) {
    const FloatEnvironment environment;
    return contradiction(TurnSubdivision(a, b), contact);
}

std::optional<std::string> contradiction(const TurnSubdivision& pieces, const std::optional<ExactContact>& contact) {
    const FloatEnvironment environment;
    if (!contact) return pieces.are_apart(0, 1, 110) ? std::nullopt : std::optional("not proven apart to the end");
    const double time = contact->rounded;
    if (time == 0) return pieces.meet(0) ? std::nullopt : std::optional("apart at the start");
    // Numbers on either side of the time that are nearer than the neighbours of the rounded one.
    const mpq_class rounded(time), ulp = rounded - mpq_class(std::nextafter(time, 0));
    mpq_class before = rounded - ulp / 2, after = rounded + ulp;
    if (contact->time.compare(before) <= 0) return std::nullopt;  // rounded up to the least double
    for (int i = 0; i < 8; ++i) {
        const mpq_class middle = (before + after) / 2;
        (contact->time.compare(middle) > 0 ? before : after) = middle;
    }
    if (contact->time.is_exact()) after = contact->time.low();
    if (!pieces.are_apart(0, before, 110 - std::ilogb(time))) return "not proven apart up to " + before.get_str();
    if (contact->time.compare(after) == 0 && !pieces.meet(after)) return "apart at " + after.get_str();
    if (pieces.are_apart(before, after, 20)) return "apart from " + before.get_str() + " on";
    return std::nullopt;
}

}  // namespace ecods::oracle
