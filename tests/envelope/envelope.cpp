#include "envelope.h"

#include <CGAL/Arr_batched_point_location.h>
#include <CGAL/Cartesian.h>
#include <CGAL/Env_surface_data_traits_3.h>
#include <CGAL/Env_triangle_traits_3.h>
#include <CGAL/envelope_3.h>

#include <algorithm>
#include <boost/variant/apply_visitor.hpp>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace vidno::test {

class Envelope::Diagram {
public:
    explicit Diagram(const Scene& scene) : scene_(scene) {
        std::vector<Traits::Surface_3> triangles;
        for (std::size_t i = 0; i < scene.polygons.size(); ++i) {
            const auto& polygon = scene.polygons[i];
            // CGAL would show the upper outline of an edge-on triangle, and does not accept one without area in space.
            if (polygon.edge_on) continue;
            const auto corner = [&](std::size_t k) {
                const auto& v = polygon.vertices[k];
                return Kernel::Point_3(v.x, v.y, v.z);
            };
            triangles.emplace_back(Traits::Base_surface_3(corner(0), corner(1), corner(2)), i);
        }
        CGAL::upper_envelope_3(triangles.begin(), triangles.end(), map_);
    }

    Picture picture() const {
        const Area& area = scene_.area;
        std::vector<Kernel::Point_2> centres;
        for (int y = area.y; y < area.bottom(); ++y) {
            for (int x = area.x; x < area.right(); ++x) centres.emplace_back(x + 0.5, y + 0.5);
        }
        std::vector<std::pair<Kernel::Point_2, Place>> located;
        CGAL::locate(map_, centres.begin(), centres.end(), std::back_inserter(located));

        Picture picture(area, scene_.background);
        for (const auto& [centre, place] : located) {
            picture.paint(pixel_of(centre.x()), pixel_of(centre.y()), color_at(place));
        }
        return picture;
    }

    std::map<int, CGAL::Exact_rational> areas() const {
        std::map<int, CGAL::Exact_rational> areas;
        for (auto face = map_.faces_begin(); face != map_.faces_end(); ++face) {
            if (face->is_unbounded() || face->number_of_surfaces() == 0) continue;
            auto& area = areas[int(first_at(face))];
            area += area_within(face->outer_ccb());
            for (auto hole = face->holes_begin(); hole != face->holes_end(); ++hole) area += area_within(*hole);
        }
        return areas;
    }

private:
    // CGAL's lazy kernel, which filters, takes a third longer to compile.
    using Kernel = CGAL::Cartesian<CGAL::Exact_rational>;
    using Traits = CGAL::Env_surface_data_traits_3<CGAL::Env_triangle_traits_3<Kernel>, std::size_t>;
    using Map = CGAL::Envelope_diagram_2<Traits>;
    using Place = CGAL::Arr_point_location_result<Map::Arrangement>::Type;  // a vertex, an edge or a face

    /// The map gives equal triangles in any order; the first of the scene wins.
    Color color_at(const Place& place) const {
        const std::size_t first = boost::apply_visitor([&](const auto& at) { return first_at(at); }, place);
        return first < scene_.polygons.size() ? scene_.polygons[first].color : scene_.background;
    }

    std::size_t first_at(const auto& at) const {
        std::size_t first = scene_.polygons.size();
        for (auto s = at->surfaces_begin(); s != at->surfaces_end(); ++s) first = std::min(first, s->data());
        return first;
    }

    /// Outlines have the face on their left, and count positive; so do holes, which then count negative.
    static CGAL::Exact_rational area_within(Map::Ccb_halfedge_const_circulator edge) {
        Kernel::FT doubled = 0;
        const auto first = edge;
        do {
            const auto& p = edge->source()->point();
            const auto& q = edge->target()->point();
            doubled += p.x() * q.y() - p.y() * q.x();
        } while (++edge != first);
        return doubled / 2;
    }

    static int pixel_of(const Kernel::FT& centre) { return int(std::floor(CGAL::to_double(centre))); }

    const Scene& scene_;
    Map map_;
};

Envelope::Envelope(const Scene& scene) : diagram_(std::make_unique<Diagram>(scene)) {}
Envelope::~Envelope() = default;

Picture Envelope::picture() const { return diagram_->picture(); }
std::map<int, CGAL::Exact_rational> Envelope::areas() const { return diagram_->areas(); }

}  // namespace vidno::test
