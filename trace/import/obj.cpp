#include "import/mesh_soup.h"
#include "import/words.h"

namespace vidno {

MeshSoup read_obj(std::string_view bytes) {
    std::string unfolded(bytes);  // a backslash at the end of a line continues it
    for (const std::string_view fold : {"\\\n", "\\\r\n"}) {
        for (std::size_t at = unfolded.find(fold); at != std::string::npos; at = unfolded.find(fold, at)) {
            std::fill_n(unfolded.begin() + std::ptrdiff_t(at), fold.size(), ' ');
        }
    }
    MeshSoup soup;
    std::int64_t greatest_index = 0;
    TextWords words(unfolded);
    while (words.next_line_with_words('#')) {
        const std::string_view keyword = words.word();
        if (keyword == "v") {
            soup.points.push_back(words.coordinates());
        } else if (keyword == "f") {
            auto& face = soup.faces.emplace_back();
            check_face_count(soup.faces.size());
            const auto points = std::int64_t(soup.points.size());
            for (std::string_view corner = words.word(); !corner.empty(); corner = words.word()) {
                std::int64_t index = words.whole_number(corner.substr(0, corner.find('/')));
                if (index < 0) index = index < -points ? 0 : points + index + 1;  // counts back from the last
                if (index == 0) words.refuse("a face has a vertex that does not exist");
                greatest_index = std::max(greatest_index, index);
                face.push_back(std::size_t(index - 1));
            }
        }
    }
    if (greatest_index > std::int64_t(soup.points.size())) {
        throw Refused("a face has vertex " + std::to_string(greatest_index) + ", of " +
                      std::to_string(soup.points.size()));
    }
    return soup;
}

}  // namespace vidno
