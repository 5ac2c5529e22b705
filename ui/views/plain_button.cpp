// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/plain_button.h"

#include <QPushButton>

namespace odo {

QPushButton *plainButton(const QString &text)
{
    auto *button = new QPushButton(text);
    button->setAutoDefault(false);
    return button;
}

} // namespace odo
