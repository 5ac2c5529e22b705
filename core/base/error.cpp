// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

namespace odo {

std::string Error::message() const
{
    std::string line = what + ": " + why;
    if (!advice.empty())
        line += "; " + advice;
    for (char &c : line) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            c = ' ';
    }
    return line;
}

tl::unexpected<Error> fail(ErrorCode code, std::string what, std::string why, std::string advice)
{
    return tl::unexpected<Error>(Error{code, std::move(what), std::move(why), std::move(advice)});
}

tl::unexpected<Error> cancelled(std::string what)
{
    return fail(ErrorCode::Cancelled, std::move(what), "cancelled", "nothing was changed");
}

} // namespace odo
