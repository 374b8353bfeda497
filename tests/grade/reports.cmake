# `vidno grade` says how a program crashed, which limit it exceeded and what it cannot grade. It grades folders and traces too.
include(${CMAKE_CURRENT_LIST_DIR}/grading.cmake)

# Uses a scene with a short trace to save time. A slow machine needs seconds to reach the limits of output and of memory.
function(must_end program words)
    set(seconds 30)
    if(program STREQUAL endless_loop)
        set(seconds 1)
    endif()
    grade(${here}/${program}.cpp --seconds ${seconds} --scenes ${student}/../05-polygon-clip/scene.json)
    must_say(${program} 1 "The program ${words}")
endfunction()

must_end(crash "crashed (SIGSEGV): it accessed memory")
must_end(endless_loop "did not end within 1 s")
must_end(endless_output "")  # exceeds the limit of time or of output, depending on the speed of the disk
must_end(endless_printing "wrote more than 64 MiB")
must_end(endless_memory "asked for more than 512 MiB of memory")

# A reason that applies to each scene is given once.
file(WRITE ${WORK}/fails.cpp "int main() { return 3; }\n")
grade(${WORK}/fails.cpp)
must_say(fails 1 "not judged Two triangles apart: no trace was written: ")
must_say(fails 1 "not judged A near square before a far one: the same\n")

compile(${here}/right/warnock.cpp ${here}/right/queue.cpp ${here}/wrong/four_vertices.cpp ${here}/surround_kept.cpp)

# Grading a folder writes a table, and a report on each program.
file(MAKE_DIRECTORY ${WORK}/homework)
file(COPY ${WORK}/queue ${WORK}/four_vertices DESTINATION ${WORK}/homework)
foreach(table IN ITEMS table.csv table.json)
    grade_program(homework -o ${table} --language ru)
    must_say(homework 1 "Случайных сцен 8, начальное число ")
    must_say(homework 1 "queue: верно")
    foreach(report IN ITEMS table/queue.txt table/four_vertices.txt)
        if(NOT EXISTS ${WORK}/${report})
            message(FATAL_ERROR "${report} is missing")
        endif()
    endforeach()
endforeach()
file(READ ${WORK}/table.csv report)
must_say(table.csv 1 "\n\"queue\",\"right\",")
must_say(table.csv 1 "\n\"four_vertices\",\"wrong\",")
file(READ ${WORK}/table.json table)
string(JSON verdict GET "${table}" 0 verdict)
string(JSON scene GET "${table}" 0 first scene)
if(NOT verdict STREQUAL "wrong" OR NOT scene STREQUAL "Пять вершин, шесть и девять")
    message(FATAL_ERROR "table.json: ${table}")
endif()
file(READ ${WORK}/table/four_vertices.txt report)
must_say(table/four_vertices.txt 1 "Неверно: ")

# In the sandbox a program sees only its own files and no network. If no sandbox can be created, the report says so.
grade(${here}/nosy.cpp --first)
string(FIND "${report}" "No sandbox: " found)
if(found EQUAL -1)
    must_say(nosy 1 "| no secret, no network")
else()
    message(STATUS "no sandbox here")
endif()
grade_program(./nosy --first --no-sandbox)
must_not_say(nosy "No sandbox: ")

# If something cannot be graded, one line says why.
function(must_refuse reason)
    execute_process(COMMAND ${VIDNO} grade ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status
                    ERROR_VARIABLE report OUTPUT_VARIABLE printed)
    must_say("${ARGN}" 2 "${reason}")
    if(NOT printed STREQUAL "")
        message(FATAL_ERROR "${ARGN}: besides the reason it printed:\n${printed}")
    endif()
endfunction()
find_program(TRUE_PROGRAM true REQUIRED)
must_refuse("no trace was written: " ${TRUE_PROGRAM})
must_refuse("No such file or directory" ./nothing)
must_refuse("not executable: compile the source first" ${here}/crash.cpp)
must_refuse("report.pdf: not .html" ./warnock -o report.pdf)
must_refuse("homework is a folder, so -o must name a table, .csv or .json" homework)
execute_process(COMMAND ${VIDNO} trace ${student}/../05-polygon-clip/scene.json --kernel exact -o exact.jsonl
                WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
must_refuse("only float and double are judged" exact.jsonl)
must_refuse("no trace was written: " ${TRUE_PROGRAM} --scenes ${student}/../15-floating-horizon/scene.json)

# An existing trace can be graded too.
execute_process(COMMAND ./surround_kept WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${VIDNO} grade surround_kept.jsonl WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status
                OUTPUT_VARIABLE report)
must_say(surround_kept.jsonl 1 "It behaves like a usual mistake, surround-kept: ")
