# The tests that verify/run leaves to verify/run --all, and why: they take long themselves or need what takes long to build,
# and are seldom the only ones to see a fault. A row is a reason and names of tests, where * stands for anything; of the
# cases of a program of GoogleTest, PROGRAM.FILTER, and PROGRAM.* is a program that verify/run does not build.
# usage: ecods_long(REASON NAMES...)
set_property(GLOBAL PROPERTY ECODS_LONG_TESTS "")
file(WRITE ${PROJECT_BINARY_DIR}/long_tests.txt "")
function(ecods_long reason)
  set_property(GLOBAL APPEND PROPERTY ECODS_LONG_TESTS ${ARGN})
  foreach(name ${ARGN})
    file(APPEND ${PROJECT_BINARY_DIR}/long_tests.txt "${name}\t${reason}\n")
  endforeach()
endfunction()

# usage: ecods_is_long(NAME RESULT)
function(ecods_is_long name result)
  set(${result} FALSE PARENT_SCOPE)
  get_property(rows GLOBAL PROPERTY ECODS_LONG_TESTS)
  foreach(row IN LISTS rows)
    string(REPLACE "." "[.]" pattern "${row}")
    string(REPLACE "*" ".*" pattern "${pattern}")
    if(name MATCHES "^${pattern}$")
      set(${result} TRUE PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# The filter of GoogleTest for the cases of a program that are long; * for all, nothing for none.
# usage: ecods_long_cases(PROGRAM RESULT)
function(ecods_long_cases program result)
  get_property(rows GLOBAL PROPERTY ECODS_LONG_TESTS)
  list(FILTER rows INCLUDE REGEX "^${program}[.]")
  list(TRANSFORM rows REPLACE "^${program}[.]" "")
  if("*" IN_LIST rows)
    set(rows "*")
  endif()
  list(JOIN rows ":" filter)
  set(${result} "${filter}" PARENT_SCOPE)
endfunction()

ecods_long("other engines, which take a third of the build" bench.* bench_test.* fuzz.engine* fuzz_engine_tests.*
           instruction_sets.unknown.ecods_bench instruction_sets.unknown.ecods_micro)
ecods_long("the Python module, with packages of its own" python.*)
ecods_long("the exact layer is built three times for it" environment)
ecods_long("the library is built again for it: with the thread sanitizer, and without optimization" threads unoptimized)
ecods_long("Gappa and Coq prove again what only a change of a constant changes" proofs)
ecods_long("Doxygen, Chromium and clang-tidy read what the other tests compile or read, too" reference
           tidy.clang_tidy_headers)
ecods_long("the project is installed, used and configured anew in many ways" consumer.*)
ecods_long("seventeen programs to build, and what they ask of the library has tests of its own" examples.*
           output.ecods_clash_of_assembly.* output.ecods_first_program.* output.ecods_how_do_i.*
           output.ecods_no_tunnelling.* output.ecods_own_engine.* output.ecods_own_shape.* output.ecods_picking.*
           output.ecods_plane_figures.* output.ecods_ported* output.ecods_robot_arm.* output.ecods_thousand_ships.*
           output.ecods_thread_pool.*)
ecods_long("the clash report, which takes a twelfth of the build, and asks the library what other tests ask" clash.*
           clash_test.* output.ecods_clash.* output.ecods_clash_building.*)
ecods_long("the oracle beside models of its own" oracle_test.*)
ecods_long("CGAL's own side of a mesh, which takes long to compile" side_of_mesh_tests.*)
ecods_long("every pair of triangles of a lattice; no planted fault is seen by it alone" exhaustive_tests.*)
ecods_long("the checkers of certificates, which share nothing with the library, asked about many that are spoilt"
           certificates.costly certificates.tampered certificates.false_claims certificates.malformed certificates.python_cases)
ecods_long("many runs of what other tests run a few times" fuzz.motion fuzz.more_convex fuzz.more_distances
           fuzz.more_pairs fuzz.more_solids fuzz.kinds fuzz.solids_of_rounded_points
           fuzz_tests.FuzzProgramTest.JobsDoNotMatter solid_families_tests.SolidFamilies.AsTheOracle)
ecods_long("the scripts that plant faults, which only those need who plant them" fuzz.mutants_tools)
ecods_long("eleven programs to build, whose corpora ask the library what other tests ask" fuzz.corpus.*
           instruction_sets.unknown.fuzz_triangles output.fuzz_predicates.*)
ecods_long("each allocation of each call fails in turn; verify/run has that for an update with one broad phase"
           allocation_tests.QueryOutOfMemory.EveryQuestion* allocation_tests.BroadPhases/WorldOutOfMemory.*
           allocation_tests.BroadPhases/UpdateOutOfMemory.*/1 allocation_tests.BroadPhases/UpdateOutOfMemory.*/2
           allocation_tests.BroadPhases/UpdateOutOfMemory.*/3 allocation_tests.BroadPhases/UpdateOutOfMemory.*/4
           allocation_tests.BroadPhases/UpdateOutOfMemory.*/5
           allocation_tests.BroadPhases/UpdateOutOfMemory.*/6 allocation_tests.BroadPhases/UpdateOutOfMemory.*/7)
