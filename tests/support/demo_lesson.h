// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace odo::test {

/// Puts the demo lesson into a folder that is there and empty, as its own: copied from the one that
/// acceptance/tst_demo_lesson has made for all tests of a run of ctest (ODOGRAPH_DEMO_LESSON), else made by
/// the program. What went wrong, or nothing.
QString provideDemoLesson(const QString &folder);

} // namespace odo::test
