// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/words_label.h"

#include <QLabel>

namespace odo {

void showAsWords(QLabel &label)
{
    label.setWordWrap(true);
    label.setTextFormat(Qt::PlainText);
    label.setTextInteractionFlags(Qt::TextSelectableByMouse);
}

void showAsVerdict(QLabel &verdict, QLabel &advice)
{
    showAsWords(verdict);
    showAsWords(advice);
    verdict.setStyleSheet(QStringLiteral("font-weight: 600"));
    advice.setObjectName(QStringLiteral("quiet"));
}

} // namespace odo
