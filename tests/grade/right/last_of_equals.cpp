// Warnock's algorithm, right: the last of several equally near polygons shows.
#include "warnock_style.h"

struct LastOfEquals : PlainStyle {
    static bool takes(double z, double nearest) { return z >= nearest; }
};

int main() { run_as<LastOfEquals>("last_of_equals.jsonl"); }
