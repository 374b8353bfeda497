/// Line: the labels of the listings' lines. Every event has the label of the line that caused it.
#pragma once

#include <array>
#include <string_view>

namespace vidno {

// clang-format off
enum class Line : unsigned char {
    W1, W2, W3, W4, W5, W6, W7, W8, W9, W10, W11, W12, W13,   // Warnock
    PW1, PW2, PW3, PW4, PW5, PW6, PW7, PW8, PW9, PW10,        // ProcessWindow
    PC1, PC2, PC3, PC4, PC5,                                  // PointColor
    D1,                                                       // Depth
    S1, S2, S3, S4,                                           // SurroundTest
    PL1, PL2, PL3, PL4, PL5, PL6, PL7, PL8,                   // PolygonClip
    I1,                                                       // InitializePolygon
    F1, F2, F3,                                               // FillPolygon
    Z1, Z2, Z3, Z4, Z5, Z6, Z7, Z8, Z9, Z10, Z11, Z12, Z13, Z14, Z15, Z16, Z17,  // ZBuffer
    L1, L2, L3, L4, L5, L6, L7,                               // ShowLine
    FH1, FH2, FH3, FH4, FH5, FH6, FH7, FH8, FH9, FH10,        // FloatingHorizon
    SE1, SE2, SE3,                                            // SideEdge
    V1, V2, V3, V4,                                           // Visibility
    H1, H2, H3,                                               // Horizon
    IN1, IN2, IN3,                                            // Intersection
    WS1, WS2, WS3, WS4, WS5, WS6,                             // SimplestWarnock
    WF1, WF2, WF3, WF4, WF5, WF6, WF7, WF8, WF9, WF10, WF11, WF12,  // ThreeListsWarnock
    RE1, RE2, RE3, RE4,                                       // Relation
    TF1, TF2, TF3, TF4,                                       // TrialFunction
    CR1, CR2, CR3, CR4, CR5,                                  // RayCrossings
    OA1, OA2, OA3, OA4, OA5,                                  // OctantAngles
    HP1, HP2, HP3, HP4, HP5, HP6, HP7,                        // HidingPolygon
    VS1, VS2, VS3, VS4,                                       // VertexSplit
    ED1, ED2, ED3, ED4, ED5, ED6,                             // EdgeDepth
    BF1, BF2,                                                 // BackFaces
    WA1, WA2, WA3, WA4, WA5, WA6, WA7, WA8, WA9, WA10,        // WeilerAtherton
    SP1, SP2, SP3,                                            // SplitPiercing
    DS1, DS2,                                                 // DepthSort
    RC1, RC2, RC3, RC4, RC5,                                  // RegionClip
    RB1, RB2, RB3, RB4,                                       // RemoveBehind
    PR1, PR2, PR3,                                            // PaintRegions
};

inline constexpr auto line_names = std::to_array<std::string_view>({
    "W1", "W2", "W3", "W4", "W5", "W6", "W7", "W8", "W9", "W10", "W11", "W12", "W13",
    "PW1", "PW2", "PW3", "PW4", "PW5", "PW6", "PW7", "PW8", "PW9", "PW10",
    "PC1", "PC2", "PC3", "PC4", "PC5",
    "D1",
    "S1", "S2", "S3", "S4",
    "PL1", "PL2", "PL3", "PL4", "PL5", "PL6", "PL7", "PL8",
    "I1",
    "F1", "F2", "F3",
    "Z1", "Z2", "Z3", "Z4", "Z5", "Z6", "Z7", "Z8", "Z9", "Z10", "Z11", "Z12", "Z13", "Z14", "Z15", "Z16", "Z17",
    "L1", "L2", "L3", "L4", "L5", "L6", "L7",
    "FH1", "FH2", "FH3", "FH4", "FH5", "FH6", "FH7", "FH8", "FH9", "FH10",
    "SE1", "SE2", "SE3",
    "V1", "V2", "V3", "V4",
    "H1", "H2", "H3",
    "IN1", "IN2", "IN3",
    "WS1", "WS2", "WS3", "WS4", "WS5", "WS6",
    "WF1", "WF2", "WF3", "WF4", "WF5", "WF6", "WF7", "WF8", "WF9", "WF10", "WF11", "WF12",
    "RE1", "RE2", "RE3", "RE4",
    "TF1", "TF2", "TF3", "TF4",
    "CR1", "CR2", "CR3", "CR4", "CR5",
    "OA1", "OA2", "OA3", "OA4", "OA5",
    "HP1", "HP2", "HP3", "HP4", "HP5", "HP6", "HP7",
    "VS1", "VS2", "VS3", "VS4",
    "ED1", "ED2", "ED3", "ED4", "ED5", "ED6",
    "BF1", "BF2",
    "WA1", "WA2", "WA3", "WA4", "WA5", "WA6", "WA7", "WA8", "WA9", "WA10",
    "SP1", "SP2", "SP3",
    "DS1", "DS2",
    "RC1", "RC2", "RC3", "RC4", "RC5",
    "RB1", "RB2", "RB3", "RB4",
    "PR1", "PR2", "PR3",
});
// clang-format on

static_assert(line_names.size() == std::size_t(Line::PR3) + 1);

/// The procedures that open a frame of the call stack, by the names of the listings.
enum class Procedure : unsigned char {
    warnock,
    process_window,
    point_color,
    surround_test,
    polygon_clip,
    fill_polygon,
    z_buffer,
    show_line,
    floating_horizon,
    side_edge,
    visibility,
    horizon,
    intersection,
    simplest_warnock,
    three_lists_warnock,
    relation,
    trial_function,
    ray_crossings,
    octant_angles,
    hiding_polygon,
    weiler_atherton,
    split_piercing,
    depth_sort,
    region_clip,
    remove_behind,
    paint_regions,
};

inline constexpr auto procedure_names = std::to_array<std::string_view>({
    "Warnock",      "ProcessWindow",   "PointColor",        "SurroundTest",  "PolygonClip",   "FillPolygon",
    "ZBuffer",      "ShowLine",        "FloatingHorizon",   "SideEdge",      "Visibility",    "Horizon",
    "Intersection", "SimplestWarnock", "ThreeListsWarnock", "Relation",      "TrialFunction", "RayCrossings",
    "OctantAngles", "HidingPolygon",   "WeilerAtherton",    "SplitPiercing", "DepthSort",     "RegionClip",
    "RemoveBehind", "PaintRegions",
});

static_assert(procedure_names.size() == std::size_t(Procedure::paint_regions) + 1);

}  // namespace vidno
