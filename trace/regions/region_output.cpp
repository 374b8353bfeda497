#include "regions/region_output.h"

#include "replay/state_text.h"

namespace vidno {

namespace {

class RegionsText : StateText {
public:
    RegionsText(const std::vector<ShownRegion>& regions, const RunRequest& request)
        : RegionsText(regions, request, polygon_names(request.scene)) {}

    std::string text() {
        out_ += R"({"format":"vidno-regions/1","name":)";
        append_string(out_, request_.scene->name);
        out_ += R"(,"kernel":)";
        append_string(out_, request_.kernel.name());
        out_ += R"(,"window":)";
        append_area(out_, request_.scene->area);
        out_ += R"(,"regions":[)";
        for (const auto& region : regions_) {
            out_ += &region == regions_.data() ? "\n" : ",\n";
            append(region);
        }
        out_ += "\n]}\n";
        return out_.string();
    }

private:
    RegionsText(const std::vector<ShownRegion>& regions, const RunRequest& request, const PolygonNames& names)
        : regions_(regions), request_(request), names_(names) {}

    void append(const ShownRegion& region) {
        const auto place = std::size_t(region.polygon.index);
        out_ += R"({"polygon":)";
        out_ += names_[place];
        out_ += R"(,"color":)";
        append_color(out_, request_.scene->polygons[place].color);
        out_ += R"(,"area":)";
        number(region.area);
        out_ += R"(,"loops":)";
        loops(region.loops);
        out_ += '}';
    }

    const std::vector<ShownRegion>& regions_;
    const RunRequest& request_;
    PolygonNames names_;
};

}  // namespace

std::string regions_json(const std::vector<ShownRegion>& regions, const RunRequest& request) {
    return RegionsText(regions, request).text();
}

}  // namespace vidno
