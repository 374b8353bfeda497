/// Overlay: two regions laid over each other, with their edges cut into pieces wherever they meet, along shared edges
/// too.
///
/// A piece then lies inside the other region, outside it, or on its outline. RegionClip depends on where the pieces
/// lie, not on how lines cross, so a touch, a shared edge and a vertex on a vertex need no special cases.
#pragma once

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "../insertion_sort.h"
#include "point_in_region.h"

namespace vidno {

template <WeilerAthertonKernel K>
class Overlay {
public:
    using Number = typename K::Number;
    using Piece = EdgePiece<Number>;
    using Pieces = std::vector<Piece>;

    /// The points where two or more pieces meet, each once.
    std::vector<LoopVertex<Number>> vertices;
    /// The pieces in the order of the loops.
    std::vector<Pieces> subject, clip;

    Overlay(const K& kernel, const Region<Number>& subject_region, const Region<Number>& clip_region)
        : kernel_(kernel) {
        auto subject_edges = edges_of(subject_region);
        auto clip_edges = edges_of(clip_region);
        for (auto& loop : subject_edges) {
            for (auto& edge : loop) {
                for (auto& other_loop : clip_edges) {
                    for (auto& other : other_loop) cut(edge, other);
                }
            }
        }
        subject = pieces_of(subject_edges);
        clip = pieces_of(clip_edges);
        classify(subject, clip, clip_region);
        classify(clip, subject, subject_region);
    }

private:
    struct Edge {
        const LoopVertex<Number>* from_vertex;
        const LoopVertex<Number>* to_vertex;
        int from, to;
        std::vector<int> cuts;

        const SupportLine<Number>& line() const { return *from_vertex->after; }
    };
    using Edges = std::vector<std::vector<Edge>>;

    Edges edges_of(const Region<Number>& region) {
        Edges edges;
        for (const auto& loop : region.loops) {
            edges.emplace_back();
            const int last = number_of(loop.back());
            int from = last;
            for_each_edge(loop, [&](const auto& from_vertex, const auto& to_vertex) {
                const int to = &to_vertex == &loop.back() ? last : number_of(to_vertex);
                edges.back().push_back({&from_vertex, &to_vertex, from, to, {}});
                from = to;
            });
        }
        return edges;
    }

    int number_of(const LoopVertex<Number>& vertex) {
        const auto same = [&](const auto& other) { return kernel_.same_place(vertex, other); };
        const auto found = std::find_if(vertices.begin(), vertices.end(), same);
        if (found != vertices.end()) return int(found - vertices.begin());
        vertices.push_back(vertex);
        return int(vertices.size()) - 1;
    }

    /// Cuts two edges where they cross, and where an end of one is on the other.
    void cut(Edge& e, Edge& f) {
        const Sign e_from = kernel_.side(f.line(), *e.from_vertex);
        const Sign e_to = kernel_.side(f.line(), *e.to_vertex);
        if (e_from == e_to && e_from != Sign::zero) return;
        const Sign f_from = kernel_.side(e.line(), *f.from_vertex);
        const Sign f_to = kernel_.side(e.line(), *f.to_vertex);
        if (f_from == f_to && f_from != Sign::zero) return;

        if (e_from == Sign::zero) cut_at(f, e.from);
        if (e_to == Sign::zero) cut_at(f, e.to);
        if (f_from == Sign::zero) cut_at(e, f.from);
        if (f_to == Sign::zero) cut_at(e, f.to);
        if (e_from != Sign::zero && e_from == -e_to && f_from != Sign::zero && f_from == -f_to) {
            vertices.push_back({kernel_.meet(e.line(), f.line()), &e.line(), &f.line()});
            e.cuts.push_back(int(vertices.size()) - 1);
            f.cuts.push_back(int(vertices.size()) - 1);
        }
    }

    /// Cuts an edge at a vertex on its line, if the vertex is between its ends.
    void cut_at(Edge& edge, int vertex) {
        if (vertex == edge.from || vertex == edge.to) return;
        if (order(edge.from, vertex) == order(vertex, edge.to)) edge.cuts.push_back(vertex);
    }

    Sign order(int v, int w) const { return v == w ? Sign::zero : kernel_.order(vertices[v].at, vertices[w].at); }

    std::vector<Pieces> pieces_of(Edges& edges) const {
        std::vector<Pieces> loops;
        for (auto& loop : edges) {
            loops.emplace_back();
            for (auto& edge : loop) {
                auto& cuts = edge.cuts;
                const Sign way = order(edge.from, edge.to);
                insertion_sort(cuts, [&](int v, int w) { return order(v, w) == way; });
                cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
                cuts.push_back(edge.to);
                int from = edge.from;
                for (const int to : cuts) {
                    loops.back().push_back({from, to, &edge.line()});
                    from = to;
                }
            }
        }
        return loops;
    }

    void classify(std::vector<Pieces>& loops, const std::vector<Pieces>& others, const Region<Number>& region) const {
        std::set<std::pair<int, int>> outline;
        for (const auto& loop : others) {
            for (const auto& piece : loop) outline.emplace(piece.from, piece.to);
        }
        for (auto& loop : loops) {
            for (auto& piece : loop) {
                if (outline.contains({piece.from, piece.to})) {
                    piece.lies = Lies::same_side;
                } else if (outline.contains({piece.to, piece.from})) {
                    piece.lies = Lies::other_side;
                } else {
                    const auto middle = kernel_.middle(vertices[piece.from].at, vertices[piece.to].at);
                    piece.lies = holds(kernel_, region, middle) ? Lies::inside : Lies::outside;
                }
            }
        }
    }

    const K& kernel_;
};

}  // namespace vidno
