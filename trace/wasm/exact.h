// Included before everything else where CGAL is used; compiled once.
#pragma once

#include "rounded_up.h"
#include "integer_gcd.h"
#include "split_double.h"
#include "vidno/admission.h"
#include "vidno/kernels/filtered_regions.h"
