// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/core_words/subjects.h"

namespace odo::core_words {

std::span<const CorePattern> health()
{
    static constexpr CorePattern patterns[] = {
        {QT_TRANSLATE_NOOP("CoreWords", "waiting for the first picture")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 frames/s, none lost")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 frames/s (too slow), none lost")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 frames/s, %2 lost")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 frames/s (too slow), %2 lost")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 frames/s, %2 lost because this machine is too slow")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 frames/s (too slow), %2 lost because this machine is too slow")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 frames/s, %2 lost (%3 on the wire, %4 here)")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 frames/s (too slow), %2 lost (%3 on the wire, %4 here)")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 frames/s, %2 lost on the wire")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 frames/s (too slow), %2 lost on the wire")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 frames/s, %2 lost here")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 frames/s (too slow), %2 lost here")},
        {QT_TRANSLATE_NOOP("CoreWords", "in step to %1 ms")},
        {QT_TRANSLATE_NOOP("CoreWords", "at %1 m/s that is %2 mm")},
        {QT_TRANSLATE_NOOP("CoreWords", "room for %1 s")},
        {QT_TRANSLATE_NOOP("CoreWords", "room for %1 min")},
        {QT_TRANSLATE_NOOP("CoreWords", "room for %1 h")},
        {QT_TRANSLATE_NOOP("CoreWords", "the map is %1 ms behind, none skipped")},
        {QT_TRANSLATE_NOOP("CoreWords", "the map is %1 ms behind, %2 skipped")},
        {QT_TRANSLATE_NOOP("CoreWords", "analysing position %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "analysing %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "check of the project")},
        {QT_TRANSLATE_NOOP("CoreWords", "checking the database")},
        {QT_TRANSLATE_NOOP("CoreWords", "checking %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "analysing")},
        {QT_TRANSLATE_NOOP("CoreWords", "copying the project")},
        {QT_TRANSLATE_NOOP("CoreWords", "looking for the markers in %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "looking for the markers again")},
        {QT_TRANSLATE_NOOP("CoreWords", "looking for files")},
        {QT_TRANSLATE_NOOP("CoreWords", "looking through the media folder")},
        {QT_TRANSLATE_NOOP("CoreWords", "computing the intrinsics")},
        {QT_TRANSLATE_NOOP("CoreWords", "keeping the pictures")},
        {QT_TRANSLATE_NOOP("CoreWords", "recording")},
        {QT_TRANSLATE_NOOP("CoreWords", "writing the last pictures")},
        {QT_TRANSLATE_NOOP("CoreWords", "calibrating camera %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "settling which robot is which")},
        {QT_TRANSLATE_NOOP("CoreWords", "fitting %1 cameras together")},
        {QT_TRANSLATE_NOOP("CoreWords", "taking over the set-up")},
        {QT_TRANSLATE_NOOP("CoreWords", "Simulated camera %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 at %2 frames/s")},
        {QT_TRANSLATE_NOOP("CoreWords", "checking halves against one another")},
        {QT_TRANSLATE_NOOP("CoreWords", "completing a recording that was cut off")},
        {QT_TRANSLATE_NOOP("CoreWords", "done")},
        {QT_TRANSLATE_NOOP("CoreWords", "fitting the lens to %1 pictures")},
        {QT_TRANSLATE_NOOP("CoreWords", "looking about the best place")},
        {QT_TRANSLATE_NOOP("CoreWords", "looking for the board in %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "making the hash of %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "packing %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "unpacking")},
        {QT_TRANSLATE_NOOP("CoreWords", "reading %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "reading line %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "removing %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "tracking, picture %1 of %2")},
    };
    return patterns;
}

} // namespace odo::core_words
