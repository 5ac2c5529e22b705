// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/workflow/compare/trial_metrics.h"
#include "ui/models/trial_scene.h"

#include <QImage>
#include <QRectF>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class QPainter;

namespace odo {

class Project;

/// An image of one view at a moment of the run.
struct Still
{
    std::int64_t frame = 0;
    QImage image;              ///< null: it cannot be had
    bool isVideoThere = false; ///< whatever of it can be read
};

/// The views of a trial at a moment, at this width. Any thread; slow (decodes, the views beside one another).
std::vector<Still> takeStills(const TrialScene &scene, Nanoseconds time, int widthPx);

/// Which moment of a run is shown. Of many trials decoding is nearly all the time that their report takes: a
/// frame in the middle of a group of H.264 needs all before it.
enum class StillMoment {
    TopSpeed,
    KeyFrame, ///< of the first view, the last one up to the top speed
    None      ///< no stills
};

/// What a report says of one trial: immutable values, safe to share with any thread.
struct TrialContent
{
    TrialScenePtr scene;
    /// of the class of the trial's team in its task; may be empty
    std::map<std::string, ClassMedian> classMedians;
    std::vector<std::optional<double>> calibrationRmsPx; ///< of each view's calibration; nullopt: it has none
    Nanoseconds stillTime{0};
    bool isAtTopSpeed = true;  ///< the time of the stills
    std::vector<Still> stills; ///< one a view
};
using TrialContentPtr = std::shared_ptr<const TrialContent>;

/// Reads what reports need of trials from a project, one after the other. What trials of one class and task
/// have in common is read once. On the project's thread.
class TrialContentReader
{
public:
    TrialContentReader(Project &project, StillMoment moment) : m_project(project), m_moment(moment) {}
    /// With the images of the views, so that this takes as long as decoding them.
    /// Errors: those of loadTrialScene and of the repositories; Cancelled.
    Result<TrialContentPtr> read(const std::string &trial, const CancelToken &cancel = {});

private:
    Result<std::map<std::string, ClassMedian>> classMediansOf(const TrialScene &scene);
    Result<std::vector<std::optional<double>>> calibrationsOf(const TrialScene &scene);

    Project &m_project;
    StillMoment m_moment;
    /// by class and task
    std::map<std::pair<std::string, std::string>, std::map<std::string, ClassMedian>> m_classes;
};

/// When a still says most of a run: at its top speed; at the middle of a run that was not tracked.
Nanoseconds tellingMoment(const TrialScene &scene);

/// Two views of a trial at a moment, one below the other, with the robots' ways and outlines as on the
/// screen, and the views' names; a single one is at the top. Where an image is missing, words replace it.
void drawStills(QPainter &painter, const QRectF &rect, const TrialScene &scene,
                const std::vector<Still> &stills);

/// One of them, as large as fits; gives where it is.
QRectF drawStill(QPainter &painter, const QRectF &rect, const TrialScene &scene, std::size_t view,
                 const Still &still);

} // namespace odo
