# Compiling to WebAssembly beside the native build, once EMXX is found: vidno_em(OUTPUT SOURCE [USES_CGAL] [FLAG...]).
find_program(EMXX em++)
if(NOT EMXX)
    return()
endif()

# All of /usr/include would bring in native headers, so only the header-only libraries are linked.
set(em_include ${PROJECT_BINARY_DIR}/em_include)
file(MAKE_DIRECTORY ${em_include})
foreach(header IN ITEMS glm/glm.hpp CGAL/version.h boost/version.hpp nlohmann/json.hpp fmt/format.h
        fast_float/fast_float.h CLI/CLI.hpp)
    get_filename_component(library ${header} DIRECTORY)
    find_path(${library}_include ${header} REQUIRED)
    file(CREATE_LINK ${${library}_include}/${library} ${em_include}/${library} SYMBOLIC)
endforeach()

# There is no GMP here, and the only rounding mode is to nearest (rounded_up.h). Debian's em++ finds its parser only by NODE_PATH.
set(em_compiler ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs ${EMXX} -O3 -fwasm-exceptions -mbulk-memory)
set(em_flags
    -std=c++20 -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Werror -Wno-bitwise-instead-of-logical
    -DNDEBUG -DCGAL_DISABLE_GMP -DCGAL_ALWAYS_ROUND_TO_NEAREST -DFMT_HEADER_ONLY
    -isystem ${PROJECT_SOURCE_DIR}/trace/wasm/standard -I ${PROJECT_SOURCE_DIR}/lib -I ${PROJECT_SOURCE_DIR}/trace
    -isystem ${em_include}
    # The module names files in its messages. Its bytes must not depend on the folder in which it was built.
    -fmacro-prefix-map=${PROJECT_BINARY_DIR}/=)

# The headers that CGAL needs are included before it, precompiled.
set(em_exact ${PROJECT_BINARY_DIR}/em_include/exact.h.pch)
if(NOT TARGET em_exact_header)
    add_custom_command(
        OUTPUT ${em_exact}
        COMMAND ${em_compiler} ${em_flags} -x c++-header -MD -MF ${em_exact}.d -MT ${em_exact}
                ${PROJECT_SOURCE_DIR}/trace/wasm/exact.h -o ${em_exact}
        DEPENDS ${PROJECT_SOURCE_DIR}/trace/wasm/exact.h
        DEPFILE ${em_exact}.d
        COMMENT "Precompiling CGAL for WebAssembly"
        VERBATIM)
    add_custom_target(em_exact_header DEPENDS ${em_exact})
endif()

function(vidno_em output source)
    cmake_path(GET output PARENT_PATH directory)
    file(MAKE_DIRECTORY ${directory})
    cmake_path(ABSOLUTE_PATH source)
    set(flags ${ARGN})
    set(header)
    if(USES_CGAL IN_LIST flags)
        list(REMOVE_ITEM flags USES_CGAL)
        set(header em_exact_header ${em_exact})
        list(PREPEND flags -include-pch ${em_exact})
    endif()
    add_custom_command(
        OUTPUT ${output}
        COMMAND ${em_compiler} ${em_flags} ${flags} -MD -MF ${output}.d -MT ${output} ${source} -o ${output}
        DEPENDS ${source} ${header}
        DEPFILE ${output}.d
        COMMENT "Compiling ${source} to WebAssembly"
        VERBATIM)
endfunction()
