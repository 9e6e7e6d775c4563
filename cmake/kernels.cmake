# SPDX-License-Identifier: BSD-3-Clause
# The hot loops of the core, compiled for several processors (src/common/target_clones.hpp). The folders name theirs, and
# a target takes all of them: properties of a source count in the folder of the target only.

# add_kernels([VECTOR_MATH] SOURCE...): of the folder that calls it. VECTOR_MATH: see use_kernels().
function(add_kernels)
  cmake_parse_arguments(kernels "VECTOR_MATH" "" "" ${ARGN})
  foreach(source ${kernels_UNPARSED_ARGUMENTS})
    set_property(GLOBAL APPEND PROPERTY OBJECTNESS_KERNELS ${CMAKE_CURRENT_SOURCE_DIR}/${source})
    if(kernels_VECTOR_MATH)
      set_property(GLOBAL APPEND PROPERTY OBJECTNESS_VECTOR_MATH ${CMAKE_CURRENT_SOURCE_DIR}/${source})
    endif()
  endforeach()
endfunction()

# use_kernels(TARGET): a target of the folder that calls it.
function(use_kernels target)
  get_property(kernels GLOBAL PROPERTY OBJECTNESS_KERNELS)
  get_property(vector_math GLOBAL PROPERTY OBJECTNESS_VECTOR_MATH)
  target_sources(${target} PRIVATE ${kernels})
  # Without these, a square root is a call and a choice a jump, where they could be lanes of a vector. The numbers are
  # the same: nothing reads errno, nothing traps. What is compiled with options of its own cannot share parsed headers.
  set_source_files_properties(${vector_math} PROPERTIES COMPILE_OPTIONS "-fno-math-errno;-fno-trapping-math"
    SKIP_PRECOMPILE_HEADERS ON)
endfunction()
