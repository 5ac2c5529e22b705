// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/record/live_tracking.h"

#include <QStringList>
#include <optional>

namespace odo {

/// Whether, and to where, live positions are sent on the network, as the settings have it. GUI thread.
struct SentPositions
{
    bool isOn = false;
    BroadcastTarget target;
    bool operator==(const SentPositions &) const = default;

    static SentPositions chosen();
    void choose() const;
    /// nullopt: they are not sent.
    std::optional<BroadcastTarget> wanted() const { return isOn ? std::optional(target) : std::nullopt; }
};

/// The names of this machine's network interfaces, the loopback first.
QStringList networkInterfaces();

} // namespace odo
