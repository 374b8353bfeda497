# Compiling to WebAssembly beside the native build: vidno_em(OUTPUT SOURCE [FLAG...]), once EMXX is found.
find_program(EMXX em++)
if(NOT EMXX)
    return()
endif()

# All of /usr/include would bring in native headers: only the libraries that are headers alone.
set(em_include ${PROJECT_BINARY_DIR}/em_include)
file(MAKE_DIRECTORY ${em_include})
foreach(header IN ITEMS glm/glm.hpp CGAL/version.h boost/version.hpp nlohmann/json.hpp fmt/format.h)
    get_filename_component(library ${header} DIRECTORY)
    find_path(${library}_include ${header} REQUIRED)
    file(CREATE_LINK ${${library}_include}/${library} ${em_include}/${library} SYMBOLIC)
endforeach()

# There is no GMP here, and no rounding mode but to nearest (rounded_up.h). Debian's em++ finds its parser by NODE_PATH only.
set(em_compiler ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs ${EMXX} -O3 -fwasm-exceptions)
set(em_flags
    -std=c++20 -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Werror -Wno-bitwise-instead-of-logical
    -DNDEBUG -DCGAL_DISABLE_GMP -DCGAL_ALWAYS_ROUND_TO_NEAREST -DFMT_HEADER_ONLY
    -isystem ${PROJECT_SOURCE_DIR}/trace/wasm/standard -I ${PROJECT_SOURCE_DIR}/lib -I ${PROJECT_SOURCE_DIR}/trace
    -isystem ${em_include} -include ${PROJECT_SOURCE_DIR}/trace/wasm/rounded_up.h
    -include ${PROJECT_SOURCE_DIR}/trace/wasm/split_double.h)

function(vidno_em output source)
    cmake_path(GET output PARENT_PATH directory)
    file(MAKE_DIRECTORY ${directory})
    cmake_path(ABSOLUTE_PATH source)
    add_custom_command(
        OUTPUT ${output}
        COMMAND ${em_compiler} ${em_flags} ${ARGN} -MD -MF ${output}.d -MT ${output} ${source} -o ${output}
        DEPENDS ${source}
        DEPFILE ${output}.d
        COMMENT "Compiling ${source} to WebAssembly"
        VERBATIM)
endfunction()
