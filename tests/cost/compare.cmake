# Counts the instructions of TRACED and STRIPPED under callgrind. Run with -P.
cmake_minimum_required(VERSION 3.25)
foreach(name IN ITEMS TRACED STRIPPED)
    execute_process(
        COMMAND ${VALGRIND} --tool=callgrind --callgrind-out-file=${WORK}/${name}.callgrind ${${name}}
        OUTPUT_VARIABLE printed_${name} ERROR_VARIABLE messages RESULT_VARIABLE failed)
    if(failed)
        message(FATAL_ERROR "${messages}")
    endif()
    file(STRINGS ${WORK}/${name}.callgrind totals REGEX "^(summary|totals): ")
    string(REGEX MATCH "[0-9]+" count_${name} "${totals}")
endforeach()
if(NOT printed_TRACED STREQUAL printed_STRIPPED)
    message(FATAL_ERROR "Not the same pictures:\n${printed_TRACED}${printed_STRIPPED}")
endif()

# Fewer is fine: with the calls present the compiler may inline differently, and better.
math(EXPR difference "${count_TRACED} - ${count_STRIPPED}")
math(EXPR parts_per_million "${difference} * 1000000 / ${count_STRIPPED}")
message(STATUS "instructions with trace calls ${count_TRACED}, stripped ${count_STRIPPED}, "
               "difference ${difference} (${parts_per_million} ppm)")
if(count_STRIPPED LESS 10000000 OR parts_per_million GREATER 1000)
    message(FATAL_ERROR "A trace that nobody hears costs more than 0.1 %")
endif()
