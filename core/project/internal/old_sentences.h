// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/message.h"

#include <span>
#include <string>

namespace odo {

/// Projects of format 15 and before hold English sentences where messages are stored now. By what they are
/// about, each is known again and becomes a message. Frozen: no sentence is added any more.
enum class OldSentences {
    Calibrations,  ///< verdicts on a lens, and why it is of its model
    Registrations, ///< verdicts, and what checks whether a camera has moved said
    Spikes,        ///< reasons
    Pictures,      ///< why one was refused
    Origins,       ///< of a lens
    Readings,      ///< how a track was read
    Changes,
};

/// A sentence or a part of one, as it was made.
struct OldSentence
{
    /// %1 … stand for what varied. The unit behind one (" mm") became a part of the argument.
    const char *english;
    const char *code; ///< by which its words are known now, with the same arguments in the same order
    /// What each of them is, a letter for each: n a number, w words of ours; c camera, r robot, e team,
    /// k class, a task, t trial, l layout, m marker, f file, whose capitals are lists of such names;
    /// P a list of pictures with their counts.
    const char *arguments = "";
};

/// All that there were of a kind.
std::span<const OldSentence> oldSentences(OldSentences of);

/// A stored text as a message; foreignWords() where it is none of those, and as many of its sentences as are.
/// Any thread.
Message fromOldSentence(OldSentences of, const std::string &text);

struct ProjectConnection;

/// The step to format 16: turns the English sentences that a project holds into stored messages, and keeps
/// right the digests of analyses that go over them. In the transaction of the step. What a later format adds
/// to a digest must not be missing here: AnalysisDigests reads the tables as they are in format 16.
Result<void> storeMessages(ProjectConnection &connection);

} // namespace odo
