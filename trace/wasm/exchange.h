/// Exchange: how a page gives requests to a module of the library, and takes what it makes.
///
/// The page reserves room for a request with `request`, writes it there and calls a function of the module. It reads
/// the result in place, at `made`, and the messages at `messages`. The module serves one request at a time, in the
/// caller's thread.
#pragma once

#include <exception>
#include <string>

#include "json/json_text.h"

namespace vidno {

struct Exchange {
    std::string request, messages;
    Text made;
};

Exchange& exchange();

/// Lets `what` make the result, of which there is nothing yet. False if it was refused; the messages then give the
/// reason.
bool attempt(auto&& what) {
    Exchange& with_page = exchange();
    with_page.made.clear();
    with_page.messages.clear();
    try {
        what(with_page);
        return true;
    } catch (const std::exception& error) {
        with_page.messages = error.what();
        return false;
    }
}

}  // namespace vidno
