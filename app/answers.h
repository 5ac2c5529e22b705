// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/trajectory/occlusions.h"
#include "core/workflow/track/trial_verdict.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>

namespace odo {

/// The parts that several subcommands print, as docs/cli.md names them.
/// What is printed where a call with --json fails.
QJsonObject errorJson(const Error &error);
QJsonObject intrinsicsJson(const Intrinsics &intrinsics);
QJsonObject syncJson(const TrialRecord &trial);
/// {from_s, to_s}: the range of a trial; of one without, all of its time.
QJsonObject rangeJson(const TrialRecord &trial);
QJsonObject recordingJson(const RecordingRecord &recording);
QJsonArray vectorJson(const Eigen::VectorXd &vector);
/// {level, accepted}, without the checks.
QJsonObject verdictLevelJson(const TrialVerdict &verdict);
QJsonArray metricsJson(const std::vector<Metric> &metrics);
/// "Verdict: doubtful", with the sentences that say why, and the reason why it was accepted.
QStringList verdictLines(const TrialVerdict &verdict);
/// path_length_m, duration_s, mean_speed_m_s and max_speed_m_s; at_least names those that are lower bounds.
void insertMainMetrics(QJsonObject &robot, const Profile &profile);
/// "path 4.485 m in 3.20 s, top speed 1.640 m/s"; "at least" stands before what is a lower bound.
QString mainMetricsText(const Profile &profile);
/// gaps[{from_s, to_s}], when nothing was measured, and measured_s, how long something was.
void insertMeasuredTime(QJsonObject &robot, const Profile &profile);
/// When it is ambiguous which robot it is: [{from_s, to_s, others[]}].
QJsonArray ambiguitiesJson(const std::vector<AmbiguousName> &ambiguities);
/// When which view did not measure the whole of it: [{from_s, to_s, view, cause, other, reason}].
QJsonArray occlusionsJson(const std::vector<Occlusion> &occlusions);
/// Each with its reason among the robot's occlusions.
QJsonArray spikesJson(const std::vector<Spike> &spikes, const std::vector<Occlusion> &occlusions);
/// null where there is none.
QJsonValue optionalJson(const std::optional<double> &value);
QJsonArray namesJson(const std::vector<std::string> &names);
QJsonArray sentencesJson(const std::vector<Message> &sentences);

/// A message as the command line prints it.
QString english(const Message &message);

/// By the clock on the wall here, to the second: "2026-11-23T15:04:05".
QString dateText(Instant instant);
/// A trial's own variables by name; what reads as a number is one.
QJsonObject variablesJson(const TrialRecord &trial);

/// A task with the fields that a task file has (core/exchange/task_file.h), and its name.
QJsonObject taskJson(const TaskRecord &record);

/// What a task adds to a robot's answer: gates, laps, and path where there is one.
void insertTaskAnswers(QJsonObject &robot, const Profile &profile);

/// Lines for people: the passages, and the laps with their sectors.
QStringList taskLines(const Profile &profile);
/// ", gate time 2.405 s ±0.002 s" and the like; empty without a task.
QString taskRemark(const Profile &profile);

/// One line for each view but the first: how it was synchronised with the first one, and how well: "View B:
/// synchronised to ±0.3 ms by the motion; started 413.7 ms later". None for a single view.
QStringList stepSentences(const std::vector<RecordingRecord> &views);

/// "1 page", "2 pages": for nouns whose plural ends in s.
template <class Number>
QString counted(Number count, const QString &noun)
{
    return QString::number(count) + u' ' + noun + (count == 1 ? QString() : QStringLiteral("s"));
}

} // namespace odo
