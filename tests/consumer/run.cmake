# Installs the library from BUILD, builds the consumer against the installed tree alone, and compares its output with a picture drawn by
# hand. VERSION is the version of vidno. Run with -P.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})

macro(must)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endmacro()

must(${CMAKE_COMMAND} --install ${BUILD} --component library --prefix ${WORK}/prefix)
must(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
     -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_PREFIX_PATH=${WORK}/prefix -DVIDNO_VERSION=${VERSION})
must(${CMAKE_COMMAND} --build ${WORK}/build)

execute_process(COMMAND ${WORK}/build/curves OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
if(NOT printed STREQUAL "0: 0 to 3 at 1\n1: 0 to 3 at 5\n")
    message(FATAL_ERROR "The lines are\n${printed}")
endif()

execute_process(COMMAND ${WORK}/build/consumer OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
# The triangle holds the centres with column + row <= 3, the square those of columns 2 to 5 and rows 1 to 3.
set(picture "tttt....\ntttsss..\nttssss..\nt.ssss..\n")
if(NOT printed STREQUAL "${picture}${picture}")
    message(FATAL_ERROR "The consumer printed\n${printed}instead of, twice,\n${picture}")
endif()
