# `vidno grade` on students' programs: the right ones pass and hear what is different, each wrong one hears its mistake,
# and one that does not end well is named. Run with -P; COMPILER, VIDNO and WORK are given.
cmake_minimum_required(VERSION 3.25)
set(student ${CMAKE_CURRENT_LIST_DIR}/../../lessons/student)

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

# Builds a program of the student and grades it: `status` and `report` are what comes of it. More words are options.
set(language -std=c++14)
function(grade source)
    get_filename_component(program ${source} NAME_WE)
    execute_process(COMMAND ${COMPILER} ${language} -O1 -Wall -Wextra -Wpedantic -Wshadow -Werror -I${student} ${source}
                            -o ${program} WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${VIDNO} grade ./${program} ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE code
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

# Its differences are those named, in their order, and no others.
function(must_be_right source)
    grade(${source})
    must_say(${source} 0 "Right on all ")
    string(REGEX MATCHALL "\n  [^\n]* \\([0-9]+ scenes?\\)" told "${report}")
    list(TRANSFORM told REPLACE "\n  ([^\n]*) \\([0-9]+ scenes?\\)" "\\1")
    if(NOT told STREQUAL "${ARGN}")
        message(FATAL_ERROR "${source}: \"${told}\" instead of \"${ARGN}\":\n${report}")
    endif()
endfunction()

function(must_make program mistake)
    grade(${CMAKE_CURRENT_LIST_DIR}/${program}.cpp)
    must_say(${program} 1 "It behaves like a usual mistake, ${mistake}: ")
    must_say(${program} 1 "The smallest scene that shows it:")
endfunction()

# On a scene whose trace is short, so that the end comes soon.
function(must_end program words)
    grade(${CMAKE_CURRENT_LIST_DIR}/${program}.cpp --seconds 2 --scenes ${student}/../05-polygon-clip/scene.json)
    must_say(${program} 1 "The program ${words}")
endfunction()

set(outline "another rule for points of an outline")
must_be_right(${student}/warnock.cpp "${outline}")
must_be_right(${student}/z_buffer.cpp "${outline}")
must_be_right(${CMAKE_CURRENT_LIST_DIR}/recursion.cpp "${outline}" "recursion instead of the stack")
must_be_right(${CMAKE_CURRENT_LIST_DIR}/other_order.cpp "the parts of a window in another order"
              "the polygons in another order" "outlines in the opposite direction" "${outline}")
must_be_right(${CMAKE_CURRENT_LIST_DIR}/half_open_float.cpp "${outline}" "numbers in float")

must_make(one_list one-list)
must_make(depths_not_cleared depths-not-cleared)
must_make(clip_order_reversed clip-order-reversed)
must_make(y_flipped y-flipped)
must_make(depth_sign_reversed depth-sign-reversed)
must_make(boundary_outside boundary-outside)
must_make(integer_division integer-division)
must_make(surround_kept surround-kept)

must_end(crash "crashed (SIGSEGV): it reached for memory")
must_end(endless_loop "did not end within 2 s")
must_end(endless_output "")  # too long or too much, as fast as the disk is
must_end(endless_printing "wrote more than 64 MiB")
must_end(endless_memory "asked for more than 512 MiB of memory")

# What cannot be graded is refused in a line.
function(must_refuse reason)
    execute_process(COMMAND ${VIDNO} grade ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status
                    ERROR_VARIABLE report OUTPUT_QUIET)
    must_say("${ARGN}" 2 "${reason}")
endfunction()
find_program(TRUE_PROGRAM true REQUIRED)
must_refuse("no trace was written: " ${TRUE_PROGRAM})
must_refuse("No such file or directory" ./nothing)
must_refuse("report.pdf: not .html" ./warnock -o report.pdf)
execute_process(COMMAND ${VIDNO} trace ${student}/../05-polygon-clip/scene.json --kernel exact -o exact.jsonl
                WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
must_refuse("only float and double are judged" exact.jsonl)

# A trace that is there already.
execute_process(COMMAND ./surround_kept WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${VIDNO} grade surround_kept.jsonl WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status
                OUTPUT_VARIABLE report)
must_say(surround_kept.jsonl 1 "It behaves like a usual mistake, surround-kept: ")

# Procedures of one's own in a run of vidno's.
set(root ${CMAKE_CURRENT_LIST_DIR}/../..)
set(language -std=c++20 -ffp-contract=off -I${root}/lib -I${root}/trace)
must_be_right(${student}/surround_test.cpp "${outline}")
grade(${CMAKE_CURRENT_LIST_DIR}/half_plane_clip.cpp)
must_say(half_plane_clip 1 "the program: the part of B in the window (8, 0) of 8 x 8 has 3 vertices")
must_say(half_plane_clip 1 "(10.75, 11.25, 0.5) lies outside the window")
