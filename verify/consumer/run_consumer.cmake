# One step of the consumer tests. usage: cmake -D STEP=install|cmake|pkg_config -D ... -P run_consumer.cmake
cmake_minimum_required(VERSION 3.25)

set(prefix ${WORK_DIR}/prefix)

function(run)
  list(JOIN ARGN " " command)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${command}\n${output}${errors}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(run_and_check program)
  run(${program})
  file(READ ${CMAKE_CURRENT_LIST_DIR}/expected.txt expected)
  if(NOT output STREQUAL expected)
    message(FATAL_ERROR "expected:\n${expected}got:\n${output}")
  endif()
endfunction()

# A library that is built with a sanitizer needs it in the programs that link it.
set(flags "")
if(SANITIZE)
  set(flags -fsanitize=${SANITIZE})
endif()

if(STEP STREQUAL "install")
  file(REMOVE_RECURSE ${prefix})
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix} --config ${CONFIG})
elseif(STEP STREQUAL "cmake")
  file(REMOVE_RECURSE ${WORK_DIR}/build)
  run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/project -B ${WORK_DIR}/build -G ${GENERATOR}
      -D CMAKE_BUILD_TYPE=${CONFIG} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${flags}
      -D CMAKE_PREFIX_PATH=${prefix} -D EXPECTED_PREFIX=${prefix})
  run(${CMAKE_COMMAND} --build ${WORK_DIR}/build --config ${CONFIG})
  run_and_check(${WORK_DIR}/build/consumer)
elseif(STEP STREQUAL "pkg_config")
  # The file may name the prefix that was configured; this installation is elsewhere.
  set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBDIR}/pkgconfig)
  run(${PKG_CONFIG} --define-prefix --cflags --libs ecods)
  string(STRIP "${output}" output)
  separate_arguments(options UNIX_COMMAND "${output}")
  if(NOT "-I${prefix}/include" IN_LIST options)
    message(FATAL_ERROR "the options do not name the installed headers: ${output}")
  endif()
  run(${COMPILER} -std=c++20 ${flags} ${CMAKE_CURRENT_LIST_DIR}/project/main.cpp -o ${WORK_DIR}/by_pkg_config
      ${options} -Wl,-rpath,${prefix}/${LIBDIR})
  run_and_check(${WORK_DIR}/by_pkg_config)
else()
  message(FATAL_ERROR "unknown step: ${STEP}")
endif()
