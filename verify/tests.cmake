# How tests are declared, and their labels, which say which runs take them:
#   library   what users get is asked in it: the sanitizers, verify/aarch64 and verify/coverage run it. Every test has this
#             label, or a reason why not, and then the label other.
#   programs  it runs other programs: those for another processor have no emulator then
#   threads   it has threads of its own: the thread sanitizer watches it
#   long      verify/run leaves it to verify/run --all (long_tests.cmake has which, and why)
# Targets of the same names build what such tests need: tests_library, tests_threads, tests_portable (of the library, without
# other programs, and not long) and tests_short. verify/labels checks that no test is left out.
include(GoogleTest)
include(${CMAKE_CURRENT_LIST_DIR}/long_tests.cmake)

# The labels that come of a declaration. usage: ecods_labels(RESULT REASON_NOT_LIBRARY LABELS...)
function(ecods_labels result not_library)
  if(not_library)
    set(labels other ${ARGN})
  else()
    set(labels library ${ARGN})
  endif()
  set(${result} ${labels} PARENT_SCOPE)
endfunction()

# The targets are built for each of the runs that take a test with these labels. usage: ecods_needs("LABELS" TARGETS...)
function(ecods_needs labels)
  if(NOT "long" IN_LIST labels)
    set_property(GLOBAL APPEND PROPERTY ECODS_NEEDS_OF_short ${ARGN})
  endif()
  if("library" IN_LIST labels)
    set_property(GLOBAL APPEND PROPERTY ECODS_NEEDS_OF_library ${ARGN})
    if(NOT "long" IN_LIST labels AND NOT "programs" IN_LIST labels)
      set_property(GLOBAL APPEND PROPERTY ECODS_NEEDS_OF_portable ${ARGN})
    endif()
  endif()
  if("threads" IN_LIST labels)
    set_property(GLOBAL APPEND PROPERTY ECODS_NEEDS_OF_threads ${ARGN})
  endif()
endfunction()

# The targets tests_... of above; at the very end, when all targets are known.
function(ecods_make_test_targets)
  foreach(run short library portable threads)
    get_property(needs GLOBAL PROPERTY ECODS_NEEDS_OF_${run})
    list(REMOVE_DUPLICATES needs)
    add_custom_target(tests_${run})
    foreach(target IN LISTS needs)
      if(TARGET ${target})
        add_dependencies(tests_${run} ${target})
      endif()
    endforeach()
  endforeach()
endfunction()

# Adds a test as add_test() does, with its labels. Targets that the command names are built for it, and those that it NEEDS
# beside them.
# usage: ecods_add_test(NAME NAME COMMAND COMMAND... [NEEDS TARGETS...] [LABELS programs|threads] [NOT_LIBRARY REASON]
#                       [WORKING_DIRECTORY FOLDER])
function(ecods_add_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;NOT_LIBRARY;WORKING_DIRECTORY" "COMMAND;LABELS;NEEDS")
  set(folder "")
  if(arg_WORKING_DIRECTORY)
    set(folder WORKING_DIRECTORY ${arg_WORKING_DIRECTORY})
  endif()
  add_test(NAME ${arg_NAME} COMMAND ${arg_COMMAND} ${folder})

  list(GET arg_COMMAND 0 program)
  if(program MATCHES "/")  # no target of the project: a script, which runs others
    list(APPEND arg_LABELS programs)
  else()
    list(APPEND arg_NEEDS ${program})
  endif()
  string(REGEX MATCHALL "TARGET_FILE:[A-Za-z0-9_]+" files "${arg_COMMAND}")
  list(TRANSFORM files REPLACE "^TARGET_FILE:" "")
  ecods_labels(labels "${arg_NOT_LIBRARY}" ${arg_LABELS})
  ecods_is_long(${arg_NAME} is_long)
  if(is_long)
    list(APPEND labels long)
  endif()
  set_tests_properties(${arg_NAME} PROPERTIES LABELS "${labels}")
  ecods_needs("${labels}" ${arg_NEEDS} ${files})
endfunction()

# The cases of a program that the filter lets through become tests with these labels.
# usage: ecods_discover(NAME KIND "FILTER" LABELS...)     KIND: a word of its own for each call
function(ecods_discover name kind filter)
  gtest_discover_tests(${name} TEST_PREFIX ${name}. TEST_FILTER "${filter}" TEST_LIST ${name}_${kind} DISCOVERY_TIMEOUT 60
                       NO_PRETTY_VALUES)  # the names that a filter takes
  # More than one label is lost on the way through gtest_discover_tests.
  set(file ${CMAKE_CURRENT_BINARY_DIR}/${name}_${kind}.cmake)
  file(CONFIGURE OUTPUT ${file} @ONLY CONTENT [=[
if(@name@_@kind@)
  set_tests_properties(${@name@_@kind@} PROPERTIES LABELS "@ARGN@")
endif()
]=])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${file})
endfunction()

# One test program; the files APART are compiled alone (ecods_unity): files that share names have namespaces of their own
# instead, where they can. OPTIMIZED: whose time is its own code's. Its tests are of the library, unless a reason says why not.
# usage: ecods_test(NAME SOURCES... [OPTIMIZED] [APART ...] [LIBRARIES ...] [LABELS programs|threads] [NOT_LIBRARY REASON])
function(ecods_test name)
  cmake_parse_arguments(arg "OPTIMIZED" "NOT_LIBRARY" "APART;LABELS;LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE ecods ecods_flags ecods_test_main GTest::gtest ${arg_LIBRARIES})
  # Unit tests see the layers from inside.
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/verify)
  if(NOT arg_OPTIMIZED)
    target_compile_options(${name} PRIVATE ${ecods_caller_options})
    ecods_share_precompiled(${name} ecods_test_main)
  endif()
  ecods_unity(${name} APART ${arg_APART})

  ecods_labels(labels "${arg_NOT_LIBRARY}" ${arg_LABELS})
  ecods_long_cases(${name} long)
  if(long STREQUAL "*")
    ecods_discover(${name} long "*" ${labels} long)
    ecods_needs("${labels};long" ${name})
    return()
  endif()
  ecods_needs("${labels}" ${name})
  if(long)
    ecods_discover(${name} long "${long}" ${labels} long)
    ecods_discover(${name} short "-${long}" ${labels})
  else()
    ecods_discover(${name} short "*" ${labels})
  endif()
endfunction()
