#include "format/sha256.h"

// In a page the library at hand is one of the page's: it writes the 32 bytes where it is told.
[[clang::import_module("vidno"), clang::import_name("sha256")]] extern "C" void vidno_sha256(const char* bytes,
                                                                                             std::size_t size,
                                                                                             unsigned char* digest);

namespace vidno {

std::array<unsigned char, 32> sha256(std::string_view bytes) {
    std::array<unsigned char, 32> digest;
    vidno_sha256(bytes.data(), bytes.size(), digest.data());
    return digest;
}

}  // namespace vidno
