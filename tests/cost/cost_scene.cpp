// Admitted apart from the runs: CGAL in their unit would change what the compiler inlines.
#include "cost_scene.h"

#include "bench/overdraw.h"

vidno::AdmittedScene cost_scene() { return vidno::random_triangles(200, 128, 4); }
