// Included before everything else where CGAL is used; compiled once.
#pragma once

#include "integer_gcd.h"
#include "quotient.h"
#include "rounded_up.h"
#include "split_double.h"
#include "vidno/admission.h"
#include "vidno/kernels/filtered_regions.h"
