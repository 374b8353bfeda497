# The header for students' own programs, with each of COMPILERS: VIDNO reads the whole traces of two right programs, and they paint what
# the picture rule demands; wrong use is reported, and still leaves a trace. Run with -P.
cmake_minimum_required(VERSION 3.25)
set(student ${CMAKE_CURRENT_LIST_DIR}/../../lessons/student)
set(right ${CMAKE_CURRENT_LIST_DIR}/../grade/right)
set(sources ${right}/warnock.cpp ${right}/z_buffer.cpp ${right}/weiler_atherton.cpp ${right}/floating_horizon.cpp)
foreach(name IN ITEMS sha256 wrong_use crash)
    list(APPEND sources ${CMAKE_CURRENT_LIST_DIR}/${name}.cpp)
endforeach()

macro(must)
    execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
endmacro()

# Runs a program; its standard error must be exactly this, apart from the numbers of steps.
function(must_say said)
    execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} ERROR_VARIABLE errors COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX REPLACE ", after step [0-9]+" "" errors "${errors}")
    if(NOT errors STREQUAL said)
        message(FATAL_ERROR "${ARGN} said\n${errors}instead of\n${said}")
    endif()
endfunction()

function(must_hold trace text)
    file(READ ${WORK}/${trace}.jsonl lines)
    string(FIND "${lines}" "${text}" found)
    if(found EQUAL -1)
        message(FATAL_ERROR "${trace}.jsonl lacks ${text}\n${lines}")
    endif()
endfunction()

# The picture by the events alone. Exit code 0 means that every line was read and that the last one has its hash.
macro(replay trace)
    must(${VIDNO} replay ${trace}.jsonl -o ${trace}.ppm)
endmacro()

# No outline of the example's scene comes nearer to the centre of a pixel than 1/64, no two of its planes have depths at a
# centre or a window's corner that differ by less than 1/128, and its coordinates are such that an orientation in doubles
# is exact: what rounding can do in 16 x 16 pixels, some 2^-45, decides nothing.
macro(test_example name method)
    foreach(detail IN ITEMS windows polygons signs)
        must_say("" ./${name} ${detail})
        replay(${name})
        file(STRINGS ${WORK}/${name}.jsonl header LIMIT_COUNT 1)
        string(JSON scene GET "${header}" scene)
        file(WRITE ${WORK}/scene.json "${scene}")
        must(${VIDNO} render scene.json --method ${method} --kernel exact -o exact.ppm)
        must(${CMAKE_COMMAND} -E compare_files ${name}.ppm exact.ppm)
    endforeach()
endmacro()

# The regions and lines of a right program end between pixels, where rounding decides the last digits. So they are judged.
macro(test_judged name)
    foreach(detail IN ITEMS windows polygons signs)
        must_say("" ./${name} ${detail})
        must(${VIDNO} replay ${name}.jsonl -o ${name}.states.jsonl)
        must(${VIDNO} grade ${name}.jsonl)
    endforeach()
endmacro()

# By the number of the call in wrong_use.cpp; the same at every level, but with other steps.
set(complaints
    "2, pop: not the window on top of AW: the trace pushes it first"
    "3, push: not a window: a side is not positive, or a number not finite"
    "4, nearer: `corners` and four times `depth` come before"
    "5, mark: the scene has no polygon 7"
    "7, discard: the current APL has no polygon 0"
    "8, decide: ProcessWindow has not told its result, `summary`"
    "9, fill: ProcessWindow has not told its result, `summary`"
    "9, fill: pixels outside the area"
    "10, clip_keep: `clip_begin` comes before"
    "11, close: ProcessWindow has not told its result, `summary`"
    "2, pixel: `polygon` comes before"
    "5, ael_step: edge 1 is not in AEL"
    "6, ael_sort: not an order of the edges in AEL"
    "7, ael_add: the polygon has no edge 4"
    "8, pixel: pixels outside the area"
    "10, scanline: ShowLine has not told its result, `span`"
    "12, pixel: `span` comes before another row"
    "15, clear: the trace is closed"
    "2, pop_list: the stack of lists is empty"
    "3, push_list: an empty list"
    "4, push_list: the scene has no polygon 7"
    "7, clipped: not the next piece of the current list"
    "8, behind: no part inside is left"
    "10, row: pixels outside the area"
    "2, draw_line: `curve` comes before"
    "3, curve: the surface has no curve 1"
    "5, visibility: a flag is -1, 0, 1 or 2"
    "6, raise: a column outside the area"
    "8, draw_line: Horizon has not told its result, `horizon`"
    "11, draw_line: not between two neighbouring samples of the curve, from left to right"
    "2, fill: 0.5 is not a whole number, as a row or a column is"
    "3, row: 0.5 is not a whole number, as a row or a column is"
    "4, pixel: 1.5 is not a whole number, as a row or a column is"
    "3, scanline: 0.5 is not a whole number, as a row or a column is"
    "4, line: 0.5 is not a whole number, as a row or a column is"
    "5, columns: 3.5 is not a whole number, as a row or a column is"
    "6, pixel: 0.5 is not a whole number, as a row or a column is"
    "2, row: 0.5 is not a whole number, as a row or a column is"
    "3, pixel: 0.5 is not a whole number, as a row or a column is"
    "3, side_edge: 0.5 is not a whole number, as a row or a column is"
    "4, height: 0.5 is not a whole number, as a row or a column is"
    "5, visibility: 0.5 is not a whole number, as a row or a column is"
    "6, step: 0.5 is not a whole number, as a row or a column is"
    "7, raise: 0.5 is not a whole number, as a row or a column is"
    "8, lower: 0.5 is not a whole number, as a row or a column is"
    "9, horizon: 0.5 is not a whole number, as a row or a column is")
