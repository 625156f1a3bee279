// An answer that is not the true one.
#pragma once

#include <string>

namespace ecods::judge {

struct Wrong {
    std::string question;
    std::string expected;
    std::string got;
};

}  // namespace ecods::judge
