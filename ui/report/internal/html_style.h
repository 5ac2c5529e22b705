// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace odo {

/// The style sheet of a page: the program's light and dark colours, as the reader's device prefers them.
QString htmlStyle();

} // namespace odo
