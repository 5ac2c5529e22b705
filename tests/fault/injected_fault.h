// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "tests/fault/failing_calls.h"
#include "tests/support/program.h"

#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace odo::test {

/// What is made to fail; the nth call is told apart.
struct Fault
{
    int error = 0; ///< errno; 0: killed, or nothing at all
    FailingCalls::How how = FailingCalls::How::Once;
    bool reads = false;

    QString words() const;
    bool kills() const { return how == FailingCalls::How::Killed || how == FailingCalls::How::KilledHalfway; }
};

/// A failing disk, a full one, one that has become read-only, and kills.
const std::vector<Fault> &allFaults();
/// Only the kills among them, or only the rest.
std::vector<Fault> kills();
std::vector<Fault> failures();

/// What became of a process whose nth call failed.
struct Attempt
{
    Fault fault;
    int nth = 0;
    bool reached = false; ///< there was an nth call
    int calls = 0;        ///< that could have failed
    QString failedCall;   ///< "write /a/b", the first that failed
    int signal = 0;       ///< that ended it
    int acknowledged = 0; ///< steps that it said were done
    std::optional<Error> error;

    /// "call 12 (write b.odo) fails with ENOSPC".
    QString words() const;
    bool died() const { return signal != 0; }
};

/// Called by the work after each step that it was told is done.
using Acknowledge = std::function<void()>;
using Work = std::function<Result<void>(const std::filesystem::path &folder, const Acknowledge &acknowledge)>;

/// Forks, and does the work in the child while its nth call on files below the folder fails (0: none does).
Attempt attempt(const std::filesystem::path &folder, const Fault &fault, int nth, const Work &work);

/// The program, while its nth call likewise fails. Several may run at once.
class AttemptedProgram
{
public:
    AttemptedProgram(const std::filesystem::path &folder, const Fault &fault, int nth,
                     const QStringList &arguments);
    ~AttemptedProgram();
    /// Waits for its end. `run` gets its output and exit status (-1: ended by a signal).
    Attempt finish(ProgramRun *run);

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};
Attempt attemptProgram(const std::filesystem::path &folder, const Fault &fault, int nth,
                       const QStringList &arguments, ProgramRun *run);

/// Whether ODOGRAPH_ALL_FAULTS asks for every call, and not a sample of them.
bool isWholeSweep();
/// Numbers of calls, so many drawn evenly from all; all where there are no more.
std::vector<int> spreadCalls(int calls, int count);

/// A folder for files that are written again and again: in memory where the system has such a place.
QString quickFolder();

/// A copy of everything in a folder, replacing what is there.
void copyFolder(const std::filesystem::path &from, const std::filesystem::path &to);

} // namespace odo::test
