// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/core_words/subjects.h"

namespace odo::core_words {

std::span<const CorePattern> spikes()
{
    static constexpr CorePattern patterns[] = {
        {QT_TRANSLATE_NOOP("CoreWords", "views disagree by %1 mm")},
        {QT_TRANSLATE_NOOP("CoreWords", "none could be trusted")},
        {QT_TRANSLATE_NOOP("CoreWords", "one left out")},
        {QT_TRANSLATE_NOOP("CoreWords", "jump of %1 mm")},
        {QT_TRANSLATE_NOOP("CoreWords", "jump")},
        {QT_TRANSLATE_NOOP("CoreWords", "stands out in position and speed")},
        {QT_TRANSLATE_NOOP("CoreWords", "stands out in position")},
        {QT_TRANSLATE_NOOP("CoreWords", "stands out in speed")},
        {QT_TRANSLATE_NOOP("CoreWords", "faster than the limit")},
        {QT_TRANSLATE_NOOP("CoreWords", "harder than the limit of acceleration")},
        {QT_TRANSLATE_NOOP("CoreWords", "called a spike by hand")},
        {QT_TRANSLATE_NOOP("CoreWords", "cut by the picture's edge")},
        {QT_TRANSLATE_NOOP("CoreWords", "the tracker was not sure (score %1 %)")},
        {QT_TRANSLATE_NOOP("CoreWords", "hidden behind %1 in view %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "partly hidden behind %1 in view %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "one outline with %1 in view %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "cut by the frame's edge in view %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "not visible in view %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "outline smaller than usual in view %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "outline larger than usual in view %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "speed limit")},
        {QT_TRANSLATE_NOOP("CoreWords", "acceleration limit")},
        {QT_TRANSLATE_NOOP("CoreWords", "views disagree")},
        {QT_TRANSLATE_NOOP("CoreWords", "low score")},
        {QT_TRANSLATE_NOOP("CoreWords", "lost")},
        {QT_TRANSLATE_NOOP("CoreWords", "duplicate frame")},
        {QT_TRANSLATE_NOOP("CoreWords", "interpolated")},
        {QT_TRANSLATE_NOOP("CoreWords", "by hand")},
    };
    return patterns;
}

} // namespace odo::core_words
