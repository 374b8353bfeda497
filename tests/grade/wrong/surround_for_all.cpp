// Warnock's algorithm, wrong: hasSurround is set once, and kept for all windows that come after.
#include "../right/warnock_style.h"

int first_surrounding = -1;

struct SurroundForAll : PlainStyle {
    static int hiding(int found) {
        if (found >= 0) first_surrounding = found;
        return first_surrounding;
    }
};

int main() { run_as<SurroundForAll>("surround_for_all.jsonl"); }
