/// PlaneDepthBuffer: the plane that each pixel shows, and its approximate depth.
#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

#include "pixel_block.h"
#include "plane_depth.h"

namespace vidno {

template <class Plane>
class PlaneDepthBuffer {
public:
    /// The plane and depth of a pixel. Together they take no more memory than a double.
    class Cell {
    public:
        Cell(float& about, std::uint32_t& plane, const Plane* planes, Pixel at)
            : about_(about), plane_(plane), planes_(planes), at_(at) {}

        float about() const { return about_; }
        const Plane& plane() const { return planes_[plane_]; }
        operator PlaneDepth<Plane>() const { return {plane().depth(at_.x + 0.5, at_.y + 0.5), &plane()}; }
        explicit operator double() const { return PlaneDepth<Plane>(*this).value; }
        void operator=(const SteppedPlaneDepth<Plane>& z) {
            about_ = z.about();
            plane_ = z.number();
        }

    private:
        float& about_;
        std::uint32_t& plane_;
        const Plane* planes_;
        Pixel at_;
    };
    struct Row {
        float* about;
        std::uint32_t* plane;
        const Plane* planes;
        int first_x, y;

        Cell operator[](int x) const { return {about[x - first_x], plane[x - first_x], planes, {x, y}}; }
        std::uint32_t number(int x) const { return plane[x - first_x]; }
    };

    void clear(const Area& area, const PlaneDepth<Plane>& farthest) {
        area_ = area;
        // The last block may end after the last pixel.
        const auto size = std::size_t(area.width) * std::size_t(area.height) + PixelBlock::pixels;
        about_.assign(size, float(farthest.value));
        plane_.assign(size, farthest.plane->number);
        planes_ = farthest.plane - farthest.plane->number;
    }
    Cell at(int x, int y) { return row(y)[x]; }
    Row row(int y) {
        assert(area_.y <= y && y < area_.bottom());
        const auto before = std::size_t(y - area_.y) * std::size_t(area_.width);
        return {about_.data() + before, plane_.data() + before, planes_, area_.x, y};
    }

private:
    Area area_;
    std::vector<float> about_;
    std::vector<std::uint32_t> plane_;
    const Plane* planes_ = nullptr;
};

}  // namespace vidno
