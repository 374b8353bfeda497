# Tests `vidno grade` on students' programs. It must pass the right ones and list their differences, name the mistake of each wrong one, and
# say how a program crashed or which limit it exceeded. Each program is compiled once. Run with -P; COMPILER, VIDNO and WORK are given.
cmake_minimum_required(VERSION 3.25)
set(here ${CMAKE_CURRENT_LIST_DIR})
set(student ${here}/../../lessons/student)

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

# Compile the header once, too.
set(flags -std=c++14 -Wall -Wextra -Wpedantic -Wshadow -Werror -I${student})
execute_process(COMMAND ${COMPILER} ${flags} -x c++-header ${student}/example.h -o ${WORK}/example.h.gch
                COMMAND_ERROR_IS_FATAL ANY)
list(APPEND flags -I${WORK} -include ${WORK}/example.h)
file(WRITE ${WORK}/example.h "#include \"${student}/example.h\"\n")

# Builds a student's program and grades it. Sets `status` and `report`. Further arguments are options of `vidno grade`.
function(grade source)
    get_filename_component(program ${source} NAME_WE)
    execute_process(COMMAND ${COMPILER} ${flags} ${source} -o ${program} ${libraries} WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
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
function(must_be_right program)
    grade(${here}/right/${program}.cpp)
    must_differ(${program} ${ARGN})
endfunction()

function(must_make program mistake)
    grade(${here}/${program}.cpp)
    must_say(${program} 1 "It behaves like a usual mistake, ${mistake}: ")
    must_say(${program} 1 "The smallest scene that shows it:")
endfunction()

# The report must call the program wrong and name no mistake of the table.
function(must_be_wrong program text)
    grade(${here}/wrong/${program}.cpp --first)
    must_say(${program} 1 "${text}")
    must_not_say(${program} "It behaves like")
endfunction()

# Uses a scene with a short trace to save time. A slow machine needs seconds to reach the limits of output and of memory.
function(must_end program words)
    set(seconds 30)
    if(program STREQUAL endless_loop)
        set(seconds 1)
    endif()
    grade(${here}/${program}.cpp --seconds ${seconds} --scenes ${student}/../05-polygon-clip/scene.json)
    must_say(${program} 1 "The program ${words}")
endfunction()

# Right programs: other orders, windows, tests, rules for outlines, numbers and languages.
set(outline "another rule for points of an outline")
set(equal "another one of equally near polygons")
set(windows "other windows")
set(parts "the parts of a window in another order")
set(polygons "the polygons in another order")
must_be_right(warnock "${outline}")
must_be_right(z_buffer "${outline}")
must_be_right(recursion "${outline}" "recursion instead of the stack")
must_be_right(other_order "${parts}" "${polygons}" "outlines in the opposite direction" "${outline}")
must_be_right(half_open_float "${outline}" "numbers in float")
grade(${here}/right/queue.cpp)
must_differ(queue "${outline}" "${equal}" "the windows breadth first")
must_say(queue 0 "clipped polygons; 0 polygons in lists, 0 surround tests")
must_be_right(queue_in_turn "${outline}" "${equal}" "the windows breadth first")
must_be_right(halves "${outline}" "${equal}" "${windows}")
must_be_right(whole_pixels "${outline}" "${equal}" "${windows}")
must_be_right(ray_crossings "${outline}" "${equal}")
must_be_right(angles "${outline}" "${equal}")
must_be_right(last_of_equals "${outline}" "${equal}")
must_be_right(half_planes)
must_be_right(backwards "${polygons}" "${outline}" "${equal}")
must_be_right(columns)
must_be_right(barycentric "${outline}" "${equal}")
must_be_right(between_edges "${outline}")
must_be_right(weiler_atherton)
must_be_right(floating_horizon)
must_be_right(strict_horizon "curves that touch a horizon are hidden")
must_be_right(each_from_scratch "numbers in float")
grade_program(${here}/right/zbuffer.py)
must_differ(zbuffer.py "${outline}")
grade_program(${here}/right/warnock.py)
must_differ(warnock.py "recursion instead of the stack")

# Claims that a trace leaves out are not judged, but a trace must make the claims of the level asked for.
grade_program(./recursion --detail polygons)
must_say(recursion 1 "Not told, though level polygons is asked for: depths, surround tests.")
grade_program(./warnock --detail signs)
must_say(warnock 0 "Right on all ")

# Programs in another style with mistakes of the table of deviations.
must_make(depths_not_cleared depths-not-cleared)
must_make(boundary_outside boundary-outside)
must_make(integer_division integer-division)
must_make(surround_kept surround-kept)

# Grades right/${right}.cpp with changes, as a program of this name. Each pair of strings is the right text and what the student wrote instead.
function(grade_changed name right)
    file(READ ${here}/right/${right}.cpp text)
    string(REPLACE "#include \"../" "#include \"${here}/" text "${text}")
    math(EXPR last "${ARGC} - 2")
    foreach(i RANGE 2 ${last} 2)
        math(EXPR j "${i} + 1")
        string(REPLACE "${ARGV${i}}" "${ARGV${j}}" changed "${text}")
        if(changed STREQUAL text)
            message(FATAL_ERROR "${name}: right/${right}.cpp does not have \"${ARGV${i}}\"")
        endif()
        set(text "${changed}")
    endforeach()
    file(WRITE ${WORK}/${name}.cpp "${text}")
    grade(${WORK}/${name}.cpp --first)
    set(status ${status} PARENT_SCOPE)
    set(report "${report}" PARENT_SCOPE)
endfunction()

# The same mistakes, made in right/warnock.cpp.
function(must_be_named mistake)
    must_say(${mistake} 1 "It behaves like a usual mistake, ${mistake}: ")
endfunction()
grade_changed(depth-sign-reversed warnock "z = -(plane.a" "z = (plane.a")
must_be_named(depth-sign-reversed)
grade_changed(clip-order-reversed warnock "{{window.x, window.y}, {window.x, bottom}, {right, bottom}, {right, window.y}}"
              "{{right, window.y}, {right, bottom}, {window.x, bottom}, {window.x, window.y}}")
must_be_named(clip-order-reversed)
grade_changed(y-flipped warnock "    Warnock(scene, trace);" "    Scene flipped = scene;
    for (Polygon& polygon : flipped.polygons) {
        for (Vertex& v : polygon.vertices) v.y = 2 * scene.area.y + scene.area.height - v.y;
    }
    Warnock(flipped, trace);")
must_be_named(y-flipped)
grade_changed(one-list warnock "    std::vector<Active> polygons;  // APL\n};" "    static std::vector<Active> polygons;  // APL\n};
std::vector<Active> Window::polygons;" ", 1, {}}" ", 1}" "push({x, y, half, window.polygons})" "push({x, y, half})")
must_be_named(one-list)

# The grader once passed these programs or named the wrong mistake. Their runs take other steps than those of any mistake of the table. Some
# make a mistake of the table in another place: `y_flipped` flips the picture and not the polygons.
must_be_wrong(four_vertices "first on \"Five vertices, six and nine\"")
must_be_wrong(not_by_a_hundredth "first on \"")
must_be_wrong(starts_at_minus_one "first on \"At both ends of the range\"")
must_be_wrong(drops_on_the_line "first on \"")
must_be_wrong(surround_for_all "first on \"A near square before a far one\"")
must_be_wrong(hidden_by_centre "first on \"Two walls through each other\"")
must_be_wrong(no_algorithm "first on \"Two triangles apart\"")
must_be_wrong(y_flipped "first on \"")
must_be_wrong(one_list "first on \"")
must_be_wrong(clip_order_reversed "first on \"")
must_be_wrong(depth_sign_reversed "first on \"")
must_be_wrong(halves_of_one "first on \"An area of 13 x 7\"")
grade(${here}/wrong/first_three.cpp --first)
must_say(first_three 1 "It behaves like the defect X-W6 of the printed text")

# Mistakes in Weiler and Atherton's algorithm and in the floating horizon. Those of the first are not in the table.
function(must_be_called_wrong name right)
    grade_changed(${name} ${right} ${ARGN})
    must_say(${name} 1 "Wrong on ")
    must_not_say(${name} "It behaves like")
endfunction()
must_be_called_wrong(far_ones weiler_atherton "depth_of(part.polygon, p) - depth_of(than, p)"
                     "depth_of(than, p) - depth_of(part.polygon, p)")
must_be_called_wrong(ground_lost weiler_atherton "        nearer.push_back(clip)" "        if (false) nearer.push_back(clip)")
must_be_called_wrong(outside_lost weiler_atherton "        push(outside)" "        if (false) push(outside)")
must_be_called_wrong(never_split weiler_atherton "return half_of(part.outline, before)"
                     "return before(centre_of(part.outline)) > 0 ? part.outline : Convex{}")

function(must_have_defect defect)
    grade_changed(${defect} floating_horizon ${ARGN})
    must_say(${defect} 1 "It behaves like the defect ${defect} of the printed text")
endfunction()
must_have_defect(X-H1 "below = !lower.is || y >= lower.y" "below = !lower.is")
must_have_defect(X-H2 "intersection(from, to, x, next, is)" "intersection(from, to, x, next, was == 0 ? 1 : is)")
must_have_defect(X-H3 "upper_(std::size_t(area_.width), Cell{false, 0})"
                 "upper_(std::size_t(area_.width), Cell{true, double(area_.y + area_.height)})"
                 "lower_(std::size_t(area_.width), Cell{false, 0})" "lower_(std::size_t(area_.width), Cell{true, double(area_.y)})")
must_have_defect(X-H5 "const int next = x + 1" "const int next = to.x")
must_have_defect(X-H6 "above && below ? 2" "above && below ? 1")
must_be_called_wrong(no_side_edges floating_horizon "        if (first <= last) raise" "        if (false) raise")
must_be_called_wrong(nearest_column floating_horizon "return {x + t, y + (next_y - y) * t}"
                     "return t < 0.5 ? Place{double(x), y} : Place{x + 1.0, next_y}")
must_be_called_wrong(horizon_not_raised floating_horizon "raise(from, to, int(std::ceil(first.x)), int(std::floor(last.x)))"
                     "raise(from, to, int(std::ceil(first.x)) + 1, int(std::floor(last.x)))")
must_be_called_wrong(edges_to_their_ends floating_horizon "std::min(from.x, to.x) + 1" "std::min(from.x, to.x)")

must_end(crash "crashed (SIGSEGV): it reached for memory")
must_end(endless_loop "did not end within 1 s")
must_end(endless_output "")  # exceeds the limit of time or of output, depending on the speed of the disk
must_end(endless_printing "wrote more than 64 MiB")
must_end(endless_memory "asked for more than 512 MiB of memory")

# Grading a folder writes a table, and a report on each program.
file(MAKE_DIRECTORY ${WORK}/homework)
file(COPY ${WORK}/queue ${WORK}/four_vertices DESTINATION ${WORK}/homework)
foreach(table IN ITEMS table.csv table.json)
    grade_program(homework -o ${table} --language ru)
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
if(NOT verdict STREQUAL "wrong" OR NOT scene STREQUAL "Five vertices, six and nine")
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
                    ERROR_VARIABLE report OUTPUT_QUIET)
    must_say("${ARGN}" 2 "${reason}")
endfunction()
find_program(TRUE_PROGRAM true REQUIRED)
must_refuse("no trace was written: " ${TRUE_PROGRAM})
must_refuse("No such file or directory" ./nothing)
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

# A student may replace single procedures in a run of vidno. Admission needs the numbers of CGAL.
set(libraries -lgmp -lmpfr)
set(root ${here}/../..)
set(flags -std=c++20 -Wall -Wextra -Wpedantic -Wshadow -Werror -I${student} -ffp-contract=off -I${root}/lib -I${root}/trace)
grade(${student}/surround_test.cpp)
must_differ(surround_test "${outline}")
grade(${here}/half_plane_clip.cpp)
must_say(half_plane_clip 1 "the program: the part of B in the window (8, 0) of 8 x 8 has 3 vertices")
must_say(half_plane_clip 1 "(10.75, 11.25, 0.5) lies outside the window")
