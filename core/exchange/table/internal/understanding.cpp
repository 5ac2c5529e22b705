// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/understanding.h"

#include "core/exchange/table/internal/table_reader.h"
#include "core/files/file_words.h"

namespace odo {

tl::unexpected<Error> Understanding::wrong(int line, Message why, Message advice) const
{
    return fail(ErrorCode::InvalidInput,
                line > 0 ? atLineOf(file, reading, line)
                         : quotedFileSubject(reading.shownAs.empty() ? file : reading.shownAs),
                std::move(why), std::move(advice));
}

} // namespace odo
