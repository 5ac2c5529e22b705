// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/core_words/subjects.h"

namespace odo::core_words {

std::span<const CorePattern> attentions()
{
    static constexpr CorePattern patterns[] = {
        {QT_TRANSLATE_NOOP("CoreWords",
                           "The lens of camera '%1' was never calibrated, its distortion is taken as none")},
        {QT_TRANSLATE_NOOP("CoreWords", "calibrate it")},
        {QT_TRANSLATE_NOOP("CoreWords", "The lens calibration of camera '%1' is %2 days old")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "if zoom, focus or the camera's settings were touched since, calibrate it again")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "The newest recording of camera '%1' is %2, its lens was calibrated at %3")},
        {QT_TRANSLATE_NOOP("CoreWords", "calibrate it at the size it records")},
        {QT_TRANSLATE_NOOP("CoreWords", "The floor registration of camera '%1' is %2 days old")},
        {QT_TRANSLATE_NOOP("CoreWords", "check that the camera has not moved, or register it again")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "The floor registration of camera '%1' was made before its lens was calibrated")},
        {QT_TRANSLATE_NOOP("CoreWords", "The floor registration of camera '%1' was made with another "
                                        "calibration of its lens than the one in force")},
        {QT_TRANSLATE_NOOP("CoreWords", "register it again")},
        {QT_TRANSLATE_NOOP("CoreWords", "robot '%1' in trial '%2'")},
        {QT_TRANSLATE_NOOP("CoreWords", "view '%1' in trial '%2'")},
        {QT_TRANSLATE_NOOP("CoreWords", "view '%1'")},
        {QT_TRANSLATE_NOOP("CoreWords", "views '%1' and '%2'")},
        {QT_TRANSLATE_NOOP("CoreWords", "no view sees it from %1 s to %2 s (it was at X %3 m, Y %4 m)")},
        {QT_TRANSLATE_NOOP("CoreWords", "no view sees it after %1 s (it was at X %2 m, Y %3 m)")},
        {QT_TRANSLATE_NOOP("CoreWords", "move or add a camera so that the whole task is seen")},
        {QT_TRANSLATE_NOOP("CoreWords", "the figures are of the part that was seen")},
        {QT_TRANSLATE_NOOP("CoreWords", "its results are not those that its analysis gave")},
        {QT_TRANSLATE_NOOP("CoreWords", "they were changed in the file")},
        {QT_TRANSLATE_NOOP("CoreWords", "run odograph check, or analyse the trial again")},
        {QT_TRANSLATE_NOOP("CoreWords", "from %1 s to %2 s it is doubtful whether this is %3 or %4")},
        {QT_TRANSLATE_NOOP(
            "CoreWords",
            "from %1 s to %2 s (the first of %3 times) it is doubtful whether this is %4 or %5")},
        {QT_TRANSLATE_NOOP(
            "CoreWords", "from %1 s to %2 s it is doubtful whether this is %3 or another robot of its look")},
        {QT_TRANSLATE_NOOP("CoreWords", "from %1 s to %2 s (the first of %3 times) it is doubtful whether "
                                        "this is %4 or another robot of its look")},
        {QT_TRANSLATE_NOOP("CoreWords", "give each a colour of its own")},
        {QT_TRANSLATE_NOOP("CoreWords", "in %1 of %2 pictures the views have it at places far apart")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "one of them follows something else, or is not where it was registered")},
        {QT_TRANSLATE_NOOP(
            "CoreWords",
            "look at the outlines, and tell the robot's colour or keep others out of the pictures")},
        {QT_TRANSLATE_NOOP("CoreWords", "in %1 of %2 pictures the views contradict one another")},
        {QT_TRANSLATE_NOOP("CoreWords", "they put it %1 mm apart")},
        {QT_TRANSLATE_NOOP("CoreWords", "a camera was moved after it was registered, the views are out of "
                                        "step, or the robot's height is not what was told")},
        {QT_TRANSLATE_NOOP("CoreWords", "register the cameras again")},
        {QT_TRANSLATE_NOOP("CoreWords", "it is not synchronised but taken as begun together with the first "
                                        "view, so that a moving robot is not where the two views put it")},
        {QT_TRANSLATE_NOOP("CoreWords", "import the videos again and let the offset be found, or tell it")},
        {QT_TRANSLATE_NOOP("CoreWords", "it is in step to %1 ms only, which is %2 mm at 1 m/s")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "let the robot turn, or flash the room's light, where both cameras see it")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "its colour %1 is also that of the floor (%2 % of view %3's picture)")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "put a plate of another colour on it, or tell the colour it really has")},
        {QT_TRANSLATE_NOOP("CoreWords", "robot '%1' is new")},
        {QT_TRANSLATE_NOOP("CoreWords", "it was added with the colour %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "video '%1'")},
        {QT_TRANSLATE_NOOP("CoreWords", "synchronisation of view '%1'")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "camera '%1' is not registered to the floor, so it is taken as begun together")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "the project has no robot to look for, so it is taken as begun together")},
        {QT_TRANSLATE_NOOP("CoreWords", "robot %1 tells an offset of %2, robot %3 %4, which was taken")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "the motion tells an offset of %1, which was taken, and the flash of light %2")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 s and %2 s long, %3 s in common")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "outside it only one view measures, so check that both belong to one run")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 and %2 frames/s")},
        {QT_TRANSLATE_NOOP("CoreWords", "the views are joined by time, check --rate if one is slow motion")},
        {QT_TRANSLATE_NOOP("CoreWords", "it is left out, because nothing was recorded of it")},
        {QT_TRANSLATE_NOOP("CoreWords", "the project's file was deleted, renamed or replaced; recording goes "
                                        "on, and what is in it is rescued at the end")},
        {QT_TRANSLATE_NOOP("CoreWords", "the project's file was deleted, renamed or replaced meanwhile; what "
                                        "was in it is rescued in '%1', which is the project from now on")},
        {QT_TRANSLATE_NOOP("CoreWords", "check its cable, and whether another program uses it")},
        {QT_TRANSLATE_NOOP("CoreWords", "it ended early, because %1"), "1"},
        {QT_TRANSLATE_NOOP("CoreWords", "nothing came for %1 s, because %2"), "2"},
        {QT_TRANSLATE_NOOP("CoreWords", "pictures waited up to %1 s for the disk, and none was lost")},
        {QT_TRANSLATE_NOOP("CoreWords", "record to a faster disk")},
        {QT_TRANSLATE_NOOP("CoreWords", "1 picture was lost because this computer or its disk was too slow")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "%1 pictures were lost because this computer or its disk was too slow")},
        {QT_TRANSLATE_NOOP("CoreWords", "record to a faster disk, or fewer cameras at once")},
        {QT_TRANSLATE_NOOP("CoreWords", "1 picture was lost between the camera and this program")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 pictures were lost between the camera and this program")},
        {QT_TRANSLATE_NOOP("CoreWords", "check cable, bandwidth and what else this machine does")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "1 picture was lost because this machine was too slow to make them in time")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "%1 pictures were lost because this machine was too slow to make them in time")},
        {QT_TRANSLATE_NOOP("CoreWords", "close other programs, or take fewer such cameras at once")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "the video of camera %1 in trial '%2' is lost, and not in the packed project")},
        {QT_TRANSLATE_NOOP("CoreWords", "the video of camera %1 in trial '%2' lies elsewhere and is another "
                                        "file than it was, and not in the packed project")},
        {QT_TRANSLATE_NOOP("CoreWords", "trial '%1'")},
        {QT_TRANSLATE_NOOP("CoreWords", "its recording was cut off")},
        {QT_TRANSLATE_NOOP("CoreWords", "nothing of it had reached the disk, and it is left out")},
        {QT_TRANSLATE_NOOP("CoreWords", "record it again")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 s of %2 view are kept, all but the last second at most")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 s of %2 views are kept, all but the last second at most")},
    };
    return patterns;
}

} // namespace odo::core_words
