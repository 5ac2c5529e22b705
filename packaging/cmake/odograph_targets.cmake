# SPDX-License-Identifier: GPL-3.0-or-later
# How a library and a test of Odograph are declared. The links named in each folder's CMakeLists.txt are the
# architecture: a folder may include only what it links.

add_library(odograph_options INTERFACE)
target_include_directories(odograph_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(odograph_options INTERFACE -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Werror=return-type)
if(CMAKE_UNITY_BUILD)
  # Sources that are compiled as one see one another's names: what is local to a file is not warned of here, but in the presets
  # that compile each by itself.
  target_compile_options(odograph_options INTERFACE "$<$<CXX_COMPILER_ID:GNU>:-Wshadow=local;-Wno-subobject-linkage>")
else()
  target_compile_options(odograph_options INTERFACE -Wshadow)
endif()
# GCC looks for what it may free from a gigabyte on, not from 128 MB: a tenth less time, a fifth more memory.
target_compile_options(odograph_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1000000>)
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

# What a test compiles for itself is the frame around what it tests: to optimise that took a fifth of the time of compiling it.
add_library(odograph_test_options INTERFACE)
target_link_libraries(odograph_test_options INTERFACE odograph_options)
target_compile_options(odograph_test_options INTERFACE $<$<CONFIG:Release>:-O1>)

# odograph_precompiled(KIND LINKS libraries... HEADERS headers...): headers that are compiled once, for all targets that say
# odograph_precompile(TARGET KIND). GCC takes them only where the same macros are defined, so KIND follows which parts of Qt a
# target is linked with.
set(plain_headers <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <span>
  <string> <string_view> <vector> <Eigen/Core> <Eigen/Geometry> <tl/expected.hpp>
  "\"packaging/cmake/precompiled_shapes.h\"")
add_custom_target(odograph_precompiled_headers) # all of them
function(odograph_precompiled kind)
  cmake_parse_arguments(ARG "" "" "LINKS;HEADERS" ${ARGN})
  set(owner odograph_pch_${kind})
  # unchanged where it is there, or each run of CMake would have everything compiled again
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/pch/${kind}.cpp CONTENT "// owner of precompiled headers\n")
  add_library(${owner} STATIC ${PROJECT_BINARY_DIR}/pch/${kind}.cpp)
  target_link_libraries(${owner} PUBLIC odograph_options Eigen3::Eigen tl::expected ${ARG_LINKS})
  target_precompile_headers(${owner} PRIVATE ${plain_headers} ${ARG_HEADERS})
  add_dependencies(odograph_precompiled_headers ${owner})
endfunction()

function(odograph_precompile target kind)
  target_link_libraries(${target} PRIVATE Eigen3::Eigen tl::expected) # where clang finds what plain_headers names
  target_precompile_headers(${target} REUSE_FROM odograph_pch_${kind})
endfunction()

set(qt_headers <QObject> <QString> <QHash> <QVector> <QVariant>)
set(widget_headers <QAction> <QComboBox> <QCoreApplication> <QDialog> <QFormLayout> <QHBoxLayout> <QHeaderView> <QImage> <QLabel>
  <QLocale> <QPainter> <QPushButton> <QStringList> <QTableView> <QVBoxLayout> <QWidget>)
set(test_headers <QDir> <QFile> <QSignalSpy> <QTemporaryDir> <QTest>)
# Where a test lies would make each test's macros its own; QFINDTESTDATA, which is what that is for, is not used.
set_target_properties(Qt6::Test PROPERTIES INTERFACE_COMPILE_DEFINITIONS QT_TESTLIB_LIB)
odograph_precompiled(std)
odograph_precompiled(qt LINKS Qt6::Core HEADERS ${qt_headers})
odograph_precompiled(widgets LINKS Qt6::Widgets HEADERS ${qt_headers} ${widget_headers})
odograph_precompiled(test LINKS odograph_test_options Qt6::Test HEADERS ${qt_headers} ${test_headers})
odograph_precompiled(gui_test LINKS odograph_test_options Qt6::Gui Qt6::Test HEADERS ${qt_headers} ${test_headers})
odograph_precompiled(widgets_test LINKS odograph_test_options Qt6::Widgets Qt6::Test
  HEADERS ${qt_headers} ${widget_headers} ${test_headers})

