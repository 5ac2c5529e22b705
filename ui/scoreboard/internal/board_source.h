// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scoreboard/internal/board_content.h"

#include <QObject>

namespace odo {

/// What standings are read from, a project or a school's hub. On the thread that made it, which it never
/// blocks for long, and which needs an event loop.
class BoardSource : public QObject
{
    Q_OBJECT
public:
    /// Reads for the first time, and follows from then on.
    virtual Result<BoardContent> begin() = 0;

Q_SIGNALS:
    /// What there is to show now; it may look the same as before.
    void read(const odo::BoardContent &content);
    /// Nothing more comes.
    void ended(const odo::Error &error);
};

} // namespace odo
