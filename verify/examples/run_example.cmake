# Runs an example, and compares what it prints, but for numbers that are not promised: bounds of depths.
# usage: cmake -D PROGRAM=... -D PICTURE=... -D EXPECTED=... -P run_example.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE ${PICTURE})
execute_process(COMMAND ${PROGRAM} ${PICTURE} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "failed (${result}): ${PROGRAM}\n${output}${errors}")
endif()
string(REGEX REPLACE "  depth from [0-9.]+ to [0-9.]+: parted at [^\n]*\n" "  depth from LOWER to UPPER\n" output "${output}")
file(READ ${EXPECTED} expected)
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "expected:\n${expected}got:\n${output}")
endif()
file(READ ${PICTURE} picture)
string(FIND "${picture}" "</svg>" end)
if(end EQUAL -1)
  message(FATAL_ERROR "no picture was written")
endif()
