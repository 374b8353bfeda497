# The test of figures under pdfLaTeX where only a part of TeX is installed: it is skipped, and names what is missing. Run with -P.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})

# Runs the test with these programs alone. Each finds nothing and fails, as pdflatex without a class does.
function(expect_skipped missing)
    set(folder ${WORK}/programs)
    file(REMOVE_RECURSE ${folder})
    foreach(program IN LISTS ARGN)
        file(WRITE ${folder}/${program} "#!/bin/sh\nexit 1\n")
        file(CHMOD ${folder}/${program} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
    endforeach()
    # CMake also looks for programs where it is installed itself.
    execute_process(COMMAND ${CMAKE_COMMAND} -E env PATH=${folder} ${CMAKE_COMMAND} -DCMAKE_FIND_USE_CMAKE_SYSTEM_PATH=OFF
                            -DVIDNO=vidno -DWORK=${WORK}/tex -P ${CMAKE_CURRENT_LIST_DIR}/run.cmake
                    OUTPUT_VARIABLE said RESULT_VARIABLE status)
    if(NOT status EQUAL 0 OR NOT said STREQUAL "skipped: ${missing}: missing\n")
        message(FATAL_ERROR "with ${ARGN} alone, the test says: ${said}")
    endif()
endfunction()

set(files "standalone.cls, beamer.cls, tikz.sty, cmap.sty, lmodern.sty, lmr10.pfb, t2aenc.def, lacodes.mf, sfrm1000.pfb")
expect_skipped("${files}" pdflatex kpsewhich pdfinfo pdftotext)
expect_skipped("kpsewhich" pdflatex pdfinfo pdftotext)
expect_skipped("pdflatex, pdftotext, ${files}" kpsewhich pdfinfo)
