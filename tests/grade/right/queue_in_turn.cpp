// Warnock's algorithm, right: breadth first. It tells each window when the window's turn comes.
#include "warnock_style.h"

struct QueueInTurn : PlainStyle {
    static const bool first_in_first_out = true;
    static const bool tells_in_turn = true;
};

int main() { run_as<QueueInTurn>("queue_in_turn.jsonl"); }
