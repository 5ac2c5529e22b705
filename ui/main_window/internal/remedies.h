// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/message.h"

#include <QString>
#include <vector>

namespace odo {

/// What the window can begin at once where a message advises it.
enum class Remedy { Synchronise, ChangeRobots, OpenTestbed, Track, FindVideos };

/// "Synchronise…": for a button.
QString remedyWords(Remedy remedy);
/// What a message advises, each once, by the codes of its parts; empty where it advises nothing that the
/// window has a command for.
std::vector<Remedy> remediesOf(const Message &message);
/// The first trial that a message names; empty: none.
QString trialIn(const Message &message);

} // namespace odo
