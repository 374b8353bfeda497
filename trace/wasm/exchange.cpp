// What every module of the library exports.
#include "wasm/exchange.h"

namespace vidno {

Exchange& exchange() {
    static Exchange only;
    return only;
}

}  // namespace vidno

extern "C" {

/// The place where the caller writes a request of this many bytes.
[[clang::export_name("request")]] char* vidno_request(std::size_t size) {
    vidno::exchange().request.resize(size);
    return vidno::exchange().request.data();
}

/// The bytes of the result, until the next call.
[[clang::export_name("made")]] const char* vidno_made() { return vidno::exchange().made.view().data(); }
[[clang::export_name("made_size")]] std::size_t vidno_made_size() { return vidno::exchange().made.size(); }

/// Why the request was refused; otherwise warnings, one per line.
[[clang::export_name("messages")]] const char* vidno_messages() { return vidno::exchange().messages.data(); }
[[clang::export_name("messages_size")]] std::size_t vidno_messages_size() { return vidno::exchange().messages.size(); }
}
