# `vidno grade` calls wrong programs wrong, and names the mistake only if it is one of the table.
include(${CMAKE_CURRENT_LIST_DIR}/grading.cmake)

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
