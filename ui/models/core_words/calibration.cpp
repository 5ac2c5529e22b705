// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/core_words/subjects.h"

namespace odo::core_words {

std::span<const CorePattern> calibration()
{
    static constexpr CorePattern patterns[] = {
        {QT_TRANSLATE_NOOP("CoreWords", "Good: %1"), "1"},
        {QT_TRANSLATE_NOOP("CoreWords", "Usable: %1"), "1"},
        {QT_TRANSLATE_NOOP("CoreWords", "Poor: %1"), "1"},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "no figure in millimetres, since this lens holds only for a part of the picture")},
        {QT_TRANSLATE_NOOP(
             "CoreWords",
             "±%1 mm in the middle and ±%2 mm at worst (%3) on %4, as far as the lens is concerned"),
         "34"},
        {QT_TRANSLATE_NOOP("CoreWords", "in the far left corner")},
        {QT_TRANSLATE_NOOP("CoreWords", "in the far right corner")},
        {QT_TRANSLATE_NOOP("CoreWords", "in the near left corner")},
        {QT_TRANSLATE_NOOP("CoreWords", "in the near right corner")},
        {QT_TRANSLATE_NOOP("CoreWords", "at the far edge")},
        {QT_TRANSLATE_NOOP("CoreWords", "at the near edge")},
        {QT_TRANSLATE_NOOP("CoreWords", "at the left edge")},
        {QT_TRANSLATE_NOOP("CoreWords", "at the right edge")},
        {QT_TRANSLATE_NOOP("CoreWords", "inside")},
        {QT_TRANSLATE_NOOP("CoreWords", "a %1 m × %2 m floor seen from %3 m above")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 pictures fit to %2 px, focal length %3 px ± %4 %")},
        {QT_TRANSLATE_NOOP(
            "CoreWords",
            "each half of them foretells the other to %1 px, %2 mm apart at worst on that floor")},
        {QT_TRANSLATE_NOOP("CoreWords", "each half of them foretells the other to %1 px")},
        {QT_TRANSLATE_NOOP(
            "CoreWords",
            "%1 pictures fit to %2 px, focal length %3 px ± %4 %, %5 mm apart at worst on that floor")},
        {QT_TRANSLATE_NOOP("CoreWords", "Standard lens")},
        {QT_TRANSLATE_NOOP("CoreWords", "Rational lens")},
        {QT_TRANSLATE_NOOP("CoreWords", "Fisheye lens")},
        {QT_TRANSLATE_NOOP("CoreWords", "standard")},
        {QT_TRANSLATE_NOOP("CoreWords", "rational")},
        {QT_TRANSLATE_NOOP("CoreWords", "fisheye")},
        {QT_TRANSLATE_NOOP("CoreWords", "told")},
        {QT_TRANSLATE_NOOP("CoreWords", "no other model fits")},
        {QT_TRANSLATE_NOOP("CoreWords", "not all")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 px")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "it foretells pictures held out to %1, the %2 one to %3, which may be chance"),
         "123"},
        {QT_TRANSLATE_NOOP("CoreWords", "it foretells pictures held out to %1, the %2 one no better (%3)"),
         "123"},
        {QT_TRANSLATE_NOOP("CoreWords", "it foretells pictures held out to %1, the %2 one only to %3"),
         "123"},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 % of the corners disagree, in %2"), "", "2"},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 % of the corners disagree, most in %2"), "", "2"},
        {QT_TRANSLATE_NOOP("CoreWords", "they were kept")},
        {QT_TRANSLATE_NOOP(
            "CoreWords",
            "look at these pictures and leave out those that are blurred, bent or of another board")},
        {QT_TRANSLATE_NOOP("CoreWords", "1 corner that stands out was left out, in %1"), "", "1"},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 corners that stand out were left out, in %2"), "", "2"},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 corners that stand out were left out, most in %2"), "", "2"},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 corners that stand out side by side were kept, in %2"), "", "2"},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 corners that stand out side by side were kept, most in %2"), "",
         "2"},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "leave out these pictures if the board is bent, cut or covered there")},
        {QT_TRANSLATE_NOOP("CoreWords", "More pictures (%1 or more) would make it surer")},
        {QT_TRANSLATE_NOOP("CoreWords", "Only %1 % of the picture was covered")},
        {QT_TRANSLATE_NOOP("CoreWords", "show the board near its edges too")},
        {QT_TRANSLATE_NOOP("CoreWords", "Look at %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "its %1 px stand out")},
    };
    return patterns;
}

} // namespace odo::core_words
