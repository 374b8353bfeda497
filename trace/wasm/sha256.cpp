#include "format/sha256.h"

// In a page, a library of the page computes the hash, and writes its 32 bytes to the given place.
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
