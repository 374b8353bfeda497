# Students may replace single procedures in a run of vidno. Admission needs the numbers of CGAL.
include(${CMAKE_CURRENT_LIST_DIR}/grading.cmake)

set(root ${here}/../..)
set(flags -std=c++20 -Wall -Wextra -Wpedantic -Wshadow -Werror -I${student} -ffp-contract=off -I${root}/lib -I${root}/trace)
# A program may include the header in several files.
file(WRITE ${WORK}/other.cpp "#include \"vidno_procedures.h\"\n")
set(libraries other.cpp -lgmp -lmpfr)
grade(${student}/surround_test.cpp)
set(libraries -lgmp -lmpfr)
must_differ(surround_test "another rule for points of an outline")
grade(${here}/half_plane_clip.cpp)
must_say(half_plane_clip 1 "the program: the part of B in the window (8, 0) of 8 x 8 has 3 vertices")
must_say(half_plane_clip 1 "(10.75, 11.25, 0.5) lies outside the window")
