# Configures, builds and runs a consumer:
#   cmake -D SOURCE=... -D BUILD=... -D ARGUMENTS=... -D ROOT=... -P build_consumer.cmake
# With ccache, objects of the main build are found again (same depth of folder, paths made relative).
set(ENV{CCACHE_BASEDIR} ${ROOT})

function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}")
  endif()
endfunction()

step(${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} -G Ninja ${ARGUMENTS})
step(${CMAKE_COMMAND} --build ${BUILD} --target consumer)
step(${CMAKE_COMMAND} -E chdir ${BUILD} ${BUILD}/consumer)
