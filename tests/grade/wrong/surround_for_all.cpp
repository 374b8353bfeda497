// Warnock's algorithm, wrong: it sets hasSurround once and keeps it for all later windows.
#include "../right/warnock_style.h"

int first_surrounding = -1;

struct SurroundForAll : PlainStyle {
    static int hiding(int found) {
        if (found >= 0) first_surrounding = found;
        return first_surrounding;
    }
};

int main() { run_as<SurroundForAll>("surround_for_all.jsonl"); }
