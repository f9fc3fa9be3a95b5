# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause

#[[
Tests, all run by `ctest`; `-L unit|gl|python|plugin|stress|package` picks a kind.

PELLUCID_TEST_WINDOWS: the render window classes that every test with OpenGL is run on, one ctest
entry for each, `NAME-CLASS`. An X window without a DISPLAY gets a virtual one (xvfb-run), so the
tests run on any machine. VTK chooses the class at run time from 9.4 on; before, it is fixed.
]]
include("${VTK_DIR}/vtkTestingRenderingDriver.cmake" OPTIONAL RESULT_VARIABLE pellucid_test_driver)
if (NOT pellucid_test_driver)
  message(FATAL_ERROR "BUILD_TESTING is ON, but ${VTK_DIR} lacks VTK's test driver.")
endif ()

if (VTK_VERSION VERSION_LESS "9.4")
  set(pellucid_default_windows vtkXOpenGLRenderWindow)
else ()
  set(pellucid_default_windows vtkEGLRenderWindow vtkOSOpenGLRenderWindow)
endif ()
set(PELLUCID_TEST_WINDOWS "${pellucid_default_windows}" CACHE STRING
  "Render window classes to run the tests with OpenGL on")

set(pellucid_test_data "${PROJECT_SOURCE_DIR}/Data")
set(pellucid_test_baselines "${PROJECT_SOURCE_DIR}/Testing/Data/Baseline")
set(pellucid_test_output "${CMAKE_BINARY_DIR}/Testing/Temporary")
file(MAKE_DIRECTORY "${pellucid_test_output}")

# What VTK's own tests take as failure, and what Mesa says when MESA_DEBUG is set and a call is wrong.
set(pellucid_test_failures
  "(\n|^)ERROR: "
  "ERR\\|"
  "instance(s)? still around"
  "Failed Image Test"
  "DartMeasurement name=.ImageNotFound"
  "Mesa: User error"
  "Mesa: warning"
  "AddressSanitizer"
  "runtime error:")

#[[
pellucid_add_test(NAME <name> LABELS <label>... COMMAND <command>...
                  [WINDOW] [TIMEOUT <seconds>] [ENVIRONMENT <VAR=value>...]
                  [EXPECTED <regular expression>] [REQUIRES <fixture>])

Add one ctest entry, or with WINDOW one for each class of PELLUCID_TEST_WINDOWS. The command gets
VTK's options -D <Data folder>, -T <folder for output> and -V <baseline picture of that name>, which
vtkTesting and vtkmodules.test.Testing read. A line that says "ERROR:", an image that differs, a
wrong OpenGL call or a sanitizer's finding fails a test even if the program returns 0. A test with
EXPECTED passes when the program says that and not otherwise: for what has to be refused.
]]
function (pellucid_add_test)
  cmake_parse_arguments(PARSE_ARGV 0 test "WINDOW" "NAME;TIMEOUT;EXPECTED;REQUIRES" "LABELS;COMMAND;ENVIRONMENT")
  if (NOT test_TIMEOUT)
    set(test_TIMEOUT 300)
  endif ()
  set(windows "none")
  if (test_WINDOW)
    set(windows ${PELLUCID_TEST_WINDOWS})
  endif ()

  foreach (window IN LISTS windows)
    set(name "${test_NAME}")
    set(launcher "")
    set(environment ${test_ENVIRONMENT})
    if (test_WINDOW)
      string(REGEX REPLACE "^vtk(.*)RenderWindow$" "\\1" short_window "${window}")
      string(APPEND name "-${short_window}")
      set(launcher "${PROJECT_SOURCE_DIR}/Testing/with-display")
      list(APPEND environment
        "VTK_DEFAULT_OPENGL_WINDOW=${window}"
        # From 9.4 on, VTK wants to be told which comparison to use; this is the one of 9.2.
        "VTK_TESTING_IMAGE_COMPARE_METHOD=LEGACY_VALID"
        "MESA_DEBUG=1")
    endif ()
    set(output "${pellucid_test_output}/${name}")
    file(MAKE_DIRECTORY "${output}")
    add_test(NAME "${name}"
      COMMAND ${launcher} ${test_COMMAND}
        -D "${pellucid_test_data}"
        -T "${output}"
        -V "${pellucid_test_baselines}/${test_NAME}.png")
    set_tests_properties("${name}" PROPERTIES
      LABELS "${test_LABELS}"
      TIMEOUT "${test_TIMEOUT}"
      ENVIRONMENT "${environment}"
      FIXTURES_REQUIRED "${test_REQUIRES}")
    if (test_EXPECTED)
      set_tests_properties("${name}" PROPERTIES PASS_REGULAR_EXPRESSION "${test_EXPECTED}")
    else ()
      set_tests_properties("${name}" PROPERTIES FAIL_REGULAR_EXPRESSION "${pellucid_test_failures}")
    endif ()
  endforeach ()
