#include "format/sha256.h"

#include <openssl/sha.h>

namespace vidno {

std::array<unsigned char, 32> sha256(std::string_view bytes) {
    std::array<unsigned char, SHA256_DIGEST_LENGTH> digest;
    SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest.data());
    return digest;
}

}  // namespace vidno
