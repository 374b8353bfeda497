# `styles.cpp` under many names: in every style it is right, and of every mistake the report names the first false claim.
include(${CMAKE_CURRENT_LIST_DIR}/grading.cmake)
compile(${here}/styles.cpp)

function(grade_style name)
    file(COPY_FILE ${WORK}/styles ${WORK}/${name})
    grade_program(./${name} --no-sandbox ${ARGN})
    file(REMOVE ${WORK}/${name})
    set(status ${status} PARENT_SCOPE)
    set(report "${report}" PARENT_SCOPE)
endfunction()

# Orders of polygons, rows, columns and curves; parts of polygons; rules for outlines; numbers; kinds of claims.
foreach(name IN ITEMS
        zbuffer-fan
        zbuffer-halves
        zbuffer-rows
        zbuffer-rows-backwards
        zbuffer-rows-fan-leftward
        zbuffer-rows-halves-upward
        zbuffer-once_each
        zbuffer-once_each-fan
        zbuffer-once_each-backwards-upward
        zbuffer-backwards-halves
        zbuffer-leftward-upward
        zbuffer-halfopen
        zbuffer-halfopen-rows-fan
        zbuffer-halfopen-integer
        zbuffer-integer
        zbuffer-integer-fan-rows
        zbuffer-float
        zbuffer-float-rows-fan
        zbuffer-float-halfopen-backwards
        zbuffer-longdouble
        zbuffer-longdouble-rows-halves
        zbuffer-longdouble-fan-lines
        zbuffer-lines
        zbuffer-lines-cut
        zbuffer-lines-cut-rows
        zbuffer-lines-fan
        zbuffer-lines-halves-rows
        zbuffer-single
        zbuffer-single-rows-fan
        warnock-backwards
        warnock-fill_by_pixels
        warnock-fill_by_pixels-backwards
        warnock-by_rows
        warnock-by_rows-cut-backwards
        warnock-never_single
        warnock-never_single-longdouble
        warnock-longdouble
        warnock-float
        warnock-float-compares
        warnock-compares-tests
        warnock-integer-tests
        warnock-boxes
        warnock-boxes-tests-compares-backwards
        warnock-halfopen
        warnock-single-fill_by_pixels
        weiler-backwards
        weiler-joined
        weiler-fan
        weiler-fan-backwards
        weiler-single
        horizon-once_each
        horizon-leftward
        horizon-once_each-leftward
        horizon-columns
        horizon-columns-backwards
        horizon-backwards
        horizon-heights
        horizon-columns-heights
        horizon-float
        horizon-float-once_each
        horizon-longdouble
        horizon-longdouble-columns-leftward
        horizon-single-columns)
    grade_style(${name})
    must_say(${name} 0 "Right on all ")
endforeach()

function(must_be_reported name claim)
    grade_style(${name} --first)
    must_say(${name} 1 "the program: ${claim}\n")
endfunction()