list(TRANSFORM complaints PREPEND "vidno: call ")
list(JOIN complaints "\n" complaints)

macro(test_wrong_use)
    foreach(detail IN ITEMS windows polygons signs)
        must_say("${complaints}\n" ./wrong_use ${detail})
        replay(wrong_warnock)
        replay(wrong_z_buffer)
        replay(wrong_weiler_atherton)
        must(${VIDNO} replay wrong_floating_horizon.jsonl -o wrong.states.jsonl)
        # The pixel (3, 1) of the rectangle of call 9 lies in the area; the lines of calls 9 and 11 have one pixel each.
        must_hold(wrong_warnock [=["e":"fill","at":"W10","rect":[3,1,1,1],"color":"#0000ff"]=])
        must_hold(wrong_z_buffer [=["e":"span","at":"Z14","row":0,"runs":[[1,2]]]=])
        must_hold(wrong_z_buffer [=["e":"span","at":"Z14","row":1,"runs":[[2,3]]]=])
        must_hold(wrong_weiler_atherton [=["e":"paint","at":"PR3","polygon":"a \u0022square\u0022\u000a","color":"#ff0000","runs":[[1,0,2]]]=])
        must_hold(wrong_floating_horizon [=["e":"draw_line","at":"FH6","segment":[2,3],"from":[2,1],"fromColumns":[2,2],"to":[3,1],"toColumns":[3,3]]=])
    endforeach()
endmacro()

# 0.1f is 0.100000001490116119384765625: as a double it takes 17 digits.
macro(test_crash)
    execute_process(COMMAND ./crash WORKING_DIRECTORY ${WORK} RESULT_VARIABLE crashed OUTPUT_QUIET ERROR_QUIET)
    execute_process(COMMAND ${VIDNO} replay crash.jsonl -o crash.ppm WORKING_DIRECTORY ${WORK} RESULT_VARIABLE code
                    ERROR_VARIABLE said)
    if(crashed EQUAL 0 OR NOT code EQUAL 1 OR NOT said MATCHES "2 events read, the last line is missing")
        message(FATAL_ERROR "The trace of a crash: ${crashed}, ${code}, ${said}")
    endif()
    must_hold(crash [=["kernel":"float"]=])
    must_hold(crash [=["plane":[0.10000000149011612,0,"inf","-inf"]]=])
    must_hold(crash [=["plane":[0.1,0.3333333333333333,"nan",1e+22]]=])
endmacro()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
foreach(compiler IN LISTS COMPILERS)
    foreach(source IN LISTS sources)
        get_filename_component(program ${source} NAME_WE)
        must(${compiler} -std=c++14 -Wall -Wextra -Wpedantic -Wshadow -Werror -I${student} ${source} -o ${program})
    endforeach()
    # The frames that students begin with, which paint nothing yet, compile and write complete traces.
    foreach(frame IN ITEMS warnock z_buffer weiler_atherton floating_horizon)
        must(${compiler} -std=c++14 -Wall -Wextra -Wpedantic -Wshadow -Werror ${student}/${frame}.cpp -o frame)
        must_say("" ./frame)
        must(${VIDNO} replay ${frame}.jsonl -o frame.states.jsonl)
    endforeach()
    must(./sha256)
    test_example(warnock warnock)
    test_example(z_buffer zbuffer)
    test_judged(weiler_atherton)
    test_judged(floating_horizon)
    test_wrong_use()
    test_crash()
endforeach()
