# SPDX-License-Identifier: GPL-3.0-or-later
# How a library and a test of Odograph are declared. The links named in each folder's CMakeLists.txt are the
# architecture: a folder may include only what it links.

add_library(odograph_options INTERFACE)
target_include_directories(odograph_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(odograph_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                                                  -Werror=return-type)
target_compile_definitions(odograph_options INTERFACE
  ODOGRAPH_VERSION="${PROJECT_VERSION}"
  QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_NO_URL_CAST_FROM_STRING QT_NO_KEYWORDS
  QT_NO_CONTEXTLESS_CONNECT QT_NO_NARROWING_CONVERSIONS_IN_CONNECT
  EIGEN_MPL2_ONLY)
if(ODOGRAPH_SANITIZE)
  # Under AddressSanitizer Eigen would lay out its memory differently from what the libraries that share its
  # templates with us (Ceres) were built with, and each would free what is the other's.
  target_compile_definitions(odograph_options INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
  target_compile_options(odograph_options INTERFACE -fsanitize=${ODOGRAPH_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(odograph_options INTERFACE -fsanitize=${ODOGRAPH_SANITIZE})
  if(ODOGRAPH_SANITIZE STREQUAL "address,undefined")
    # Undefined behaviour ends in a trap, which the address sanitizer reports with the functions that led there. What the
    # words for each place take made a test of the window a gigabyte, and all of them more than a disk holds.
    target_compile_options(odograph_options INTERFACE -fsanitize-undefined-trap-on-error)
  endif()
endif()

if(ODOGRAPH_COVERAGE)
  target_link_options(odograph_options INTERFACE --coverage)
endif()

# One precompiled header for the parts below Qt, one for those with it; each is compiled once and reused.
function(odograph_precompile target qt)
  if(qt)
    set(owner odograph_pch_qt)
  else()
    set(owner odograph_pch_std)
  endif()
  target_precompile_headers(${target} REUSE_FROM ${owner})
endfunction()

# odograph_library(NAME SOURCES a.cpp ... [LINKS public...] [PRIVATE_LINKS private...] [QT])
# QT: runs moc over the sources and uses the Qt precompiled header.
function(odograph_library name)
  cmake_parse_arguments(ARG "QT" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC odograph_options ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  if(ARG_QT)
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
  endif()
  odograph_precompile(${name} "${ARG_QT}")
endfunction()

# odograph_moc_own(tst_unit): makes tst_unit.moc, which tst_unit.cpp includes. AUTOMOC would start CMake twice for each of
# hundreds of programs, which took as long as compiling them.
function(odograph_moc_own name)
  set(moc ${CMAKE_CURRENT_BINARY_DIR}/${name}.moc)
  add_custom_command(OUTPUT ${moc}
    COMMAND Qt6::moc -o ${moc} ${CMAKE_CURRENT_SOURCE_DIR}/${name}.cpp
    DEPENDS ${name}.cpp VERBATIM)
  target_sources(${name} PRIVATE ${moc})
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()

# odograph_test(tst_unit [SOURCES more.cpp ...] [LINKS libraries...] [LABELS ...] [TIMEOUT s] [ENVIRONMENT ...])
# Builds tst_unit.cpp with QtTest and registers it under the folder's name: "geometry/tst_unit".
function(odograph_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LINKS;LABELS;ENVIRONMENT" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  if(ODOGRAPH_SANITIZE) # some ten times slower
    math(EXPR ARG_TIMEOUT "${ARG_TIMEOUT} * 10")
    list(APPEND ARG_ENVIRONMENT QTEST_FUNCTION_TIMEOUT=3000000)
  endif()
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/tests ${CMAKE_CURRENT_SOURCE_DIR})
  add_executable(${name} ${name}.cpp ${ARG_SOURCES})
  odograph_moc_own(${name})
  target_link_libraries(${name} PRIVATE odograph_options Qt6::Test ${ARG_LINKS})
  odograph_precompile(${name} ON)
  string(REGEX MATCH "^[a-z0-9]+" part ${folder})
  if(NOT TARGET ${part}_tests)
    add_custom_target(${part}_tests) # all of a folder and those below it
  endif()
  add_dependencies(${part}_tests ${name})
  add_test(NAME ${folder}/${name} COMMAND ${name})
  set_tests_properties(${folder}/${name} PROPERTIES
    TIMEOUT ${ARG_TIMEOUT}
    LABELS "${ARG_LABELS}"
    SKIP_REGULAR_EXPRESSION "ODOGRAPH-SKIPPED"
    ENVIRONMENT "QT_QPA_PLATFORM=offscreen;ODOGRAPH_SOURCE_DIR=${PROJECT_SOURCE_DIR};ODOGRAPH_PROGRAM=$<TARGET_FILE:odograph>;${ARG_ENVIRONMENT}")
endfunction()

file(WRITE ${PROJECT_BINARY_DIR}/pch/empty_std.cpp "// owner of the precompiled header of the parts below Qt\n")
file(WRITE ${PROJECT_BINARY_DIR}/pch/empty_qt.cpp "// owner of the precompiled header of the parts with Qt\n")
add_library(odograph_pch_std STATIC ${PROJECT_BINARY_DIR}/pch/empty_std.cpp)
target_link_libraries(odograph_pch_std PUBLIC odograph_options Eigen3::Eigen tl::expected)
target_precompile_headers(odograph_pch_std PRIVATE
  <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <span>
  <string> <string_view> <vector> <Eigen/Core> <Eigen/Geometry> <tl/expected.hpp>)
add_library(odograph_pch_qt STATIC ${PROJECT_BINARY_DIR}/pch/empty_qt.cpp)
target_link_libraries(odograph_pch_qt PUBLIC odograph_options Eigen3::Eigen tl::expected Qt6::Core)
target_precompile_headers(odograph_pch_qt PRIVATE
  <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <span>
  <string> <string_view> <vector> <Eigen/Core> <Eigen/Geometry> <tl/expected.hpp> <QObject> <QString> <QHash>
  <QVector> <QVariant>)
