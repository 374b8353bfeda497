#include "import/mesh_soup.h"
#include "import/words.h"

namespace vidno {

MeshSoup read_off(std::string_view bytes) {
    TextWords words(bytes);
    if (!words.next_line_with_words('#')) throw Refused("empty");
    std::string_view keyword = words.word();
    for (const std::string_view prefix : {"ST", "C", "N"}) {
        if (keyword.starts_with(prefix)) keyword.remove_prefix(prefix.size());
    }
    if (keyword == "4OFF" || keyword == "nOFF" || keyword == "4nOFF") words.refuse("not of three dimensions");
    if (keyword != "OFF") words.refuse("does not start with OFF");
    std::string_view first = words.word();
    if (first == "BINARY") words.refuse("binary OFF is not supported");
    if (first.empty() && words.next_line_with_words('#')) first = words.word();
    const std::uint64_t points = words.count(first);
    const std::uint64_t faces = words.count(words.word());
    check_count(points, "vertices", 6, words.bytes_left() + 1);  // "0 0 0" and a newline, which the last line may lack
    check_count(faces, "faces", 2, words.bytes_left() + 1);
    check_face_count(faces);

    MeshSoup soup;
    for (std::uint64_t i = 0; i < points; ++i) {
        if (!words.next_line_with_words('#')) words.refuse("the file ends before its last vertex");
        soup.points.push_back(words.coordinates());
    }
    for (std::uint64_t i = 0; i < faces; ++i) {
        if (!words.next_line_with_words('#')) words.refuse("the file ends before its last face");
        const std::uint64_t corners = words.count(words.word());
        check_count(corners, "corners of a face", 2, words.bytes_left() + 1);
        auto& face = soup.faces.emplace_back();
        for (std::uint64_t corner = 0; corner < corners; ++corner) {
            const std::uint64_t index = words.count(words.word());
            if (index >= points) words.refuse("a face has a vertex that does not exist");
            face.push_back(index);
        }
    }
    return soup;
}

}  // namespace vidno
