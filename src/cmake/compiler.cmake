# What the library asks of a compiler and of its flags. src/base/arithmetic.hpp asks again, for builds without CMake.
include(CheckCXXSourceCompiles)

# Flags that license the compiler to change the signs that the filter's proof is about, wherever they were given.
get_directory_property(ecods_flags_given COMPILE_OPTIONS)
string(APPEND ecods_flags_given " ${CMAKE_CXX_FLAGS}")
foreach(config ${CMAKE_BUILD_TYPE} ${CMAKE_CONFIGURATION_TYPES})
  string(TOUPPER ${config} config)
  string(APPEND ecods_flags_given " ${CMAKE_CXX_FLAGS_${config}}")
endforeach()
if(ecods_flags_given MATCHES
   "-Ofast|-ffast-math|-ffp-model=fast|-funsafe-math|-fassociative-math|-freciprocal-math|-ffinite-math-only")
  message(FATAL_ERROR "ECoDS cannot be built with ${CMAKE_MATCH_0}: it licenses the compiler to change the signs that the "
                      "filter's proof is about.")
endif()

set(CMAKE_REQUIRED_QUIET ON)
# The vector by reference: clang refuses to hand one over that the caller's instructions cannot hold.
check_cxx_source_compiles("
  __extension__ typedef unsigned __int128 Wide;
  typedef double Lanes __attribute__((vector_size(32)));
  #if defined(__x86_64__)
  [[gnu::target(\"avx512f\")]]
  #endif
  Wide twice(const Lanes& lanes) { return static_cast<Wide>(lanes[0]) * 2; }
  int main() { return static_cast<int>(twice(Lanes{})); }" ECODS_HAS_GNU_EXTENSIONS)
unset(CMAKE_REQUIRED_QUIET)
if(NOT ECODS_HAS_GNU_EXTENSIONS)
  message(FATAL_ERROR "ECoDS needs the GNU extensions of g++ and clang (__int128, vectors, functions for an instruction set) "
                      "on a 64-bit processor; ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} does not have them.")
endif()
