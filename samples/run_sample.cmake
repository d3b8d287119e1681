# Runs PROGRAM: it must end with 0 and print what matches EXPECTED.
execute_process(COMMAND ${PROGRAM} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
message("${out}${err}")
if(NOT code EQUAL 0 OR NOT out MATCHES "${EXPECTED}")
  message(FATAL_ERROR "exit code ${code}, or the output does not match '${EXPECTED}'")
endif()
