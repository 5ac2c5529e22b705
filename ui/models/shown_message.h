// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/message.h"

#include <QString>

namespace odo {

/// A text for a label that breaks lines: a word of more than forty letters may be broken after each forty, so
/// that a name of ten thousand does not ask for a window as wide as itself.
QString breakable(const QString &text);

/// A message of core in the language of the windows: its words translated, its numbers with the language's
/// decimal sign, teams by their pseudonyms and people by none where pseudonyms are shown (shown_names.h). Any
/// thread.
QString shownWords(const Message &message);

/// Two parts of a message as one: "what: why".
QString joinedWords(const QString &what, const QString &why);
/// A sentence with its full stop, as the language has it; unless it ends with a sign.
QString fullSentence(const QString &words);

/// An Error as a person reads it, in the language of the windows: what, why, and what to do, as sentences.
QString errorInWords(const Error &error);

/// The same on one line, as Error::message() has it: "what: why; what to do".
QString errorLine(const Error &error);

/// What several windows say, or a window and the command line.

Message imageSubject(); ///< "the image"
Message anotherJobRuns();
Message waitOrCancel(); ///< what to do while a job runs
Message noProjectIsOpen();

/// What a change does, for Project::change.
Message addCameraWords(const std::string &name);
Message addRobotWords(std::string robot);
Message addTaskWords(std::string task);
Message addLayoutWords(std::string layout);

} // namespace odo
