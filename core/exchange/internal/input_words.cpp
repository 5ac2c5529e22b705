// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/internal/input_words.h"

namespace odo {

Message separatedBySemicolons()
{
    return ODO_TEXT("exchange.separated_by_semicolons", "its columns are separated by semicolons");
}

Message notAFiniteNumber(std::string what)
{
    return ODO_TEXT("exchange.not_a_finite_number", "'%1' is not a finite number")(std::move(what));
}

Message entryIsMissing(std::string key)
{
    return ODO_TEXT("exchange.entry_is_missing", "the entry '%1' is missing")(std::move(key));
}

Message checkRightFile()
{
    return ODO_TEXT("exchange.check_right_file", "check that it is the right file");
}

Message beginWithLine(const std::string &line)
{
    return ODO_TEXT("exchange.begin_with_line", "begin the file with the line %1")(line);
}

} // namespace odo
