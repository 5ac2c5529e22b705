// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <QString>
#include <utility>
#include <vector>

namespace odo {

/// What was done, as sentences for a person; the warnings that they contain, and the file or folder that was
/// written, so that the window can offer what to do next.
struct DoneWork
{
    QString words;
    std::vector<Message> warnings = {};
    QString file = {}; ///< empty: none

    DoneWork(QString doneWords, std::vector<Message> itsWarnings = {}, QString written = {})
        : words(std::move(doneWords)), warnings(std::move(itsWarnings)), file(std::move(written))
    {
    }
};

} // namespace odo
