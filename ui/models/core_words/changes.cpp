// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/core_words/subjects.h"

namespace odo::core_words {

std::span<const CorePattern> changes()
{
    static constexpr CorePattern patterns[] = {
        {QT_TRANSLATE_NOOP("CoreWords", "mark frame %1 of %2 as a spike")},
        {QT_TRANSLATE_NOOP("CoreWords", "use frame %1 of %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "leave frame %1 of %2 to the program")},
        {QT_TRANSLATE_NOOP("CoreWords", "import the roster %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "put the axes of layout %1 elsewhere")},
        {QT_TRANSLATE_NOOP("CoreWords", "choose calibration %1 of camera %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "choose registration %1 of camera %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "link a lost video")},
        {QT_TRANSLATE_NOOP("CoreWords", "link %1 lost videos")},
        {QT_TRANSLATE_NOOP("CoreWords", "give %1 the task %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "import trial %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "leave out %1, of which nothing was recorded")},
        {QT_TRANSLATE_NOOP("CoreWords", "complete %1, whose recording was cut off")},
        {QT_TRANSLATE_NOOP("CoreWords", "calibrated from %1 pictures")},
        {QT_TRANSLATE_NOOP("CoreWords", "imported from %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "layout '%1', lens not calibrated")},
        {QT_TRANSLATE_NOOP("CoreWords", "layout '%1', lens of calibration %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "register camera %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "register camera %1 again")},
        {QT_TRANSLATE_NOOP("CoreWords", "register camera %1 through camera %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "register the cameras of layout %1 together")},
        {QT_TRANSLATE_NOOP("CoreWords", "calibrate camera %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "import the lens of camera %1 from %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "check whether camera %1 has moved")},
        {QT_TRANSLATE_NOOP("CoreWords", "remove %1 for good")},
        {QT_TRANSLATE_NOOP("CoreWords", "track %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "measure %1 again")},
        {QT_TRANSLATE_NOOP("CoreWords", "record %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "connect camera %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "take over the set-up of %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "new project")},
    };
    return patterns;
}

} // namespace odo::core_words
