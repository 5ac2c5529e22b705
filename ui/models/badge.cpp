// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/badge.h"

#include "ui/models/figure_text.h"

#include <QCoreApplication>

namespace odo {

Badge registrationBadge(const std::optional<FloorRegistration> &registration)
{
    constexpr double goodBelowM = 0.005, badFromM = 0.020;
    if (!registration)
        return {QCoreApplication::translate("odo::Badge", "not registered"), BadgeState::Bad};
    const QString text = QChar(0x00b1) + millimetresText(registration->rmsM);
    if (registration->rmsM <= goodBelowM)
        return {text, BadgeState::Good};
    return {text, registration->rmsM < badFromM ? BadgeState::Warning : BadgeState::Bad};
}

} // namespace odo
