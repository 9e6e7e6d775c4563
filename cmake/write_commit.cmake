# SPDX-License-Identifier: BSD-3-Clause
# cmake -D SOURCE_DIR=... -D VERSION=... -D OUTPUT=... -P write_commit.cmake
# Writes a C++ header with the commit of a checkout, run at every build; the file changes only when the commit does.
set(commit "")
find_program(GIT git)
if(GIT)
  execute_process(COMMAND ${GIT} rev-parse --short=10 HEAD WORKING_DIRECTORY ${SOURCE_DIR}
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(commit)
  execute_process(COMMAND ${GIT} diff HEAD -- src include cmake CMakeLists.txt WORKING_DIRECTORY ${SOURCE_DIR}
    OUTPUT_VARIABLE changes ERROR_QUIET)
  if(NOT changes STREQUAL "")
    string(MD5 checksum "${changes}")
    string(SUBSTRING "${checksum}" 0 8 checksum)
    string(APPEND commit "+${checksum}")
  endif()
else()
  set(commit "version ${VERSION}")
endif()
set(text "#define OBJECTNESS_COMMIT \"${commit}\"\n")
set(earlier "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} earlier)
endif()
if(NOT text STREQUAL earlier)
  file(WRITE ${OUTPUT} "${text}")
endif()
