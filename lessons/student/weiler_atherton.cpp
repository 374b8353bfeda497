// A skeleton for Weiler and Atherton's algorithm, with the stack of lists and the place of each call of `trace`. You
// write the procedures. Without them the program shows no polygon, and `vidno grade` says so.
//
//     weiler_atherton [windows | polygons | signs]     writes weiler_atherton.jsonl
#include "example.h"

using namespace vidno::student;

class WeilerAtherton {
public:
    WeilerAtherton(const Scene& scene, WeilerAthertonTrace& trace) : trace_(trace) {
        push(sorted(parts_in_area(scene)));
        while (!lists_.empty()) {
            const std::vector<Piece> list = lists_.back();
            lists_.pop_back();
            trace.pop_list();
            clip(list);
        }
    }

private:
    /// WA1 and WA2: the part of each polygon in the area, with `cut_to_area`. A polygon seen edge-on does not take
    /// part. Polygons that pierce each other are split along the line in which their planes meet.
    std::vector<Piece> parts_in_area(const Scene&) { return {}; }

    /// DepthSort: by the greatest depth, the nearest first.
    std::vector<Piece> sorted(std::vector<Piece> pieces) { return pieces; }

    /// WA5 to WA9. The calls, in order:
    ///     for each piece but the first: clipped, or beside
    ///     push for the list of the parts outside
    ///     RemoveBehind: behind for each part inside that is not ground; the result: nearer_ones
    ///     show for the first piece if nothing is nearer
    ///     otherwise push for the nearer parts, with that piece as the ground
    void clip(const std::vector<Piece>&) {}

    // Yours, too: PaintRegions     row for each row of a visible region; the result: paint

    void push(const std::vector<Piece>& list) {
        if (list.empty()) return;
        lists_.push_back(list);
        trace_.push_list(list);
    }

    WeilerAthertonTrace& trace_;
    std::vector<std::vector<Piece>> lists_;
};

int main(int count, char** words) {
    const Scene scene = scene_to_draw(example_scene());
    WeilerAthertonTrace trace("weiler_atherton.jsonl", scene, detail_from(count, words));
    WeilerAtherton(scene, trace);
}
