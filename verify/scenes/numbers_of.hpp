// Ids without the number of their world: two worlds that were given the same calls then give the same ids.
#pragma once

#include <span>
#include <vector>

#include "ecods/ids.hpp"

namespace ecods {

inline BodyId numbers_of(BodyId body) {
    return {body.slot, body.generation};
}

inline std::vector<BodyId> numbers_of(std::span<const BodyId> bodies) {
    std::vector<BodyId> numbers;
    for (const BodyId body : bodies) numbers.push_back(numbers_of(body));
    return numbers;
}

inline std::vector<BodyPair> numbers_of(std::span<const BodyPair> pairs) {
    std::vector<BodyPair> numbers;
    for (const BodyPair& pair : pairs) numbers.push_back({numbers_of(pair.a), numbers_of(pair.b)});
    return numbers;
}

}  // namespace ecods
