// Warnock's algorithm, right: breadth first. It tells each window when the window joins the queue.
#include "warnock_style.h"

struct Queue : PlainStyle {
    static const bool first_in_first_out = true;
};

int main() { run_as<Queue>("queue.jsonl"); }
