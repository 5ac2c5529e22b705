// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/badge.h"

#include "ui/models/figure_text.h"

#include <QCoreApplication>
#include <algorithm>

namespace odo {

Badge registrationBadge(const std::optional<FloorRegistration> &registration)
{
    constexpr double goodBelowM = 0.005, badFromM = 0.020;
    if (!registration)
        return {QCoreApplication::translate("odo::Badge", "not registered"), BadgeState::Bad};
    // Markers may fit by chance, and closely under a lens that is hardly known: the worse of the two counts.
    const double worseM = std::max(registration->rmsM, registration->floorSigmaM);
    const QString text = QChar(0x00b1) + lengthText(worseM);
    if (worseM <= goodBelowM)
        return {text, BadgeState::Good};
    return {text, worseM < badFromM ? BadgeState::Warning : BadgeState::Bad};
}

Badge cameraBadge(const std::optional<RegistrationRecord> &registration)
{
    if (!registration)
        return registrationBadge(std::nullopt);
    if (registration->lastCheck) {
        const RegistrationCheck &check = *registration->lastCheck;
        switch (check.outcome) {
        case RegistrationCheck::Outcome::CameraMoved:
            return {QCoreApplication::translate("odo::Badge", "moved %1").arg(lengthText(check.shiftM)), BadgeState::Bad};
        case RegistrationCheck::Outcome::MarkersMoved:
            return {QCoreApplication::translate("odo::Badge", "marker moved %1").arg(lengthText(check.shiftM)), BadgeState::Warning};
        case RegistrationCheck::Outcome::NotTold:
            return {QCoreApplication::translate("odo::Badge", "markers not found"), BadgeState::Warning};
        case RegistrationCheck::Outcome::Still:
            break;
        }
    }
    return registrationBadge(registration->registration);
}

} // namespace odo