# odograph_moc_own(TARGET PLACE/unit): makes unit.moc, which unit.cpp includes.
function(odograph_moc_own target unit)
  get_filename_component(place ${CMAKE_CURRENT_BINARY_DIR}/${unit} DIRECTORY)
  set(moc ${CMAKE_CURRENT_BINARY_DIR}/${unit}.moc)
  add_custom_command(OUTPUT ${moc}
    COMMAND Qt6::moc -o ${moc} ${CMAKE_CURRENT_SOURCE_DIR}/${unit}.cpp
    DEPENDS ${unit}.cpp VERBATIM)
  target_sources(${target} PRIVATE ${moc})
  target_include_directories(${target} PRIVATE ${place})
endfunction()

# odograph_moc(TARGET): runs moc over the headers of its sources, and over the sources that include what it makes of them.
# AUTOMOC would read all headers of Qt and of the standard library for each of ours: a second and a half, not a fiftieth.
function(odograph_moc target)
  set(headers "")
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    string(REGEX REPLACE "\\.(cpp|h)$" "" unit ${source})
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${unit}.h)
      list(APPEND headers ${CMAKE_CURRENT_SOURCE_DIR}/${unit}.h)
    endif()
    file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/${source} own REGEX "^#include \"[a-z_]+\\.moc\"" LIMIT_COUNT 1)
    if(own)
      odograph_moc_own(${target} ${unit})
    endif()
  endforeach()
  set(moc ${CMAKE_CURRENT_BINARY_DIR}/${target}_moc.cpp)
  add_custom_command(OUTPUT ${moc}
    COMMAND sh ${PROJECT_SOURCE_DIR}/packaging/cmake/moc_headers.sh $<TARGET_FILE:Qt6::moc> ${PROJECT_SOURCE_DIR} ${moc} ${headers}
    DEPENDS ${headers} ${PROJECT_SOURCE_DIR}/packaging/cmake/moc_headers.sh VERBATIM)
  target_sources(${target} PRIVATE ${moc})
endfunction()

