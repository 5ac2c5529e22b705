// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/help/first_lesson.h"

#include "ui/compare/compare_page.h"
#include "ui/main_window/project_pages.h"
#include "ui/models/timeline.h"
#include "ui/review/review_page.h"

#include <QCoreApplication>
#include <algorithm>

namespace odo {
namespace {

class FirstLessonWords
{
    Q_DECLARE_TR_FUNCTIONS(FirstLesson)
};

constexpr auto aWhile = std::chrono::milliseconds(300);

/// The time line stands elsewhere than at the beginning of the step.
LessonStep::IsDone timeMoved(const ProjectPages &pages, bool playing)
{
    const Timeline &timeline = pages.review().timeline();
    return [&timeline, playing, from = timeline.currentTime()] {
        return timeline.isPlaying() == playing && std::chrono::abs(timeline.currentTime() - from) > aWhile;
    };
}

bool hasSpikes(const ProjectPages &pages)
{
    const TrialScenePtr scene = pages.review().scene();
    return scene && std::ranges::any_of(scene->robots, [](const SceneRobot &robot) {
               return robot.analysis && !robot.analysis->profile.spikes.empty();
           });
}

/// Samples of the trial on screen that a person has judged.
std::ptrdiff_t judged(const ProjectPages &pages)
{
    std::ptrdiff_t count = 0;
    if (const TrialScenePtr scene = pages.review().scene())
        for (const SceneRobot &robot : scene->robots)
            if (robot.analysis)
                count += std::ranges::count_if(robot.analysis->profile.samples, [](const Sample &sample) {
                    return hasFlag(sample.flags, SampleFlag::ByHand);
                });
    return count;
}

LessonStep::IsDone inMode(const ProjectPages &pages, ProjectPages::Mode mode)
{
    return [&pages, mode] { return pages.mode() == mode; };
}

} // namespace

std::vector<LessonStep> firstLesson(const ProjectPages &pages)
{
    return {
        {FirstLessonWords::tr("Play a run"),
         FirstLessonWords::tr("Two cameras watched a robot drive. Press Space: both videos, the map and the "
                              "curves play in step. "
                              "Space again stops."),
         [&pages] { return timeMoved(pages, true); }},
        {FirstLessonWords::tr("Read a figure"),
         FirstLessonWords::tr(
             "Click into the speed curve. The bubble tells the speed at that moment and its ±: how "
             "far off it may be. The band around the curve is where the truth lies in 95 of 100 cases."),
         [&pages] { return timeMoved(pages, false); }},
        {FirstLessonWords::tr("Look at what was flagged"),
         FirstLessonWords::tr("Go through the trials with Ctrl+Page Up and Ctrl+Page Down to one whose list "
                              "of spikes, at the right, "
                              "is not empty. A spike is a moment at which what was measured cannot be true; "
                              "the list says why."),
         [&pages] { return [&pages] { return hasSpikes(pages); }; }},
        {FirstLessonWords::tr("Overrule it"),
         FirstLessonWords::tr("Click a spike in the list and look at the videos: was the robot really there? "
                              "Press U to use the sample "
                              "all the same. Nothing that was measured is ever lost."),
         [&pages] { return [&pages, before = judged(pages)] { return judged(pages) > before; }; }},
        {FirstLessonWords::tr("Take it back"),
         FirstLessonWords::tr("Press Ctrl+Z. Whatever you change is saved at once, and can be taken back."),
         [&pages] {
             return [&pages, before = judged(pages)] { return judged(pages) < before || before == 0; };
         }},
        {FirstLessonWords::tr("Compare two runs"),
         FirstLessonWords::tr("Press Ctrl+4. Choose two runs at the right: where was one faster, and is that "
                              "more than the error? "
                              "What is grey is not."),
         [&pages] { return inMode(pages, ProjectPages::Mode::Compare); }},
        {FirstLessonWords::tr("Find it again"),
         FirstLessonWords::tr("Press Ctrl+5. History holds the whole year: type a team's name to search, "
                              "open a run with Enter, and see "
                              "under Teams who made progress."),
         [&pages] { return inMode(pages, ProjectPages::Mode::History); }},
        {FirstLessonWords::tr("That was it"),
         FirstLessonWords::tr("With your own robots: make a project (Ctrl+N), set up the floor in Testbed "
                              "(Ctrl+1), then record (Ctrl+2) "
                              "or bring in videos (Ctrl+I). F1 explains each page."),
         {}},
    };
}

} // namespace odo
