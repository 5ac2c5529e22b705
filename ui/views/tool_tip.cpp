// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/tool_tip.h"

#include <QHelpEvent>
#include <QToolTip>

namespace odo {

void showToolTip(const QHelpEvent &help, const QString &words, QWidget *widget)
{
    if (words.isEmpty())
        QToolTip::hideText();
    else
        QToolTip::showText(help.globalPos(), words, widget);
}

} // namespace odo
