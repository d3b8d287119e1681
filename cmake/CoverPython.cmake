# Python for the module and the tests: the first interpreter that has numpy, since the one in the
# PATH need not be the one for which the system's packages are. Sets COVER_PYTHON_FOUND where the
# module can be built.
if(NOT Python3_EXECUTABLE)
  find_program(path_python python3)
  mark_as_advanced(path_python)
  foreach(candidate ${path_python} /usr/bin/python3)
    execute_process(COMMAND ${candidate} -c "import numpy" RESULT_VARIABLE no_numpy
                    OUTPUT_QUIET ERROR_QUIET)
    if(NOT no_numpy)
      set(Python3_EXECUTABLE ${candidate} CACHE FILEPATH "Python for the module and the tests")
      break()
    endif()
  endforeach()
endif()
find_package(Python3 QUIET COMPONENTS Interpreter Development.Module)
set(COVER_PYTHON_FOUND OFF)
if(Python3_FOUND AND Python3_Development.Module_FOUND)
  find_package(pybind11 CONFIG QUIET)   # after Python3, whose interpreter it takes then
  set(COVER_PYTHON_FOUND ${pybind11_FOUND})
endif()
