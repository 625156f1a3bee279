# Programs that print digests of the exact layer's answers, each of the layer's own sources with options of its own.

# Selects the sources of the exact layer and of the questions about two triangles from those of the library.
# usage: ecods_exact_layer(RESULT SOURCES...)
function(ecods_exact_layer result)
  set(sources ${ARGN})
  list(FILTER sources INCLUDE REGEX
       "^(base/(error|ids|number_text)|geometry/(mesh|pose|scaled_line)|exact/.*|simd/.*|\
query/(intersection/(plane_signs|triangle_relations)|distance/triangle_.*|hit/triangle_hits|cast/triangle_contacts))\\.cpp$")
  set(${result} ${sources} PARENT_SCOPE)
endfunction()

# usage: ecods_digest(NAME ROOT SOURCES OPTIONS...)     sources as above: paths in src
function(ecods_digest name root sources)
  list(TRANSFORM sources PREPEND ${root}/src/)
  add_executable(${name} ${sources} ${root}/verify/environment/digest_main.cpp ${root}/verify/environment/digest_ways.cpp
                         ${root}/verify/process/standard_output.cpp)
  target_include_directories(${name} PRIVATE ${root}/include ${root}/src ${root}/verify)
  target_compile_features(${name} PRIVATE cxx_std_20)
  # Assertions of its own are on in every build, and warnings are the library's own build's to give.
  target_compile_options(${name} PRIVATE -UNDEBUG -Wno-psabi ${ARGN})
  target_link_libraries(${name} PRIVATE Eigen3::Eigen)
  target_precompile_headers(${name} PRIVATE <array> <vector> <Eigen/Geometry>)
  ecods_unity(${name})
endfunction()
