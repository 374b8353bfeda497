# Functions for the tests of `vidno grade`. Each test is a script beside this one. It runs with -P; CLANG, VIDNO and WORK are given, and
# HEADER, the folder of the precompiled header.
cmake_minimum_required(VERSION 3.25)
set(here ${CMAKE_CURRENT_LIST_DIR})
set(student ${here}/../../lessons/student)

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

set(flags -std=c++14 -Wall -Wextra -Wpedantic -Wshadow -Werror -I${student} -include-pch ${HEADER}/example.pch)
set(libraries ${HEADER}/example.o)

# Compiles students' programs. Each gets the name of its source.
function(compile)
    foreach(source IN LISTS ARGN)
        get_filename_component(program ${source} NAME_WE)
        execute_process(COMMAND ${CLANG} ${flags} ${source} -o ${program} ${libraries}
                        WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
endfunction()

# Compiles a student's program and grades it. Sets `status` and `report`. Further arguments are options of `vidno grade`.
function(grade source)
    compile(${source})
    get_filename_component(program ${source} NAME_WE)
    grade_program(./${program} ${ARGN})
    set(status ${status} PARENT_SCOPE)
    set(report "${report}" PARENT_SCOPE)
endfunction()

function(grade_program program)
    execute_process(COMMAND ${VIDNO} grade ${program} ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE code
                    OUTPUT_VARIABLE said ERROR_VARIABLE errors)
    set(status ${code} PARENT_SCOPE)
    set(report "${said}${errors}" PARENT_SCOPE)
endfunction()

function(must_say program code text)
    string(FIND "${report}" "${text}" found)
    if(NOT status STREQUAL code OR found EQUAL -1)
        message(FATAL_ERROR "${program}: ${status} instead of ${code}, or without \"${text}\":\n${report}")
    endif()
endfunction()

function(must_not_say program text)
    string(FIND "${report}" "${text}" found)
    if(NOT found EQUAL -1)
        message(FATAL_ERROR "${program}: with \"${text}\":\n${report}")
    endif()
endfunction()

# The report must list exactly these differences, in this order.
function(must_differ source)
    must_say(${source} 0 "Right on all ")
    string(REGEX MATCHALL "\n  [^\n]* \\([0-9]+ scenes?\\)" told "${report}")
    list(TRANSFORM told REPLACE "\n  ([^\n]*) \\([0-9]+ scenes?\\)" "\\1")
    if(NOT told STREQUAL "${ARGN}")
        message(FATAL_ERROR "${source}: \"${told}\" instead of \"${ARGN}\":\n${report}")
    endif()
endfunction()
