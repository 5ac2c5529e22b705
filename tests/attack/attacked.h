// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace odo::test {

/// How a call of the program ended that was given something hostile.
struct AttackedRun
{
    int exitStatus = -1; ///< -1: a signal ended it, or it was ended after the longest time
    int signal = 0;
    double seconds = 0;
    long peakKb = 0;
    QByteArray out, err;
};

/// Runs the program (ODOGRAPH_PROGRAM), for at most ten seconds.
AttackedRun attacked(const QStringList &arguments);

/// What is wrong with how it ended; empty: nothing. Right is: done (0), or refused (1, or 2 for a call) by
/// one line that is a sentence; at most ten seconds and 500 MB; no control character in what a person reads.
QString faultOf(const AttackedRun &run);

/// Whether all cases are wanted (ODOGRAPH_WHOLE_ATTACK), or the sample that goes with each change.
bool isWholeAttack();
/// Whether the case of that number is in the sample: one of so many.
bool isWanted(int number, int oneOf);

} // namespace odo::test
