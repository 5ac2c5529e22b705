// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/trial_lines.h"

#include "core/analysis/zone_visits.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"

#include <QCoreApplication>
#include <vector>

namespace odo {

namespace {

class TrialLinesWords
{
    Q_DECLARE_TR_FUNCTIONS(TrialLines)
};

QString timeText(const CurveValue &seconds)
{
    return numberText(seconds.value, seconds.sigma, QStringLiteral("s")).text();
}

} // namespace

SyncPassport passportOf(const TrialScene &scene)
{
    std::vector<const RecordingRecord *> recordings;
    for (const SceneView &view : scene.views)
        recordings.push_back(&view.recording);
    std::vector<const Profile *> profiles;
    for (const SceneRobot &robot : scene.robots)
        if (robot.analysis)
            profiles.push_back(&robot.analysis->profile);
    return syncPassport(scene.trial, recordings, profiles);
}

QStringList passportLines(const SyncPassport &passport)
{
    QStringList lines;
    for (const Message &sentence : passportSentences(passport))
        lines << fullSentence(shownWords(sentence));
    return lines;
}

Explanation explainPassport(const TrialScene &scene, const QString &value)
{
    Explanation explanation;
    explanation.what = TrialLinesWords::tr("What the synchronisation is worth");
    explanation.value = value;
    explanation.formula = TrialLinesWords::tr(
        "σ of the time anywhere in the recording, of the offset and of the clock rate over its length, times "
        "the run's top speed. The remaining time error τ is that of d² = d₀² + τ²v² between the views' "
        "distance d and the speed v: least squares over means of half a second.");
    explanation.uncertainty = TrialLinesWords::tr(
        "of τ: by the scatter of those means. Blur grows with the speed, too, so τ is at most as stated.");
    for (const SceneView &view : scene.views)
        explanation.inputs << TrialLinesWords::tr("view %1: %2 frames")
                                  .arg(QString::fromStdString(view.camera))
                                  .arg(view.recording.frameTimes.size());
    return explanation;
}

QString costText(const SyncPassport &passport, std::size_t view)
{
    if (view == 0 || view > passport.views.size() || !passport.views[view - 1].costM)
        return {};
    return TrialLinesWords::tr("±%1 at the top speed").arg(lengthText(passport.views[view - 1].costM->value));
}

QStringList zoneVisitLines(const TrialScene &scene, std::size_t robot)
{
    const std::optional<AnalysisRecord> &analysis = scene.robots.at(robot).analysis;
    QStringList lines;
    if (!analysis || !scene.task || analysis->task != scene.taskId)
        return lines;
    for (const ZoneVisits &visits :
         findZoneVisits(scene.task->zones, analysis->profile.samples, analysis->profile.points)) {
        const QString zone = QString::fromStdString(visits.zone);
        if (!visits.latencyS) {
            lines << TrialLinesWords::tr("%1: never inside").arg(zone);
            continue;
        }
        QString line = (visits.isAtLeast ? TrialLinesWords::tr("%1: inside for at least %2")
                                         : TrialLinesWords::tr("%1: inside for %2"))
                           .arg(zone, timeText(visits.insideS));
        if (visits.beginsInside)
            line += TrialLinesWords::tr(", from the start");
        if (visits.entries > 0)
            line += TrialLinesWords::tr(", entered %n time(s)", nullptr, visits.entries);
        if (!visits.beginsInside)
            line += TrialLinesWords::tr(", first after %1").arg(timeText(*visits.latencyS));
        lines << line;
    }
    return lines;
}

} // namespace odo
