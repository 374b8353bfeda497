/// Part: the elements of a list from one place to another. What std::ranges::subrange is where the compiler has it.
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
