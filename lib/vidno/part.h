/// Part: the elements of a list from one iterator to another: std::ranges::subrange for compilers that lack it.
#pragma once

namespace vidno {

template <class Iterator>
struct Part {
    Iterator first, last;

    Iterator begin() const { return first; }
    Iterator end() const { return last; }
};

template <class Iterator>
Part(Iterator, Iterator) -> Part<Iterator>;

}  // namespace vidno