# odograph_library(NAME SOURCES a.cpp ... [LINKS public...] [PRIVATE_LINKS private...] [QT|WIDGETS])
# QT, WIDGETS: runs moc over the sources; WIDGETS where they are linked with Qt's widgets.
function(odograph_library name)
  cmake_parse_arguments(ARG "QT;WIDGETS" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC odograph_options ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  set(kind std)
  if(ARG_QT OR ARG_WIDGETS)
    odograph_moc(${name})
    set(kind qt)
  endif()
  if(ARG_WIDGETS)
    set(kind widgets)
  endif()
  odograph_precompile(${name} ${kind})
endfunction()

# What binutils brings besides takes a fifth of the time of linking tests.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold ODOGRAPH_HAS_GOLD)
set(quick_linker "")
if(ODOGRAPH_HAS_GOLD)
  set(quick_linker -fuse-ld=gold)
endif()

# odograph_test_program(NAME KIND): a program that tests are compiled into; KIND: of its precompiled headers.
function(odograph_test_program name kind)
  add_executable(${name})
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
  target_link_options(${name} PRIVATE ${quick_linker})
  target_link_libraries(${name} PRIVATE odograph_test_options Qt6::Test)
  if(kind STREQUAL widgets_test)
    target_link_libraries(${name} PRIVATE Qt6::Widgets)
  elseif(kind STREQUAL gui_test)
    target_link_libraries(${name} PRIVATE Qt6::Gui)
  endif()
  odograph_precompile(${name} ${kind})
endfunction()

# odograph_join_tests(PROGRAM): compiles its tests eight at a time (joined_tests.awk), or one by one where sources are not joined.
# To load the precompiled headers takes two seconds of a processor, more than most tests take.
function(odograph_join_tests program)
  get_target_property(units ${program} ODOGRAPH_UNITS)
  list(LENGTH units count)
  if(count EQUAL 1 OR NOT CMAKE_UNITY_BUILD OR NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU) # lint.sh looks at each by itself
    target_sources(${program} PRIVATE ${units})
    return()
  endif()
  set(number 0)
  while(units)
    list(SUBLIST units 0 8 batch)
    list(REMOVE_ITEM units ${batch})
    set(joined ${CMAKE_CURRENT_BINARY_DIR}/${program}_${number}.cpp)
    math(EXPR number "${number} + 1")
    add_custom_command(OUTPUT ${joined}
      COMMAND awk -f ${PROJECT_SOURCE_DIR}/packaging/cmake/joined_tests.awk ${batch} > ${joined}
      DEPENDS ${batch} ${PROJECT_SOURCE_DIR}/packaging/cmake/joined_tests.awk VERBATIM)
    target_sources(${program} PRIVATE ${joined})
  endwhile()
endfunction()

# odograph_test(tst_unit [ALONE] [WAITS] [SOURCES more.cpp ...] [LINKS libraries...] [LABELS ...] [TIMEOUT s] [ENVIRONMENT ...])
# Compiles tst_unit.cpp into the folder's program of QtTest classes and registers it under the folder's name:
# "geometry/tst_unit"; the unit may lie in a sub-folder. ALONE: in a program of its own, because it has its own main or stands
# in front of calls of the system. tst_unit_command: what runs it, for further tests of the same unit. `test_kind`, set before
# the first test of a folder: of the precompiled headers. A test takes two of ctest's slots, of which a processor has two
# (packaging/headless.sh); WAITS: one, for it hardly computes.
function(odograph_test unit)
  cmake_parse_arguments(ARG "ALONE;WAITS" "TIMEOUT" "SOURCES;LINKS;LABELS;ENVIRONMENT" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  set(slots 2)
  if(ARG_WAITS)
    set(slots 1)
  endif()
  if(ODOGRAPH_SANITIZE) # some ten times slower, so that what waits computes all the time, and is late beside another
    if(ARG_WAITS)
      set(slots 4) # two processors
    endif()
    math(EXPR ARG_TIMEOUT "${ARG_TIMEOUT} * 10")
    list(APPEND ARG_ENVIRONMENT QTEST_FUNCTION_TIMEOUT=3000000)
  endif()
  get_filename_component(name ${unit} NAME)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/tests ${CMAKE_CURRENT_SOURCE_DIR})
  string(REGEX MATCH "^[a-z0-9]+" part ${folder})
  set(kind test)
  if(part MATCHES "^(ui|manual)$")
    set(kind widgets_test)
  elseif(test_kind)
    set(kind ${test_kind})
  endif()
  if(NOT TARGET ${part}_tests)
    add_custom_target(${part}_tests) # all of a folder and those below it
  endif()
  if(ARG_ALONE)
    set(program ${name})
    set(command ${name})
  else()
    string(REPLACE "/" "_" program tests_${folder})
    set(command ${program} ${name})
  endif()
  if(NOT TARGET ${program})
    odograph_test_program(${program} ${kind})
    add_dependencies(${part}_tests ${program})
    cmake_language(EVAL CODE "cmake_language(DEFER CALL odograph_join_tests ${program})")
  endif()
  set_property(TARGET ${program} APPEND PROPERTY ODOGRAPH_UNITS ${CMAKE_CURRENT_SOURCE_DIR}/${unit}.cpp)
  target_sources(${program} PRIVATE ${ARG_SOURCES})
  odograph_moc_own(${program} ${unit})
  target_link_libraries(${program} PRIVATE ${ARG_LINKS} registered_tests)
  set(${name}_command ${command} PARENT_SCOPE)
  add_test(NAME ${folder}/${unit} COMMAND ${command})
  set_tests_properties(${folder}/${unit} PROPERTIES
    TIMEOUT ${ARG_TIMEOUT}
    PROCESSORS ${slots}
    LABELS "${ARG_LABELS}"
    SKIP_REGULAR_EXPRESSION "ODOGRAPH-SKIPPED"
    ENVIRONMENT "QT_QPA_PLATFORM=offscreen;ODOGRAPH_SOURCE_DIR=${PROJECT_SOURCE_DIR};ODOGRAPH_PROGRAM=$<TARGET_FILE:odograph>;${ARG_ENVIRONMENT}")
endfunction()
