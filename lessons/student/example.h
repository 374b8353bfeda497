// Shared by the example programs: their scene, their surface, and the level of detail from the command line.
#ifndef EXAMPLE_H
#define EXAMPLE_H

#include <string>

#include "vidno_student.h"

/// A triangle and two sloping walls that pass through each other, and a triangle by itself.
inline vidno::student::Scene example_scene() {
    const vidno::student::Polygon floor{
        "floor",
        {31, 119, 180},
        {{-2.75, 8.25, 0.59375}, {18.25, 8.25, -0.0625}, {18.25, 18.25, -0.0625}, {-2.75, 18.25, 0.59375}}};
    const vidno::student::Polygon sail{
        "sail", {255, 127, 14}, {{1.25, 1.25, 0.25}, {7.25, 3.25, 0.25}, {5.25, 14.25, 0.25}}};
    const vidno::student::Polygon wall{
        "wall",
        {44, 160, 44},
        {{1.25, 10.25, 0.03125}, {15.25, 10.25, 0.90625}, {15.25, 13.25, 0.90625}, {1.25, 13.25, 0.03125}}};
    const vidno::student::Polygon flag{"flag", {148, 103, 189}, {{9.25, 1.25, 0}, {14.25, 1.25, 0}, {9.25, 6.25, 0}}};
    return {"A sail, a wall and a flag", {0, 0, 16, 16}, {255, 255, 255}, {floor, sail, wall, flag}};
}

/// A hill, a valley behind it, and a slope that passes through the horizons of both.
inline vidno::student::Surface example_surface() {
    return {"A hill, a valley and a slope",
            {0, 0, 16, 12},
            {{{0, 9}, {5, 5}, {8, 4.5}, {15, 10}}, {{0, 3}, {7, 8}, {15, 3.5}}, {{0, 1}, {15, 11}}}};
}

inline vidno::student::Detail detail_from(int count, char** words) {
    const std::string word = count > 1 ? words[1] : "signs";
    if (word == "windows") return vidno::student::Detail::windows;
    return word == "polygons" ? vidno::student::Detail::polygons : vidno::student::Detail::signs;
}

#endif
