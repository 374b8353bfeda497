/// The scene whose runs are counted.
#pragma once

#include <vidno/admitted.h>

vidno::AdmittedScene cost_scene();
