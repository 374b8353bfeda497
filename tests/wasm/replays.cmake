# For each of TRACES: replay.wasm has the states that VIDNO writes. Run with -P.
cmake_minimum_required(VERSION 3.25)
if(NOT TRACES)
    message(FATAL_ERROR "No trace")
endif()
file(MAKE_DIRECTORY ${WORK})
foreach(trace IN LISTS TRACES)
    execute_process(COMMAND ${VIDNO} replay ${trace} -o ${WORK}/states.jsonl RESULT_VARIABLE status ERROR_VARIABLE why)
    # 1: the run lost something, which does not matter here.
    if(NOT status LESS_EQUAL 1)
        message(FATAL_ERROR "${why}")
    endif()
    execute_process(COMMAND ${NODE} ${CMAKE_CURRENT_LIST_DIR}/replay.mjs ${MODULE} ${trace} ${WORK}/states.jsonl
                    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
