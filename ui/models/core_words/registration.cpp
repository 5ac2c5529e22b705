// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/core_words/subjects.h"

namespace odo::core_words {

std::span<const CorePattern> registration()
{
    static constexpr CorePattern patterns[] = {
        {QT_TRANSLATE_NOOP("CoreWords", "Poor, measure the markers again: %1"), "1"},
        {QT_TRANSLATE_NOOP(
            "CoreWords",
            "%1 markers fit to %2 mm RMS (worst %3, %4 mm), and the floor among them is known to ±%5 mm")},
        {QT_TRANSLATE_NOOP("CoreWords", "Four markers hardly check one another")},
        {QT_TRANSLATE_NOOP("CoreWords", "Four points hardly check one another")},
        {QT_TRANSLATE_NOOP("CoreWords", "a fifth would")},
        {QT_TRANSLATE_NOOP("CoreWords", "The camera was taken as free of distortion, its focal length "
                                        "estimated from the markers (%1 px ± %2)")},
        {QT_TRANSLATE_NOOP("CoreWords", "The camera was taken as free of distortion, its focal length "
                                        "guessed (%1 px), since this view does not determine it")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "The camera was taken as free of distortion, its focal length as %1 px")},
        {QT_TRANSLATE_NOOP("CoreWords", "Calibrate it for positions to rely on")},
        {QT_TRANSLATE_NOOP("CoreWords", "The camera would stand only %1 mm above the floor")},
        {QT_TRANSLATE_NOOP("CoreWords", "if that is wrong, the layout's numbers are no mm")},
        {QT_TRANSLATE_NOOP("CoreWords", "convert its unit")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "through %1 %2 points of the floor fit to %3 mm RMS (worst %4, %5 mm), and the "
                           "floor among them is known to ±%6 mm, of which ±%7 mm come from %8")},
        {QT_TRANSLATE_NOOP(
             "CoreWords",
             "with %1 together %2 markers fit to %3 mm RMS, and the floor among them is known to ±%4 mm"),
         "", "1"},
        {QT_TRANSLATE_NOOP("CoreWords", "The markers and the cameras agree with one another")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 is %2 mm off by all cameras")},
        {QT_TRANSLATE_NOOP("CoreWords", "measure it again")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 is %2 mm off by the one camera that sees it")},
        {QT_TRANSLATE_NOOP("CoreWords", "measure it, or mark it in the picture, again")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 sees %2 %3 px from where the others do")},
        {QT_TRANSLATE_NOOP("CoreWords", "mark it there again")},
        {QT_TRANSLATE_NOOP("CoreWords", "None of the floor among the markers is seen")},
        {QT_TRANSLATE_NOOP("CoreWords", "±%1 mm in the middle, ±%2 mm in the corner near %3")},
        {QT_TRANSLATE_NOOP("CoreWords", "±%1 mm in the middle, ±%2 mm at the edge near %3")},
        {QT_TRANSLATE_NOOP("CoreWords", "±%1 mm in the middle, ±%2 mm near %3")},
        {QT_TRANSLATE_NOOP("CoreWords", "The middle is not seen, ±%1 mm in the corner near %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "The middle is not seen, ±%1 mm at the edge near %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "The middle is not seen, ±%1 mm near %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 % of the floor among the markers is not seen")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 stands where it was registered")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 markers lie within %2 px = %3 mm of their places")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 has moved %2 px = %3 mm")},
        {QT_TRANSLATE_NOOP("CoreWords", "register it again before you record")},
        {QT_TRANSLATE_NOOP("CoreWords", "Marker %1 has moved %2 px = %3 mm, %4 has not")},
        {QT_TRANSLATE_NOOP("CoreWords", "Markers %1 have moved %2 px = %3 mm, %4 has not"), "", "1"},
        {QT_TRANSLATE_NOOP("CoreWords", "put it back, or measure again and register all cameras")},
        {QT_TRANSLATE_NOOP("CoreWords", "put them back, or measure again and register all cameras")},
        {QT_TRANSLATE_NOOP("CoreWords", "Not found again: %1"), "", "1"},
        {QT_TRANSLATE_NOOP("CoreWords", "The length is %1 mm ± %2 mm")},
        {QT_TRANSLATE_NOOP("CoreWords", "It is %1 mm shorter than the %2 mm told")},
        {QT_TRANSLATE_NOOP("CoreWords", "It is %1 mm longer than the %2 mm told")},
        {QT_TRANSLATE_NOOP("CoreWords", "inside the expected error of %1 mm")},
        {QT_TRANSLATE_NOOP("CoreWords", "outside the expected error of %1 mm")},
        {QT_TRANSLATE_NOOP(
            "CoreWords",
            "Check the length itself, whether it lies on the floor, and the places of the markers")},
        {QT_TRANSLATE_NOOP("CoreWords", "Camera '%1' alone says %2 mm")},
        {QT_TRANSLATE_NOOP(
            "CoreWords",
            "look whether the same ends are marked in each picture, and register it again if they are")},
        {QT_TRANSLATE_NOOP("CoreWords", "No place was measured by both analyses")},
        {QT_TRANSLATE_NOOP("CoreWords", "Positions change by %1 mm RMS, at most by %2 mm (at %3 s)")},
        {QT_TRANSLATE_NOOP("CoreWords", "Spikes: %1 instead of %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "The world axes were changed afterwards")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "The world axes were changed afterwards, and all lengths multiplied by %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "It was made through registration %1 of the project")},
    };
    return patterns;
}

} // namespace odo::core_words
