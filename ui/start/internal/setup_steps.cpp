// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/internal/setup_steps.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/models/camera_lists.h"

#include <QCoreApplication>
#include <algorithm>

namespace odo {

namespace {

class SetupWords
{
    Q_DECLARE_TR_FUNCTIONS(SetupWords)
};

constexpr std::size_t mostLookedAt = 100; // trials, for one that is measured

/// A name may be as long as a page.
QString shortName(const QString &name)
{
    constexpr qsizetype longest = 40;
    return name.size() > longest ? name.left(longest - 1) + u'…' : name;
}

QString joinedNames(const QStringList &names)
{
    return names.join(QStringLiteral(", "));
}

StepState sources(const SetupState &setup)
{
    QStringList names;
    for (const SetupState::Camera &camera : setup.cameras)
        if (camera.hasRecording || camera.isConnected)
            names << shortName(camera.name);
    if (names.isEmpty())
        return {false,
                SetupWords::tr("Two phones on tripods are enough. Film the robot with both, import the "
                               "clips or drop them on this window; or connect cameras.")};
    return {true, SetupWords::tr("Cameras: %1.").arg(joinedNames(names))};
}

StepState floorStep(const SetupState &setup)
{
    QStringList known, missing;
    for (const SetupState::Camera &camera : setup.cameras) {
        if (camera.isRegistered)
            known << QStringLiteral("%1 %2").arg(shortName(camera.name), camera.floor.text);
        else
            missing << shortName(camera.name);
    }
    if (known.isEmpty())
        return {false, SetupWords::tr("Print the mat, tape it together and lay it where every camera sees it "
                                      "while it films: from it Odograph knows where the floor is.")};
    QString words = SetupWords::tr("Positions on the floor: %1.").arg(joinedNames(known));
    if (!missing.isEmpty())
        words += QLatin1Char(' ') + SetupWords::tr("Not registered yet: %1.").arg(joinedNames(missing));
    return {missing.isEmpty(), words};
}

StepState lens(const SetupState &setup)
{
    QStringList known;
    for (const SetupState::Camera &camera : setup.cameras)
        if (camera.isCalibrated)
            known << shortName(camera.name);
    if (known.isEmpty())
        return {false, SetupWords::tr("A printed board measures the distortion of the lens; without it "
                                      "positions far from the mat are less exact, and their ± says so.")};
    return {known.size() == qsizetype(setup.cameras.size()),
            SetupWords::tr("Calibrated: %1.").arg(joinedNames(known))};
}

StepState robot(const SetupState &setup)
{
    if (setup.robots.isEmpty())
        return {false, SetupWords::tr("A name is enough: Odograph finds a robot of any look by its motion.")};
    constexpr qsizetype mostNamed = 6;
    QStringList shown;
    for (const QString &name : setup.robots.mid(0, mostNamed))
        shown << shortName(name);
    QString names = joinedNames(shown);
    if (setup.robots.size() > mostNamed)
        names = SetupWords::tr("%1 and %2 more").arg(names).arg(setup.robots.size() - mostNamed);
    return {true, SetupWords::tr("Robots: %1.").arg(names)};
}

StepState firstRun(const SetupState &setup)
{
    if (setup.newestTrial.isEmpty())
        return {false, SetupWords::tr("Imported clips are tracked here, or record with connected cameras.")};
    if (!setup.isNewestMeasured)
        return {setup.isMeasured,
                SetupWords::tr("%1 is not measured yet.").arg(shortName(setup.newestTrial))};
    return {true, SetupWords::tr("%1 is measured.").arg(shortName(setup.newestTrial))};
}

} // namespace

Result<MeasuredTrials> readTrials(Project &project)
{
    MeasuredTrials state;
    auto trials = ODO_TRY(project.trials().names());
    std::erase_if(trials, [](const TrialName &trial) { return trial.binned || trial.unfinished; });
    for (std::size_t i = 0; i < std::min(trials.size(), mostLookedAt) && !state.isMeasured; ++i) {
        state.isMeasured = !ODO_TRY(project.analyses().currentMetrics(trials[i].id)).empty();
        state.isNewestMeasured |= i == 0 && state.isMeasured;
    }
    if (!trials.empty())
        state.newestTrial = QString::fromStdString(trials.front().name);
    return state;
}

Result<SetupState> readSetup(Project &project)
{
    SetupState state{ODO_TRY(readTrials(project)), {}, {}};
    for (const CameraRow &row : ODO_TRY(loadCameraRows(project))) {
        const auto recording = ODO_TRY(project.trials().newestRecording(row.camera.id));
        state.cameras.push_back({QString::fromStdString(row.camera.name), cameraBadge(row.registration),
                                 row.registration.has_value(), row.intrinsics.has_value(),
                                 recording.has_value(), !row.camera.deviceUri.empty()});
    }
    for (const RobotRecord &each : ODO_TRY(project.robots().all()))
        state.robots << QString::fromStdString(each.name);
    return state;
}

StepState stateOf(SetupStep step, const SetupState &setup)
{
    switch (step) {
    case SetupStep::Sources:
        return sources(setup);
    case SetupStep::Floor:
        return floorStep(setup);
    case SetupStep::Lens:
        return lens(setup);
    case SetupStep::Robot:
        return robot(setup);
    case SetupStep::FirstRun:
        return firstRun(setup);
    case SetupStep::Report:
        break;
    }
    return {false,
            SetupWords::tr("Path, speed, acceleration and their ±, spikes with reasons: one PDF for each "
                           "trial, or for the class.")};
}

SetupStep nextStep(const SetupState &setup)
{
    for (const SetupStep step : {SetupStep::Sources, SetupStep::Floor, SetupStep::Robot, SetupStep::FirstRun})
        if (!stateOf(step, setup).isDone)
            return step;
    return SetupStep::Report;
}

} // namespace odo
