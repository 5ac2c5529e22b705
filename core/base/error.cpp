// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

#include "core/base/plain_text.h"

#include <algorithm>

namespace odo {

std::string Error::message() const
{
    std::string line = what + ": " + why;
    if (!advice.empty())
        line += "; " + advice;
    std::ranges::replace_if(line, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return plainLine(line);
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
