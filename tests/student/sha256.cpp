// Checks the digests that FIPS 180-2 publishes in appendix B, and the digest of the empty message.
#include "vidno_student.h"

bool has_digest(const std::string& message, const std::string& digest) {
    return vidno::student::sha256({message.begin(), message.end()}) == digest;
}

int main() {
    const bool right =
        has_digest("", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855") &&
        has_digest("abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad") &&
        has_digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
                   "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1") &&
        has_digest(std::string(1000000, 'a'), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    return right ? 0 : 1;
}
