// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/output_file.h"
#include "core/files/protected_files.h"
#include "core/workflow/job.h"
#include "ui/models/trial_scene.h"

#include <QFont>
#include <QSize>
#include <string>

namespace odo {

class AnnotatedFrame;

/// How a trial's annotated video is made.
struct AnnotatedVideoSettings
{
    static bool isSpeed(double speed); ///< from 0.1 to 1
    static bool isSize(QSize sizePx);  ///< even, from 320x180 to 3840x2160

    OutputTarget target;      ///< .mp4, or .mkv
    QSize sizePx{1920, 1080}; ///< even
    double speed = 1;         ///< times the pace of the run; below 1 is slow motion
    bool isDark = false;
};

/// The times of the first view that get an image: all of its frames (of a trial with a range those within
/// it), and of a fast camera so many that no more than 60 are shown a second.
std::vector<Nanoseconds> shownTimes(const std::vector<Nanoseconds> &frameTimes, double speed);

/// Makes one video (H.264, 4:2:0) of a trial: all views with their overlays, the map and the speed, as
/// AnnotatedFrame paints them; an image for each of shownTimes. What fails or is cancelled leaves nothing,
/// and an older file of that name as it was (OutputFile). Prepare on the GUI thread; needs a QGuiApplication.
/// Errors: a size or speed out of range, a trial without videos, a video that is lost, those of VideoWriter.
class AnnotatedVideoJob : public Job
{
public:
    AnnotatedVideoJob(std::string trial, AnnotatedVideoSettings settings);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &) override { return {}; }

    int frameCount() const { return m_frameCount; }  ///< that were written; after run
    double durationS() const { return m_durationS; } ///< of the video; after run

private:
    Message what() const;
    Result<void> writeImages(const JobControl &control, AnnotatedFrame &painter);

    std::string m_trial;
    AnnotatedVideoSettings m_settings;
    TrialScenePtr m_scene;
    InputFiles m_inputs;
    QFont m_font;
    int m_frameCount = 0;
    double m_durationS = 0;
};

} // namespace odo