# The far square covers the area. Of its two triangles only the one above the diagonal is drawn.
must_be_reported(zbuffer-fan-triangle_lost "A is done, and pixel (0, 1) shows nothing of what came so far")
# The last row.
must_be_reported(zbuffer-row_lost "A is done, and pixel (0, 15) shows nothing of what came so far")
must_be_reported(zbuffer-rows-row_lost "A is done, and pixel (0, 15) shows nothing of what came so far")
# The last column.
must_be_reported(zbuffer-column_lost "A is done, and pixel (15, 0) shows nothing of what came so far")
must_be_reported(zbuffer-rows-column_lost "A is done, and pixel (15, 0) shows nothing of what came so far")
# A square of the scene lies at -0.75.
must_be_reported(zbuffer-starts_late "the depths of the Z-buffer start at -0.5")
# The corner (5, 3) is in the triangle, the centre is not.
must_be_reported(zbuffer-corners "A is drawn at pixel (5, 3)")
# B, the second polygon, is told to be 0.004 nearer than it is, at 0.5.
must_be_reported(zbuffer-bias "the depth of B at (9.5, 7.5) is 0.504")
must_be_reported(zbuffer-bias-single "the depth of B at (9.5, 7.5) is 0.504")
# The float next to 0.504.
must_be_reported(zbuffer-bias-float "the depth of B at (9.5, 7.5) is 0.5040000081062317")
# 1/4 + 2^-24, a float.
must_be_reported(zbuffer-small_bias "the depth of A at (1.5, 1.5) is 0.2500000596046448")
# -27/56 + 2^-24, which is no float.
must_be_reported(zbuffer-small_bias-single "the depth of A at (1.5, 2.5) is -0.4821427975382124")
# -123/256; the depth is -27/56.
must_be_reported(zbuffer-rounded "the depth of A at (1.5, 2.5) is -0.48046875")
must_be_reported(zbuffer-rounded-single "the depth of A at (1.5, 2.5) is -0.48046875")
must_be_reported(zbuffer-painter "0.125 is nearer than 0.5")
must_be_reported(zbuffer-farthest "0.25 is not nearer than -1.5")
must_be_reported(zbuffer-rows-farthest "0.25 is not nearer than -1.5")
# 1/4 + 2^-19.
must_be_reported(zbuffer-epsilon "0.2500019073486328 is not nearer than 0.25")
must_be_reported(zbuffer-lie_stored "the depth stored for pixel (1, 1) is -2")
must_be_reported(zbuffer-lie_depth "the depth of A at (1.5, 1.5) is 0.2501")
must_be_reported(zbuffer-lie_depth-longdouble "the depth of A at (1.5, 1.5) is 0.2501")
# From 1 + 11/36 to 2 + 19/28, told 1/16 too far.
must_be_reported(zbuffer-lines-lie_line "on row 1 A goes from x = 1.3055555555555556 to 2.741071428571429")
must_be_reported(zbuffer-lines-lie_line-fan-rows "on row 1 A goes from x = 1.3055555555555556 to 2.741071428571429")
must_be_reported(warnock-part_lost "these are all parts of the window (0, 0) of 16 x 16")
must_be_reported(warnock-part_lost-backwards "these are all parts of the window (0, 0) of 16 x 16")
must_be_reported(warnock-column_lost "A is drawn in the window (0, 0) of 4 x 4, and pixel (3, 0) shows the background")
# It is 6.25.
must_be_reported(warnock-boxes-lie_box "xmax of the box of A is 6.5")
must_be_reported(warnock-lie_case "the window (0, 0) of 16 x 16 is no larger than a pixel")
# From 1 + 11/36, told 1/8 too far to the left.
must_be_reported(warnock-by_rows-lie_row "on row 1 A goes from x = 1.1805555555555556 to 2.678571428571429")
# All rows are refused.
must_be_reported(warnock-by_rows-between_rows "A is drawn in the window (0, 0) of 8 x 8, and pixel (1, 1) shows the background")
must_be_reported(warnock-tests-lie_inside "(4.5, 2.5) is outside A")
must_be_reported(warnock-compares-lie_nearer "0.125 is not nearer than -1.5")
must_be_reported(warnock-lie_depth "the depth of A at (4.5, 2.5) is 0.1251")
must_be_reported(warnock-bias "the depth of B at (4.5, 2.5) is 0.504")
must_be_reported(warnock-bias-single "the depth of B at (4.5, 2.5) is 0.504")
must_be_reported(warnock-farthest "pixel (4, 2) shows A")
# The triangles have the areas 10 + 13/16 and 10 + 25/32.
must_be_reported(weiler-part_lost "the visible regions have the area 10.8125")
# A is shown again instead of B.
must_be_reported(weiler-instead "A is visible in a region of area 10.8125")
must_be_reported(weiler-twice "B is visible in a region of area 10.78125")
must_be_reported(weiler-reversed "the visible region of A runs counterclockwise around an area of 10.8125")
must_be_reported(weiler-moved "the visible region of A has a vertex at (1.375, 1.25)")
must_be_reported(weiler-moved-single "the visible region of A has a vertex at (1.375, 1.25)")
# B hides 6 x 5.5 of it.
must_be_reported(weiler-hidden_too "A is visible in a region of area 256")
must_be_reported(weiler-farthest "A is visible in a region of area 33")
must_be_reported(weiler-joined-twice "the visible region of B has an area of 10.78125 more than once")
must_be_reported(weiler-fan-reversed "the visible region of A runs counterclockwise around an area of 10.8125")
must_be_reported(horizon-curve_lost "curve 0 is done, and it is not drawn at x = 0")
must_be_reported(horizon-columns-curve_lost "curve 0 is done, and it is not drawn at x = 0")
must_be_reported(horizon-edges_lost "curve 2 is visible from x = 8.37037037037037 to 9")
must_be_reported(horizon-ends_lost "curve 2 is done, and it is not drawn at x = 8.796875")
must_be_reported(horizon-hidden_too "curve 2 is visible from x = 0 to 1")
must_be_reported(horizon-upper_only "curve 1 is done, and it is not drawn at x = 0")
must_be_reported(horizon-lie_height "at x = 0 curve 0 is at y = 8.001")
must_be_reported(horizon-heights-lie_flag "the flag of curve 1 over column 0 is -1")
