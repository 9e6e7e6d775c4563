# SPDX-License-Identifier: BSD-3-Clause
# Without ROS: what catkin sets and defines otherwise, under the names that the rest of the build knows. Installed below a
# prefix as CMake has it (bin, lib, include, share), with a package file for find_package(objectness_segmentation).
include(GNUInstallDirs)
include(CTest)
option(BUILD_SHARED_LIBS "shared libraries" ON)

file(STRINGS package.xml version REGEX "<version>")
string(REGEX REPLACE ".*<version>(.*)</version>.*" "\\1" ${PROJECT_NAME}_VERSION "${version}")

find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(PYTHON_EXECUTABLE ${Python3_EXECUTABLE})

set(CATKIN_ENABLE_TESTING ${BUILD_TESTING})
set(CATKIN_DEVEL_PREFIX ${PROJECT_BINARY_DIR}/devel)
set(CATKIN_GLOBAL_BIN_DESTINATION ${CMAKE_INSTALL_BINDIR})
set(CATKIN_PACKAGE_BIN_DESTINATION ${CMAKE_INSTALL_BINDIR})
set(CATKIN_PACKAGE_LIB_DESTINATION ${CMAKE_INSTALL_LIBDIR})
set(CATKIN_PACKAGE_INCLUDE_DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${PROJECT_NAME})
set(CATKIN_PACKAGE_SHARE_DESTINATION ${CMAKE_INSTALL_DATADIR}/${PROJECT_NAME})
set(CATKIN_PACKAGE_PYTHON_DESTINATION lib/python3/dist-packages/${PROJECT_NAME})
# The tools of the build are where they are with ROS.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/lib/${PROJECT_NAME})
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/lib)
set(CMAKE_INSTALL_RPATH "$ORIGIN:$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")

# catkin_install_python(PROGRAMS FILE... DESTINATION FOLDER)
function(catkin_install_python)
  install(${ARGV})
endfunction()

# catkin_add_gtest(TARGET SOURCE...): the results are where scripts/lib/count_tests.py looks for them.
function(catkin_add_gtest target)
  add_executable(${target} ${ARGN})
  add_test(NAME _ctest_${PROJECT_NAME}_gtest_${target} COMMAND ${target}
    --gtest_output=xml:${PROJECT_BINARY_DIR}/test_results/${PROJECT_NAME}/gtest-${target}.xml)
endfunction()
if(BUILD_TESTING)
  find_package(GTest CONFIG REQUIRED)
  add_library(gtest_main INTERFACE)
  target_link_libraries(gtest_main INTERFACE GTest::gtest_main)
endif()

# The package file: a project that finds it links objectness_segmentation::core.
include(CMakePackageConfigHelpers)
set(PACKAGE_FILES_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/${PROJECT_NAME})
configure_package_config_file(cmake/${PROJECT_NAME}-config.cmake.in ${PROJECT_BINARY_DIR}/${PROJECT_NAME}-config.cmake
  INSTALL_DESTINATION ${PACKAGE_FILES_DESTINATION})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/${PROJECT_NAME}-config-version.cmake
  VERSION ${${PROJECT_NAME}_VERSION} COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/${PROJECT_NAME}-config.cmake
  ${PROJECT_BINARY_DIR}/${PROJECT_NAME}-config-version.cmake DESTINATION ${PACKAGE_FILES_DESTINATION} COMPONENT core)
install(EXPORT ${PROJECT_NAME} NAMESPACE ${PROJECT_NAME}:: FILE ${PROJECT_NAME}-targets.cmake
  DESTINATION ${PACKAGE_FILES_DESTINATION} COMPONENT core)
