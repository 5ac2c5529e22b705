// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/job_words.h"

#include "ui/main_window/internal/trial_actions.h"
#include "ui/models/explanation.h"
#include "ui/models/shown_message.h"

namespace odo {

namespace {

QString withWarnings(QStringList sentences, const std::vector<Message> &warnings)
{
    for (const Message &warning : warnings)
        sentences << shownWords(warning);
    return sentences.join(QLatin1Char(' '));
}

} // namespace

QString importedWords(const TrialRecord &trial, const std::vector<Message> &warnings)
{
    return withWarnings({TrialActions::tr("%1 is imported.").arg(QString::fromStdString(trial.name))},
                        warnings);
}

QString trackedWords(const TrackOutcome &outcome)
{
    QStringList parts;
    for (const TrackedRobot &robot : outcome.robots)
        parts << TrialActions::tr("%1 in %2 of %3 frames, spikes flagged: %4")
                     .arg(QString::fromStdString(robot.name))
                     .arg(robot.tracked)
                     .arg(robot.frames)
                     .arg(robot.analysis.profile.spikes.size());
    return withWarnings({TrialActions::tr("%1 is tracked: %2.")
                             .arg(QString::fromStdString(outcome.trial), parts.join(QStringLiteral("; ")))},
                        outcome.warnings);
}

QString synchronisedWords(const SynchroniseJob &job)
{
    QStringList sentences{
        TrialActions::tr("%1 is synchronised.").arg(QString::fromStdString(job.trial().name))};
    for (const RecordingRecord &view : job.recordings())
        if (view.position > 0)
            sentences << QStringLiteral("%1: %2.").arg(QString::fromStdString(view.cameraName),
                                                       stepText(view));
    return withWarnings(std::move(sentences), job.warnings());
}

} // namespace odo
