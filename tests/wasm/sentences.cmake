# The page says of each step of all lessons, and of TRACES, what VIDNO says. Run with -P.
cmake_minimum_required(VERSION 3.25)
file(GLOB lessons ${LESSONS}/[0-9]*)
file(REMOVE_RECURSE ${WORK})
# 1: a run of a lesson may lose something.
execute_process(COMMAND ${VIDNO} lesson build ${lessons} -o ${WORK} RESULT_VARIABLE status ERROR_VARIABLE why OUTPUT_QUIET)
if(NOT status LESS_EQUAL 1)
    message(FATAL_ERROR "${why}")
endif()
file(GLOB of_lessons ${WORK}/*.jsonl.gz)
if(NOT of_lessons OR NOT TRACES)
    message(FATAL_ERROR "No trace")
endif()
execute_process(COMMAND ${NODE} ${CMAKE_CURRENT_LIST_DIR}/sentences.mjs ${MODULE} ${VIDNO} ${of_lessons} ${TRACES}
                COMMAND_ERROR_IS_FATAL ANY)
