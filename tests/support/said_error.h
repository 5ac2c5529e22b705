// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <string>
#include <vector>

namespace odo::test {

/// An Error of words that nobody translates.
inline Error saidError(ErrorCode code, const std::string &what, const std::string &why,
                       const std::string &advice)
{
    return {code, foreignWords(what), foreignWords(why), foreignWords(advice)};
}

inline tl::unexpected<Error> saidFailure(ErrorCode code, const std::string &what, const std::string &why,
                                         const std::string &advice)
{
    return tl::unexpected(saidError(code, what, why, advice));
}

/// Sentences as the command line prints them.
inline std::vector<std::string> english(const std::vector<Message> &messages)
{
    std::vector<std::string> sentences;
    for (const Message &message : messages)
        sentences.push_back(message.english());
    return sentences;
}

} // namespace odo::test
