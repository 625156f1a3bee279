# Headers that most files of a target include are compiled once for all of its files: a third of the time of a clean
# build. Only for whoever builds the whole project; -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without, as the presets
# of the library do, so that no file of it can rely on what it does not include. None of them is the project's: every file
# would be compiled again for a line in it.
set(ECODS_STANDARD_HEADERS <algorithm> <array> <bit> <cmath> <concepts> <cstdint> <functional> <limits> <memory> <optional>
                           <ostream> <ranges> <span> <stdexcept> <string> <string_view> <utility> <vector>)

# g++ 12 forgets of code in a precompiled header that it is the system's, whose warnings are nobody's here: what it takes
# for writing past the end of a new vector or string would end the build. Without the headers all warnings are on.
function(ecods_quieten_precompiled target)
  if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-restrict>)
  endif()
endfunction()

# g++ compiles a file as the precompiled header says that it was compiled, whatever the file's own options for the
# optimizer are: files that have options of their own go without. They must be set before.
# usage: ecods_precompile(TARGET HEADERS...)
function(ecods_precompile target)
  if(NOT PROJECT_IS_TOP_LEVEL)
    return()
  endif()
  target_precompile_headers(${target} PRIVATE ${ECODS_STANDARD_HEADERS} ${ARGN})
  ecods_quieten_precompiled(${target})
  get_target_property(files ${target} SOURCES)
  foreach(file IN LISTS files)
    get_source_file_property(options ${file} COMPILE_OPTIONS)
    if(options)
      set_source_files_properties(${file} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
endfunction()

# The target takes what was compiled for another one of the same flags. usage: ecods_share_precompiled(TARGET OTHER)
function(ecods_share_precompiled target other)
  if(PROJECT_IS_TOP_LEVEL)
    target_precompile_headers(${target} REUSE_FROM ${other})
    ecods_quieten_precompiled(${target})
  endif()
endfunction()
