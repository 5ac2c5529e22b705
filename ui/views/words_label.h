// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QLabel;

namespace odo {

/// Lets a label show sentences that may hold names of people's choosing: plain text, wrapped, and to be copied.
void showAsWords(QLabel &label);

/// Two such labels, of a judgement, bold, and of what to do about it, quiet.
void showAsVerdict(QLabel &verdict, QLabel &advice);

} // namespace odo
