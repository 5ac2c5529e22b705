// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace odo {

/// What the completions of the shells call: "odograph complete" (docs/cli.md).
inline constexpr const char *completionCommand = "complete";

/// What the last word of a call may become.
struct Completion
{
    enum class Files { None, Any, Folders, Projects };
    struct Candidate
    {
        QString word, remark;
    };

    Files files = Files::None; ///< which files the shell offers besides
    std::vector<Candidate> candidates;
};

/// words: those behind the program's name, up to the cursor; the last may be empty. Commands, options and
/// values come from what the commands say of themselves, names from the project that the call names. Errors
/// give nothing. Writes nothing. One thread.
Completion completionOf(const QStringList &words);

/// "words WORD..." or "bash LINE BREAKS": prints the answer, as docs/cli.md describes it. False where the
/// call is wrong; nothing is said about that.
bool answerCompletion(const QStringList &arguments);

} // namespace odo
