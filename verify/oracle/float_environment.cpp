#include "oracle/float_environment.hpp"

namespace ecods::oracle {

FloatEnvironment::FloatEnvironment() {
    std::fegetenv(&saved_);
    // The default environment, unlike a mere change of the rounding mode, also ends flush-to-zero.
    std::fesetenv(FE_DFL_ENV);
    std::fesetround(FE_UPWARD);
}

FloatEnvironment::~FloatEnvironment() {
    std::fesetenv(&saved_);
}

}  // namespace ecods::oracle
