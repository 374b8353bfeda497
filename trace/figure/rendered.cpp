// Converts SVG to PDF and PNG with librsvg and cairo.

#include <cairo-pdf.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>

#include "refused.h"
#include "writers.h"

namespace vidno::figures {

namespace {

template <auto destroy>
struct Destroy {
    void operator()(auto* thing) const { destroy(thing); }
};
using Handle = std::unique_ptr<RsvgHandle, Destroy<g_object_unref>>;
using CairoSurface = std::unique_ptr<cairo_surface_t, Destroy<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Destroy<cairo_destroy>>;

constexpr double points_an_inch = 72;

struct Size {
    double width, height;  // inches
};

[[noreturn]] void refuse(GError* error) {
    const std::string reason = error != nullptr ? error->message : "no reason given";
    g_clear_error(&error);
    throw Refused("the figure could not be drawn: " + reason);
}

Handle handle_of(const std::string& svg) {
    GError* error = nullptr;
    Handle handle(rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
    if (!handle) refuse(error);
    rsvg_handle_set_dpi(handle.get(), points_an_inch);
    return handle;
}

Size size_of(const Handle& handle) {
    Size size{};
    rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &size.width, &size.height);
    return {size.width / points_an_inch, size.height / points_an_inch};
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

void draw(const Handle& handle, cairo_surface_t* surface, double width, double height) {
    const Context context(cairo_create(surface));
    cairo_set_source_rgb(context.get(), 1, 1, 1);
    cairo_paint(context.get());
    const RsvgRectangle whole{0, 0, width, height};
    GError* error = nullptr;
    if (!rsvg_handle_render_document(handle.get(), context.get(), &whole, &error)) refuse(error);
}

}  // namespace

std::string pdf_of(const std::vector<std::string>& pages, const About& about) {
    std::string bytes;
    const CairoSurface surface(cairo_pdf_surface_create_for_stream(append, &bytes, 0, 0));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, about.title.c_str());
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");  // else today's
    for (const auto& svg : pages) {
        const Handle handle = handle_of(svg);
        const auto [width, height] = size_of(handle);
        cairo_pdf_surface_set_size(surface.get(), width * points_an_inch, height * points_an_inch);
        draw(handle, surface.get(), width * points_an_inch, height * points_an_inch);
        cairo_surface_show_page(surface.get());
    }
    cairo_surface_finish(surface.get());
    return bytes;
}

std::string png_of(const std::string& svg, int dots_an_inch) {
    const Handle handle = handle_of(svg);
    const auto [width, height] = size_of(handle);
    const int columns = int(std::ceil(width * dots_an_inch));
    const int rows = int(std::ceil(height * dots_an_inch));
    const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows));
    draw(handle, surface.get(), columns, rows);
    std::string bytes;
    if (cairo_surface_write_to_png_stream(surface.get(), append, &bytes) != CAIRO_STATUS_SUCCESS) {
        throw Refused("the figure could not be drawn: it is too large");
    }
    return bytes;
}

}  // namespace vidno::figures
