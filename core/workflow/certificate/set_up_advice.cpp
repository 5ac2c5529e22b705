// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/certificate/set_up_advice.h"

#include "core/analysis/metrics.h"
#include "core/project/project.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double usualMarkerSigmaPx = 0.3, usualHeightM = 0.06;
constexpr double usualTimeSigmaS = 0.5e-3;

/// What the residuals of its registration say, if that is more than usual. Four corners fit nearly always.
double markerSigmaOf(const FloorRegistration &registration)
{
    const double values = 2.0 * double(registration.markers.size()), free = values - 6;
    return free <= 2 ? usualMarkerSigmaPx
                     : std::max(usualMarkerSigmaPx, registration.rmsPx * std::sqrt(values / 2 / free));
}

/// Top speed and σ of the time offset of the newest trial that was measured.
Result<void> readNewestRun(Project &project, const SetUpQuestionSettings &settings,
                           PlacementQuestion &question)
{
    question.speedMps = settings.speedMps.value_or(0);
    question.timeSigmaS = usualTimeSigmaS;
    const auto trials = ODO_TRY(project.trials().all());
    for (const TrialRecord &trial : trials) {
        const auto analyses = trial.binned ? std::vector<AnalysisRecord>()
                                           : ODO_TRY(project.analyses().currentMetrics(trial.id));
        if (analyses.empty())
            continue;
        for (const AnalysisRecord &analysis : analyses)
            if (const double speed = metricValue(analysis.profile, "max_speed");
                !settings.speedMps && std::isfinite(speed))
                question.speedMps = std::max(question.speedMps, speed);
        const auto recordings = ODO_TRY(project.trials().recordings(trial.id));
        for (const RecordingRecord &recording : recordings)
            question.timeSigmaS = std::max(question.timeSigmaS, recording.startOffsetSigmaS);
        return {};
    }
    return {};
}

} // namespace

Result<SetUpQuestion> readSetUpQuestion(Project &project, const SetUpQuestionSettings &settings)
{
    const auto setUp = ODO_TRY(readCertificateSetUp(project, {{}, settings.robot}));
    SetUpQuestion asked;
    for (const CertificateCamera &camera : setUp.cameras)
        asked.cameras.push_back({camera.name, camera.view, markerSigmaOf(camera.registration.registration)});
    const auto newest = std::ranges::max_element(
        setUp.cameras, {}, [](const CertificateCamera &camera) { return camera.registration.made; });
    asked.layout = newest->layout;
    asked.question.robotHeightM =
        setUp.robot.heightM ? *setUp.robot.heightM : setUp.measuredHeightM.value_or(usualHeightM);
    asked.question.reachM = settings.reachM;
    ODO_TRY(readNewestRun(project, settings, asked.question));
    return asked;
}

} // namespace odo
