/// The picture rule by CGAL's upper envelope: exact, and independent of kernels, procedures and the reference.
#pragma once

#include <CGAL/Exact_rational.h>

#include <map>
#include <memory>

#include "vidno/picture.h"
#include "vidno/scene.h"

namespace vidno::test {

/// The envelope of triangles as a map of the plane: each vertex, edge and face has the nearest triangles there, all of
/// them where depths are equal. Outlines are edges of the map, so triangles are closed.
class Envelope {
public:
    /// All polygons must be triangles.
    explicit Envelope(const Scene& scene);
    ~Envelope();

    Picture picture() const;

    /// The area of each polygon that shows, in the faces of the map; where triangles are equal, the first one shows.
    std::map<int, CGAL::Exact_rational> areas() const;

private:
    class Diagram;  // CGAL's envelope takes long to compile: only envelope.cpp sees it.
    std::unique_ptr<Diagram> diagram_;
};

}  // namespace vidno::test