endfunction ()

#[[
pellucid_add_cxx_tests(<driver> LABELS <label>... TESTS <test>...
                       [WINDOW] [LIBRARIES <target>...] [TIMEOUT <seconds>])

Build the program <driver> from TestX.cxx of each test TestX, with VTK's test driver as main, and
add the tests. Each file defines `int TestX(int argc, char* argv[])`.
]]
function (pellucid_add_cxx_tests driver)
  cmake_parse_arguments(PARSE_ARGV 1 cxx "WINDOW" "TIMEOUT" "LABELS;TESTS;LIBRARIES")
  set(files ${cxx_TESTS})
  list(TRANSFORM files APPEND ".cxx")
  create_test_sourcelist(sources "${driver}.cxx" ${files}
    EXTRA_INCLUDE vtkTestingObjectFactory.h)
  add_executable("${driver}" ${sources})
  # OpenGL::GL: VTK before 9.4 calls the oldest OpenGL functions directly.
  target_link_libraries("${driver}"
    PRIVATE VTK::TestingRendering ${cxx_LIBRARIES} $<TARGET_NAME_IF_EXISTS:OpenGL::GL>)
  vtk_module_autoinit(TARGETS "${driver}" MODULES ${cxx_LIBRARIES})
  pellucid_warnings("${driver}")

  set(options "")
  if (cxx_WINDOW)
    list(APPEND options WINDOW)
  endif ()
  foreach (test IN LISTS cxx_TESTS)
    pellucid_add_test(NAME "${test}" LABELS ${cxx_LABELS} TIMEOUT "${cxx_TIMEOUT}" ${options}
      COMMAND "$<TARGET_FILE:${driver}>" "${test}")
  endforeach ()
endfunction ()

#[[
pellucid_add_python_tests(<interpreter> LABELS <label>... TESTS <test>...
                          [WINDOW] [TIMEOUT <seconds>] [ENVIRONMENT <VAR=value>...]
                          [REQUIRES <fixture>])

Add tests that the interpreter runs: TestX.py of each test TestX, a module of unittest cases that
finds the package of the build tree and Testing/Python/pictures.py.
]]
function (pellucid_add_python_tests interpreter)
  cmake_parse_arguments(PARSE_ARGV 1 python "WINDOW" "TIMEOUT;REQUIRES" "LABELS;TESTS;ENVIRONMENT")
  set(options "")
  if (python_WINDOW)
    list(APPEND options WINDOW)
  endif ()
  set(package "${CMAKE_BINARY_DIR}/${pellucid_python_destination}")
  set(shared "${PROJECT_SOURCE_DIR}/Testing/Python")
  foreach (test IN LISTS python_TESTS)
    pellucid_add_test(NAME "${test}" LABELS ${python_LABELS} TIMEOUT "${python_TIMEOUT}"
      REQUIRES "${python_REQUIRES}" ${options}
      COMMAND "${interpreter}" "${shared}/run.py" "${CMAKE_CURRENT_SOURCE_DIR}/${test}.py"
        -B "${pellucid_test_baselines}"
      ENVIRONMENT "PYTHONPATH=${package}:${shared}" ${python_ENVIRONMENT})
  endforeach ()
endfunction ()

#[[
pellucid_add_project_test(NAME <name> SOURCE <folder> OPTIONS <-DVAR=value>...
                          [PROGRAM <name> <argument>...] [REQUIRES <fixture>])

Add the test, labelled package, that the CMake project of a folder configures and builds with these
options, and that the program that it builds, if any, returns 0 for these arguments.
]]
function (pellucid_add_project_test)
  cmake_parse_arguments(PARSE_ARGV 0 project "" "NAME;SOURCE;REQUIRES" "OPTIONS;PROGRAM")
  set(folder "${CMAKE_BINARY_DIR}/Testing/${project_NAME}")
  set(run "")
  if (project_PROGRAM)
    list(POP_FRONT project_PROGRAM program)
    set(run --test-command "${PROJECT_SOURCE_DIR}/Testing/with-display"
      "${folder}/${program}" ${project_PROGRAM})
  endif ()
  list(GET PELLUCID_TEST_WINDOWS 0 window)
  add_test(NAME "${project_NAME}"
    COMMAND "${CMAKE_CTEST_COMMAND}" --build-and-test "${project_SOURCE}" "${folder}"
      --build-generator "${CMAKE_GENERATOR}" --build-options ${project_OPTIONS} ${run})
  set_tests_properties("${project_NAME}" PROPERTIES
    LABELS package
    TIMEOUT 900
    ENVIRONMENT "VTK_DEFAULT_OPENGL_WINDOW=${window}"
    FIXTURES_REQUIRED "${project_REQUIRES}"
    FAIL_REGULAR_EXPRESSION "CMake Error;warning: unused")
endfunction ()
