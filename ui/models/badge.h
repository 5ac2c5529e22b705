// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <QString>
#include <optional>

namespace odo {

enum class BadgeState { Neutral, Good, Warning, Bad };

/// A short verdict on a coloured ground; the words alone must say it.
struct Badge
{
    QString text;
    BadgeState state = BadgeState::Neutral;
};

/// How well a camera is registered: "±1.6 mm", the larger of the markers' misfit and the floor's σ. Good up to 5 mm, bad from 20 mm on.
Badge registrationBadge(const std::optional<FloorRegistration> &registration);

/// How far a camera can be relied on now: as registrationBadge, unless the last check says that it has moved ("moved 14 mm"),
/// that markers have, or that they were not found.
Badge cameraBadge(const std::optional<RegistrationRecord> &registration);

} // namespace odo
