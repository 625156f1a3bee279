// A floating-point environment for the library to be called in.
#pragma once

#include <array>
#include <cfenv>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace ecods::environment {

struct FloatMode {
    const char* name;
    int rounding;
    bool flush;  // subnormal results and operands are taken for zero, where the processor can do so
};

// The first one is that of every program as it starts.
inline constexpr std::array<FloatMode, 8> float_modes{{{"to nearest", FE_TONEAREST, false},
                                                       {"upward", FE_UPWARD, false},
                                                       {"downward", FE_DOWNWARD, false},
                                                       {"toward zero", FE_TOWARDZERO, false},
                                                       {"to nearest, flush to zero", FE_TONEAREST, true},
                                                       {"upward, flush to zero", FE_UPWARD, true},
                                                       {"downward, flush to zero", FE_DOWNWARD, true},
                                                       {"toward zero, flush to zero", FE_TOWARDZERO, true}}};

// While it lives the mode is set; afterwards the environment is as it was.
class InFloatMode {
  public:
    explicit InFloatMode(const FloatMode& mode) {
        std::fegetenv(&saved_);
        std::fesetround(mode.rounding);
#if defined(__SSE2__)
        constexpr unsigned flush_and_denormals_are_zero = 0x8040;
        if (mode.flush) _mm_setcsr(_mm_getcsr() | flush_and_denormals_are_zero);
#endif
    }
    ~InFloatMode() {
        std::fesetenv(&saved_);
    }
    InFloatMode(const InFloatMode&) = delete;
    InFloatMode& operator=(const InFloatMode&) = delete;

  private:
    std::fenv_t saved_;
};

}  // namespace ecods::environment
