# Figures of lessons under pdfLaTeX: alone, inside a document with another font, and as a slide. No character may be missing, nothing
# may overflow, and the text must be there. Run with -P.
cmake_minimum_required(VERSION 3.25)

# An installation may have only a part of TeX. Debian has the rest in texlive-latex-extra, texlive-pictures, texlive-lang-cyrillic, cm-super,
# lmodern and poppler-utils.
set(files standalone.cls beamer.cls tikz.sty cmap.sty lmodern.sty lmr10.pfb t2aenc.def lacodes.mf sfrm1000.pfb)
foreach(program IN ITEMS pdflatex kpsewhich pdfinfo pdftotext)
    find_program(${program} ${program})
    if(NOT ${program})
        list(APPEND missing ${program})
    endif()
endforeach()
if(kpsewhich)
    foreach(file IN LISTS files)
        execute_process(COMMAND ${kpsewhich} ${file} OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE status)
        if(NOT status EQUAL 0)
            list(APPEND missing ${file})
        endif()
    endforeach()
endif()
if(missing)
    list(JOIN missing ", " missing)
    execute_process(COMMAND ${CMAKE_COMMAND} -E echo "skipped: ${missing}: missing")
    return()
endif()

set(lessons ${CMAKE_CURRENT_LIST_DIR}/../../lessons)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

macro(must)
    execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
endmacro()

function(typeset name pages text)
    must(${pdflatex} -interaction=nonstopmode -halt-on-error ${name}.tex)
    file(READ ${WORK}/${name}.log log)
    if(log MATCHES "Missing character|Overfull")
        message(FATAL_ERROR "${name}.tex: ${CMAKE_MATCH_0}\n${log}")
    endif()
    must(${pdfinfo} ${name}.pdf)
    if(NOT said MATCHES "Pages: +${pages}\n")
        message(FATAL_ERROR "${name}.pdf has not ${pages} pages:\n${said}")
    endif()
    must(${pdftotext} -layout ${name}.pdf -)
    string(FIND "${said}" "${text}" found)
    if(found EQUAL -1)
        message(FATAL_ERROR "${name}.pdf lacks ${text}:\n${said}")
    endif()
endfunction()

set(all --show picture,windows,list,listing)
must(${VIDNO} trace ${lessons}/05-polygon-clip/scene.json -o clip.jsonl)
must(${VIDNO} trace ${lessons}/07-z-buffer-ael/scene.json --method zbuffer --kernel exact -o ael.jsonl)
# As printed, a run may fault, which is exit 1.
execute_process(COMMAND ${VIDNO} trace ${lessons}/09-usual-mistakes/scene.json --edition printed -o printed.jsonl
                WORKING_DIRECTORY ${WORK} ERROR_QUIET)

must(${VIDNO} figure clip.jsonl --step 90 ${all} -o clip.tex)
typeset(clip 1 "while AW")
must(${VIDNO} figure ael.jsonl --step 90 ${all} --language ru -o ael.tex)
typeset(ael 1 "Активные рёбра (AEL)")
must(${VIDNO} figure printed.jsonl --steps 1..30:10 --greyscale -o strip.tex)
typeset(strip 1 "(c) edge 1 of Q has")
must(${VIDNO} figure clip.jsonl --steps 80..84 --beamer ${all} -o slide.tex)
typeset(slide 5 "U = (8, 8) 8 × 8")

# Names in another script than the figure's language: each character of the font encodings, and one that pdfLaTeX lacks.
file(WRITE ${WORK}/names.json [==[{"window": {"x": 0, "y": 0, "width": 4, "height": 4}, "polygons": [
    {"id": "Щука", "vertices": [[0, 0, 0], [4, 0, 0], [4, 4, 0]]},
    {"id": "Łódź Đà ‚þ‘", "vertices": [[0, 0, 0.5], [2, 0, 0.5], [0, 2, 0.5]]}]}]==])
must(${VIDNO} trace names.json -o names.jsonl)
foreach(language IN ITEMS en ru)
    must(${VIDNO} figure names.jsonl --step 9 --show picture,list --language ${language} -o names-${language}.tex)
    typeset(names-${language} 1 "Щука")
endforeach()

file(WRITE ${WORK}/paper.tex "\\documentclass{article}\n\\usepackage[T2A]{fontenc}\n\\usepackage{cmap,tikz}\n"
    "\\begin{document}\n\\noindent\\input{ael}\n\nThe paper goes on.\n\\end{document}\n")
typeset(paper 1 "The paper goes on")
