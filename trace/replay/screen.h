/// Screen: what the events of a run write to the area: colours, depths, and the windows into which it is divided.
#pragma once

#include <cstdint>
#include <optional>

#include "format/trace_writer.h"
#include "replay/call_stack.h"
#include "replay/division.h"
#include "replay/tiles.h"

namespace vidno {

class Screen {
public:
    /// An unpainted pixel shows the background.
    struct Pixel {
        Color color;
        std::uint32_t painter = 0;  // the step that painted it last; 0 if none has
        bool operator==(const Pixel&) const = default;
    };

    explicit Screen(const TraceHeader& header);

    const Area& area() const { return pixels_.area(); }
    const Pixel& pixel(int x, int y) const { return pixels_.at(x, y); }
    Color color(int x, int y) const { return pixel(x, y).color; }
    const Tiles<Pixel>& pixels() const { return pixels_; }
    Picture picture() const;
    /// Whether pixels that nothing has painted are background, and not merely unpainted so far.
    bool is_ground() const { return is_ground_; }
    /// None before the Z-buffer is cleared, below level `polygons`, and in an area of more than 2^24 pixels, whose
    /// depths would fill the memory.
    const std::optional<Tiles<Value, 32>>& depths() const { return depths_; }
    const Division& division() const { return division_; }
    /// The last step that changed pixels or depths, and the last that divided a window.
    std::uint32_t painted_at() const { return painted_at_; }
    std::uint32_t divided_at() const { return divided_at_; }

    // What the event of a step does. These throw Impossible for pixels outside the area.
    void begin(std::uint64_t step) { step_ = std::uint32_t(step); }
    void paint(const PixelRectangle& pixels, const Color& color);
    void paint(const PixelRun& run, const Color& color);
    void divide(const Window& window, const Window& root);
    void clear(const Color& color, const Value& z);
    void store_depth(int x, int y, const Value& z);
    void finish_ground() { is_ground_ = true; }

    /// The bytes that a copy takes before anything is written.
    std::size_t bytes_of_copy() const;

private:
    Tiles<Pixel> pixels_;
    Division division_;
    std::optional<Tiles<Value, 32>> depths_;
    bool has_depths_, cuts_anywhere_;
    bool is_ground_ = false;
    std::uint32_t step_ = 0, painted_at_ = 0, divided_at_ = 0;
};

}  // namespace vidno
