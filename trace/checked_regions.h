/// For Weiler and Atherton's algorithm: OnRegions<Checked<Machine>>, whose every decision is judged, while the machine leads; and
/// OnRegions<TellingSigns<K>> of a kernel K that is always right, to be held against another.
#pragma once

#include "checked.h"
#include "vidno/kernels/filtered_regions.h"

namespace vidno {

template <class Machine>
struct CheckedNumbers : Checked<Machine> {
    explicit CheckedNumbers(Checked<Machine> kernel) : Checked<Machine>(std::move(kernel)) {}
};

template <class Machine>
struct OnRegions<Checked<Machine>> : OnRegions<CheckedNumbers<Machine>> {
    using Base = OnRegions<CheckedNumbers<Machine>>;
    using typename Base::Edge;
    using typename Base::Number;
    using typename Base::Place;
    using typename Base::Planes;

    explicit OnRegions(Checked<Machine> kernel) : Base(CheckedNumbers<Machine>(std::move(kernel))) {}

    bool parallel(const Planes& p, const Planes& q) const {
        const auto are_parallel = []<class K>(const K& kernel, const auto& a, const auto& b) {
            // A plane of rounded numbers may be upright, which to exact ones is a division by zero.
            if constexpr (std::same_as<K, Exact>) {
                if (a.c == 0 || b.c == 0) return false;
            }
            return on_regions(kernel).parallel(a, b);
        };
        return Base::decide(Decision::parallel, are_parallel, p, q);
    }
    bool parallel(const Edge& line, const Edge& other) const {
        return Base::decide(
            Decision::parallel,
            [](const auto& kernel, const auto& a, const auto& b) { return on_regions(kernel).parallel(a, b); }, line,
            other);
    }

    Sign side(const Edge& line, const Place& p) const {
        return Base::decide(
            Decision::orientation,
            [](const auto& kernel, const auto& a, const auto& b) { return on_regions(kernel).side(a, b); }, line, p);
    }
    Sign side(const Edge& line, const LoopVertex<Number>& v) const {
        return v.on(line) ? Sign::zero : side(line, v.at);
    }
    bool left_of(const Place& p, const Edge& line) const {
        return Base::decide(
            Decision::left_of,
            [](const auto& kernel, const auto& a, const auto& b) { return on_regions(kernel).left_of(a, b); }, p, line);
    }

    Place meet(const Edge& line, const Edge& other) const {
        Place found = Base::meet(line, other);
        Base::survey(found);
        return found;
    }

    Sign order(const Place& p, const Place& q) const {
        return Base::decide(
            Decision::comparison,
            [](const auto& kernel, const auto& a, const auto& b) { return on_regions(kernel).order(a, b); }, p, q);
    }
    Sign order_of_rows(const Place& p, const Place& q) const { return compare(p.y, q.y); }
    bool same_place(const LoopVertex<Number>& v, const LoopVertex<Number>& w) const {
        return Base::meet_once(*this, v, w) || order(v.at, w.at) == Sign::zero;
    }

    Sign turn(const Place& pivot, const Place& p, const Place& q) const {
        return Base::decide(
            Decision::orientation,
            [](const auto& kernel, const auto&... places) { return on_regions(kernel).turn(places...); }, pivot, p, q);
    }
    Sign compare(const Number& v, const Number& w) const {
        return Base::decide(
            Decision::comparison,
            [](const auto& kernel, const auto& a, const auto& b) { return on_regions(kernel).compare(a, b); }, v, w);
    }

private:
    template <class K>
    static OnRegions<K> on_regions(const K& kernel) {
        return OnRegions<K>(kernel);
    }
};

using HearSign = std::function<void(Sign)>;

/// A kernel that is always right, and tells each sign.
template <Kernel K>
struct TellingSigns : K {
    const HearSign* hear;

    TellingSigns(K kernel, const HearSign& hears) : K(std::move(kernel)), hear(&hears) {}
};

template <class Numbers>
struct NumbersTellingSigns : Numbers {
    const HearSign* hear;

    NumbersTellingSigns(Numbers numbers, const HearSign& hears) : Numbers(std::move(numbers)), hear(&hears) {}

    Sign sign(const typename Numbers::Number& value) const {
        const Sign taken = Numbers::sign(value);
        (*hear)(taken);
        return taken;
    }
};

template <class Tally>
struct OnRegions<TellingSigns<FilteredBy<Tally>>> : OnRegions<NumbersTellingSigns<ConstructedNumbers<Tally>>> {
    using Numbers = NumbersTellingSigns<ConstructedNumbers<Tally>>;
    explicit OnRegions(const TellingSigns<FilteredBy<Tally>>& kernel)
        : OnRegions<Numbers>(Numbers(ConstructedNumbers<Tally>(kernel), *kernel.hear)) {}
};
template <>
struct OnRegions<TellingSigns<Exact>> : OnRegions<NumbersTellingSigns<Exact>> {
    using Numbers = NumbersTellingSigns<Exact>;
    explicit OnRegions(const TellingSigns<Exact>& kernel) : OnRegions<Numbers>(Numbers(kernel, *kernel.hear)) {}
};

}  // namespace vidno
