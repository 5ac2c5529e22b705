// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/explanation.h"

class QWidget;

namespace odo {

/// Shows how a number was computed, to be read beside it and copied. Not modal; deletes itself.
void showExplanation(QWidget *parent, const Explanation &explanation);

/// The words of what opens it.
QString howComputedWords();

} // namespace odo
