// Calls that cannot be right: each is reported, and the traces can be read.
#include "vidno_student.h"

using namespace vidno::student;

const Polygon square{"a \"square\"\n", {255, 0, 0}, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}};
const Scene scene{"Wrong use", {0, 0, 4, 2}, {255, 255, 255}, {square}};

void misuse_warnock(Detail detail) {
    WarnockTrace trace("wrong_warnock.jsonl", scene, detail);
    trace.pop(1, 0, 2, 2);   // 2: nothing was pushed
    trace.push(0, 0, 4, 0);  // 3: no height
    trace.nearer(0);         // 4: no depths before
    trace.mark(7);           // 5: no such polygon
    trace.discard(0);
    trace.discard(0);                     // 7: it left
    trace.decide(Case::single);           // 8: no summary
    trace.fill(3, 1, 4, 4, {0, 0, 255});  // 9: 3 columns and 3 rows too far; ProcessWindow still runs
    trace.clip_keep({0, 0, 0});           // 10: nothing is being clipped
}

void misuse_z_buffer(Detail detail) {
    ZBufferTrace trace("wrong_z_buffer.jsonl", scene, detail);
    trace.pixel(0, 0, 0, -1, true);  // 2: of no polygon
    trace.clear(-1);
    trace.polygon(0);
    trace.ael_step(1, 0, 0);          // 5: not in AEL
    trace.ael_sort({0}, 1);           // 6: not in AEL either
    trace.ael_add(4, 0, 0, 1, 0, 0);  // 7: a square has the edges 0 to 3
    trace.pixel(4, 0, 0, -1, true);   // 8: off the area
    trace.pixel(1, 0, 0.1, -1, true);
    trace.scanline(1.5, 1);  // 10: no span
    trace.pixel(2, 1, 0.1, -1, true);
    trace.pixel(3, 0, 0.1, -1, true);  // 12: another row
    trace.span();
    trace.close();
    trace.clear(-1);  // 15: closed
}

void misuse_weiler_atherton(Detail detail) {
    WeilerAthertonTrace trace("wrong_weiler_atherton.jsonl", scene, detail);
    trace.pop_list();                   // 2: nothing was pushed
    trace.push_list({});                // 3: no pieces
    trace.push_list({{7, {}, false}});  // 4: no such polygon
    trace.push_list({{0, {{{0, 0}, {4, 0}, {4, 2}, {0, 2}}}, false}});
    trace.pop_list();
    trace.clipped(0, {}, {});             // 7: the list has one piece, which clips the others
    trace.behind(0, 1, 1, 0, 0.5, true);  // 8: nothing is inside
    trace.nearer_ones({});
    trace.row(1, -1, 2, -1, 2);  // 10: off the area
    trace.paint(0);
}

void misuse_floating_horizon(Detail detail) {
    const Surface surface{"Wrong use", {0, 0, 4, 4}, {{{0, 1}, {2, 1}, {3, 1}}}};
    FloatingHorizonTrace trace("wrong_floating_horizon.jsonl", surface, detail);
    trace.draw_line(0, 1, 1, 1);  // 2: of no curve
    trace.curve(1);               // 3: no such curve
    trace.curve(0);
    trace.visibility(3, 3);  // 5: no such flag
    trace.raise(9, 1);       // 6: off the area
    trace.raise(1, 1);
    trace.draw_line(0, 1, 1, 1);  // 8: Horizon still runs
    trace.horizon(1, 1);
    trace.side_edge(0, 1);
    trace.draw_line(1, 1, 3, 1);  // 11: over a sample
    trace.draw_line(0, 1, 2, 1);
    trace.draw_line(2, 1, 3, 1);
}

/// Rows and columns that are not whole: C++ would cut them to whole numbers without a word.
void misuse_rows(Detail detail) {
    const Surface surface{"Wrong use", {0, 0, 4, 4}, {{{0, 1}, {3, 1}}}};
    {
        WarnockTrace trace("rows_warnock.jsonl", scene, detail);
        trace.fill(0, 0.5, 1, 1, {0, 0, 255});  // 2
        trace.row(0.5, 0, 4, 0, 4);
        trace.pixel(1.5, 0);
    }
    {
        ZBufferTrace trace("rows_z_buffer.jsonl", scene, detail);
        trace.polygon(0);
        trace.scanline(0.5, 0.5);  // 3
        trace.line(0.5, 0, 0, 4, 0);
        trace.columns(0, 3.5, 0);
        trace.pixel(1, 0.5, 0, -1, true);
    }
    {
        WeilerAthertonTrace trace("rows_weiler_atherton.jsonl", scene, detail);
        trace.row(0.5, 0, 4, 0, 4);  // 2
        trace.pixel(1, 0.5);
    }
    FloatingHorizonTrace trace("rows_floating_horizon.jsonl", surface, detail);
    trace.curve(0);
    trace.side_edge(0.5, 1);  // 3
    trace.height(0.5, 1);
    trace.visibility(0.5, 1);
    trace.step(0.5, true);
    trace.raise(0.5, 1);
    trace.lower(0.5, 1);
    trace.horizon(0, 0.5);
}

int main(int count, char** words) {
    const std::string word = count > 1 ? words[1] : "";
    const Detail detail = word == "windows" ? Detail::windows : word == "polygons" ? Detail::polygons : Detail::signs;
    misuse_warnock(detail);
    misuse_z_buffer(detail);
    misuse_weiler_atherton(detail);
    misuse_floating_horizon(detail);
    misuse_rows(detail);
}
