// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/models/number_text.h"

#include <QStringList>
#include <vector>

namespace odo {

class Project;

/// What of a project's trials is measured; those in the bin do not count.
struct MeasuredTrials
{
    QString newestTrial;     ///< empty: none
    bool isMeasured = false; ///< the newest trial, or an older one
    bool isNewestMeasured = false;
};
/// On the project's thread; quick.
Result<MeasuredTrials> readTrials(Project &project);

/// How far a project is set up.
struct SetupState : MeasuredTrials
{
    struct Camera
    {
        QString name;
        Badge floor; ///< how well it is registered
        bool isRegistered = false, isCalibrated = false;
        bool hasRecording = false, isConnected = false; ///< a device is known for it
    };
    std::vector<Camera> cameras;
    QStringList robots;
};

/// On the project's thread.
Result<SetupState> readSetup(Project &project);

/// The steps in their order.
enum class SetupStep { Sources, Floor, Lens, Robot, FirstRun, Report };

struct StepState
{
    bool isDone = false;
    QString words; ///< how far it is, a sentence or two
};
StepState stateOf(SetupStep step, const SetupState &setup);

/// The first one that is not done and that nothing works without; the report when all are.
SetupStep nextStep(const SetupState &setup);

} // namespace odo
