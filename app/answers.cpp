// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"

#include "core/analysis/gate_passages.h"
#include "core/analysis/metrics.h"
#include "core/base/units.h"
#include "core/project/message_json.h"
#include "core/video/frame_turn.h"

#include <QDateTime>
#include <QJsonArray>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

QString lensModelName(LensModel model)
{
    switch (model) {
    case LensModel::Standard:
        return QStringLiteral("standard");
    case LensModel::Rational:
        return QStringLiteral("rational");
    case LensModel::Fisheye:
        return QStringLiteral("fisheye");
    }
    return {};
}

const char *codeWord(ErrorCode code)
{
    switch (code) {
    case ErrorCode::InvalidInput:
        return "invalid_input";
    case ErrorCode::NotFound:
        return "not_found";
    case ErrorCode::AlreadyExists:
        return "already_exists";
    case ErrorCode::Io:
        return "io";
    case ErrorCode::NewerFormat:
        return "newer_format";
    case ErrorCode::ReadOnly:
        return "read_only";
    case ErrorCode::Undetermined:
        return "undetermined";
    case ErrorCode::WrongCall:
        return "wrong_call";
    case ErrorCode::Unavailable:
        return "unavailable";
    case ErrorCode::Cancelled:
        return "cancelled";
    case ErrorCode::Internal:
        break;
    }
    return "internal";
}

bool isLowerBound(const Profile &profile, std::string_view name)
{
    const auto metric = std::ranges::find(profile.metrics, name, &Metric::name);
    return metric != profile.metrics.end() && metric->isAtLeast;
}

} // namespace

QJsonObject errorJson(const Error &error)
{
    return {{QStringLiteral("error"),
             QJsonObject{{QStringLiteral("code"), QLatin1String(codeWord(error.code))},
                         {QStringLiteral("text"), QString::fromStdString(error.message())},
                         {QStringLiteral("arguments"),
                          QJsonObject{{QStringLiteral("what"), toJson(error.what)},
                                      {QStringLiteral("why"), toJson(error.why)},
                                      {QStringLiteral("advice"), toJson(error.advice)}}}}}};
}

QJsonObject intrinsicsJson(const Intrinsics &intrinsics)
{
    QJsonArray distortion;
    for (const double coefficient : intrinsics.distortion)
        distortion.append(coefficient);
    return {{QStringLiteral("width"), intrinsics.widthPx},
            {QStringLiteral("height"), intrinsics.heightPx},
            {QStringLiteral("fx"), intrinsics.fxPx},
            {QStringLiteral("fy"), intrinsics.fyPx},
            {QStringLiteral("cx"), intrinsics.cxPx},
            {QStringLiteral("cy"), intrinsics.cyPx},
            {QStringLiteral("model"), lensModelName(intrinsics.model)},
            {QStringLiteral("distortion"), distortion}};
}

QJsonObject syncJson(const TrialRecord &trial)
{
    return {{QStringLiteral("method"), QString::fromStdString(publishedSyncMethod(trial.syncMethod))},
            {QStringLiteral("offset_s"), trial.syncOffsetS},
            {QStringLiteral("offset_sigma_s"), trial.syncOffsetSigmaS},
            {QStringLiteral("score"), trial.syncScore},
            {QStringLiteral("rate_ppm"), trial.syncRate * 1e6},
            {QStringLiteral("rate_sigma_ppm"), trial.syncRateSigma * 1e6}};
}

QJsonObject rangeJson(const TrialRecord &trial)
{
    const TimeSpan range = rangeOf(trial);
    const auto seconds = [](Nanoseconds time) { return double(time.count()) / 1e9; }; // as t_s of exports
    return {{QStringLiteral("from_s"), seconds(range.begin)}, {QStringLiteral("to_s"), seconds(range.end)}};
}

QJsonObject recordingJson(const RecordingRecord &recording)
{
    const double duration = recording.frameTimes.empty() ? 0 : toSeconds(recording.frameTimes.back());
    const double interval = recording.framesPerSecond > 0 ? 1 / recording.framesPerSecond : 0;
    return {
        {QStringLiteral("frames"), qint64(recording.frameTimes.size())},
        {QStringLiteral("fps"), recording.framesPerSecond},
        {QStringLiteral("duration_s"), duration + interval},
        {QStringLiteral("start_offset_s"), recording.startOffsetS},
        {QStringLiteral("start_offset_sigma_s"), recording.startOffsetSigmaS},
        {QStringLiteral("sync_method"), QString::fromStdString(publishedSyncMethod(recording.syncMethod))},
        {QStringLiteral("clock_rate_ppm"), recording.clockRate * 1e6},
        {QStringLiteral("rotation_deg"), clockwiseDegreesOf(recording.orientation)},
        {QStringLiteral("mirrored"), isMirroring(recording.orientation)}};
}

QJsonArray vectorJson(const Eigen::VectorXd &vector)
{
    QJsonArray array;
    for (const double value : vector)
        array.append(value);
    return array;
}

QJsonValue optionalJson(const std::optional<double> &value)
{
    return value ? QJsonValue(*value) : QJsonValue();
}

QJsonObject verdictLevelJson(const TrialVerdict &verdict)
{
    return {{QStringLiteral("level"), QString::fromStdString(wordOf(verdict.level()))},
            {QStringLiteral("accepted"), verdict.isAccepted()}};
}

QJsonArray metricsJson(const std::vector<Metric> &metrics)
{
    QJsonArray array;
    for (const Metric &metric : metrics) {
        QJsonObject one{{QStringLiteral("name"), QString::fromStdString(metric.name)},
                        {QStringLiteral("unit"), QString::fromStdString(metric.unit)},
                        {QStringLiteral("value"), metric.value},
                        {QStringLiteral("sigma"), optionalJson(metric.sigma)}};
        if (metric.isAtLeast)
            one.insert(QStringLiteral("at_least"), true);
        array.append(one);
    }
    return array;
}

QStringList verdictLines(const TrialVerdict &verdict)
{
    if (verdict.checks.empty())
        return {};
    QStringList lines(QStringLiteral("Verdict: %1").arg(QString::fromStdString(wordOf(verdict))));
    for (const TrialCheck &check : verdict.checks)
        if (check.level != CheckLevel::Pass)
            lines << QStringLiteral("  %1: %2")
                         .arg(QString::fromStdString(wordOf(check.level)), english(check.text));
    if (verdict.isAccepted())
        lines << QStringLiteral("  accepted: %1").arg(QString::fromStdString(verdict.acceptance->reason));
    return lines;
}

void insertMainMetrics(QJsonObject &robot, const Profile &profile)
{
    QJsonArray lowerBounds;
    const auto insert = [&](QLatin1StringView key, std::string_view name) {
        robot.insert(key, metricValue(profile, name));
        if (isLowerBound(profile, name))
            lowerBounds.append(key);
    };
    insert(QLatin1StringView("path_length_m"), "path_length");
    insert(QLatin1StringView("duration_s"), "duration");
    insert(QLatin1StringView("mean_speed_m_s"), "mean_speed");
    insert(QLatin1StringView("max_speed_m_s"), "max_speed");
    robot.insert(QStringLiteral("at_least"), lowerBounds);
}

QString mainMetricsText(const Profile &profile)
{
    const auto figure = [&](std::string_view name, int decimals) {
        return (isLowerBound(profile, name) ? QStringLiteral("at least ") : QString()) +
               QString::number(metricValue(profile, name), 'f', decimals);
    };
    return QStringLiteral("path %1 m in %2 s, top speed %3 m/s")
        .arg(figure("path_length", 3), figure("duration", 2), figure("max_speed", 3));
}

void insertMeasuredTime(QJsonObject &robot, const Profile &profile)
{
    QJsonArray gaps;
    for (const TimeSpan &gap : profile.gaps)
        gaps.append(QJsonObject{{QStringLiteral("from_s"), toSeconds(gap.begin)},
                                {QStringLiteral("to_s"), toSeconds(gap.end)}});
    robot.insert(QStringLiteral("gaps"), gaps);
    robot.insert(QStringLiteral("measured_s"), profile.measuredS);
}

QJsonArray spikesJson(const std::vector<Spike> &spikes, const std::vector<Occlusion> &occlusions)
{
    QJsonArray array;
    for (const Spike &spike : spikes)
        array.append(QJsonObject{{QStringLiteral("t_s"), toSeconds(spike.time)},
                                 {QStringLiteral("sample"), qint64(spike.sampleIndex)},
                                 {QStringLiteral("flags"), QString::fromStdString(flagNames(spike.flags))},
                                 {QStringLiteral("reason"), english(reasonAmong(occlusions, spike))}});
    return array;
}

QJsonArray ambiguitiesJson(const std::vector<AmbiguousName> &ambiguities)
{
    QJsonArray array;
    for (const AmbiguousName &ambiguity : ambiguities) {
        QJsonArray others;
        for (const std::string &name : ambiguity.otherNames)
            others.append(QString::fromStdString(name));
        array.append(QJsonObject{{QStringLiteral("from_s"), toSeconds(ambiguity.from)},
                                 {QStringLiteral("to_s"), toSeconds(ambiguity.to)},
                                 {QStringLiteral("others"), others}});
    }
    return array;
}

QJsonArray occlusionsJson(const std::vector<Occlusion> &occlusions)
{
    QJsonArray array;
    for (const Occlusion &one : occlusions) {
        const std::string_view cause = occlusionCauseName(one.cause);
        array.append(
            QJsonObject{{QStringLiteral("from_s"), toSeconds(one.span.begin)},
                        {QStringLiteral("to_s"), toSeconds(one.span.end)},
                        {QStringLiteral("view"), QString::fromStdString(one.view)},
                        {QStringLiteral("cause"), QString::fromUtf8(cause.data(), qsizetype(cause.size()))},
                        {QStringLiteral("other"),
                         one.other.empty() ? QJsonValue() : QJsonValue(QString::fromStdString(one.other))},
                        {QStringLiteral("reason"), english(occlusionWords(one))}});
    }
    return array;
}

QJsonArray namesJson(const std::vector<std::string> &names)
{
    QJsonArray array;
    for (const std::string &name : names)
        array.append(QString::fromStdString(name));
    return array;
}

QJsonArray sentencesJson(const std::vector<Message> &sentences)
{
    QJsonArray array;
    for (const Message &sentence : sentences)
        array.append(english(sentence));
    return array;
}

QString english(const Message &message)
{
    return QString::fromStdString(message.english());
}

QJsonObject variablesJson(const TrialRecord &trial)
{
    QJsonObject json;
    for (const auto &[name, value] : trial.variables) {
        const auto number = parseNumber(value);
        json.insert(QString::fromStdString(name),
                    number ? QJsonValue(*number) : QJsonValue(QString::fromStdString(value)));
    }
    return json;
}

QString dateText(Instant instant)
{
    return QDateTime::fromMSecsSinceEpoch(instant.time_since_epoch().count()).toString(Qt::ISODate);
}

namespace {

QString fromView(std::string_view text)
{
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

QJsonArray pointJson(const Eigen::Vector2d &pointM)
{
    return {toMillimetres(pointM.x()), toMillimetres(pointM.y())};
}

QJsonArray lapsJson(const std::vector<Lap> &laps)
{
    QJsonArray array;
    for (const Lap &lap : laps) {
        QJsonArray sectors;
        for (const Sector &sector : lap.sectors)
            sectors.append(QJsonObject{{QStringLiteral("to"), QString::fromStdString(sector.gate)},
                                       {QStringLiteral("time_s"), sector.timeS},
                                       {QStringLiteral("sigma_s"), sector.sigmaS}});
        array.append(QJsonObject{{QStringLiteral("start_s"), toSeconds(lap.start)},
                                 {QStringLiteral("time_s"), lap.timeS},
                                 {QStringLiteral("sigma_s"), lap.sigmaS},
                                 {QStringLiteral("sectors"), sectors}});
    }
    return array;
}

QString timeText(double timeS, double sigmaS)
{
    return QStringLiteral("%1 s ±%2 s").arg(timeS, 0, 'f', 4).arg(sigmaS, 0, 'f', 4);
}

} // namespace

QJsonObject taskJson(const TaskRecord &record)
{
    const Task &task = record.task;
    QJsonArray gates, points, zones;
    for (const Gate &gate : task.gates)
        gates.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(gate.name)},
                                 {QStringLiteral("role"), fromView(gateRoleWord(gate.role))},
                                 {QStringLiteral("from_mm"), pointJson(gate.from)},
                                 {QStringLiteral("to_mm"), pointJson(gate.to)}});
    for (const Eigen::Vector2d &point : task.path.points)
        points.append(pointJson(point));
    for (const Zone &zone : task.zones) {
        QJsonArray corners;
        for (const Eigen::Vector2d &corner : zone.corners)
            corners.append(pointJson(corner));
        zones.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(zone.name)},
                                 {QStringLiteral("rule"), fromView(zoneRuleWord(zone.rule))},
                                 {QStringLiteral("corners_mm"), corners}});
    }
    const auto limit = [](const std::optional<double> &value) {
        return value ? QJsonValue(toMillimetres(*value)) : QJsonValue();
    };
    return {{QStringLiteral("name"), QString::fromStdString(record.name)},
            {QStringLiteral("template"), fromView(taskTemplateWord(task.kind))},
            {QStringLiteral("gates"), gates},
            {QStringLiteral("reference_path"),
             points.isEmpty() ? QJsonValue()
                              : QJsonObject{{QStringLiteral("points_mm"), points},
                                            {QStringLiteral("closed"), task.path.closed}}},
            {QStringLiteral("limits"),
             QJsonObject{{QStringLiteral("speed_mm_s"), limit(task.limits.maxSpeedMps)},
                         {QStringLiteral("acceleration_mm_s2"), limit(task.limits.maxAccelMps2)}}},
            {QStringLiteral("zones"), zones}};
}

void insertTaskAnswers(QJsonObject &robot, const Profile &profile)
{
    QJsonArray gates;
    for (const GatePassage &passage : profile.passages)
        gates.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(passage.gate)},
                                 {QStringLiteral("role"), fromView(gateRoleWord(passage.role))},
                                 {QStringLiteral("time_s"), toSeconds(passage.time)},
                                 {QStringLiteral("sigma_s"), passage.sigmaS}});
    robot.insert(QStringLiteral("gates"), gates);
    robot.insert(QStringLiteral("laps"), lapsJson(lapsOf(profile.passages)));
    QJsonObject path;
    for (const Metric &metric : profile.metrics) {
        const QString name = QString::fromStdString(metric.name);
        if (metric.name == "path_completed")
            path.insert(QStringLiteral("completed"), metric.value);
        if (!name.startsWith(QStringLiteral("cross_track_")))
            continue;
        const QString figure = name.mid(QStringLiteral("cross_track_").size()) + QStringLiteral("_mm");
        path.insert(figure, metric.value);
        path.insert(QStringLiteral("sigma_") + figure, optionalJson(metric.sigma));
    }
    if (!path.isEmpty())
        robot.insert(QStringLiteral("path"), path);
}

QStringList taskLines(const Profile &profile)
{
    QStringList lines;
    for (const GatePassage &passage : profile.passages)
        lines << QStringLiteral("  gate %1 at %2")
                     .arg(QString::fromStdString(passage.gate),
                          timeText(toSeconds(passage.time), passage.sigmaS));
    const bool laps =
        std::any_of(profile.passages.begin(), profile.passages.end(),
                    [](const GatePassage &passage) { return passage.role == GateRole::StartFinish; });
    int number = 0;
    for (const Lap &lap : lapsOf(profile.passages)) {
        QStringList sectors;
        for (const Sector &sector : lap.sectors)
            sectors << QStringLiteral("to %1 %2")
                           .arg(QString::fromStdString(sector.gate), timeText(sector.timeS, sector.sigmaS));
        lines << QStringLiteral("  %1 %2: %3 (%4)")
                     .arg(laps ? QStringLiteral("lap") : QStringLiteral("run"))
                     .arg(++number)
                     .arg(timeText(lap.timeS, lap.sigmaS), sectors.join(QStringLiteral(", ")));
    }
    return lines;
}

QString taskRemark(const Profile &profile)
{
    static constexpr std::array<std::pair<std::string_view, const char *>, 4> told{
        {{"gate_time", "gate time"},
         {"best_lap", "best lap"},
         {"cross_track_rms", "off the path (RMS)"},
         {"zone_time", "time beyond zones"}}};
    QString remark;
    for (const Metric &metric : profile.metrics) {
        for (const auto &[name, words] : told) {
            if (metric.name != name)
                continue;
            const int decimals = metric.unit == "s" ? 4 : 1;
            remark += QStringLiteral(", %1 %2 ±%3 %4")
                          .arg(QString::fromLatin1(words))
                          .arg(metric.value, 0, 'f', decimals)
                          .arg(metric.sigma.value_or(0), 0, 'f', decimals)
                          .arg(QString::fromStdString(metric.unit));
        }
    }
    return remark;
}

namespace {

QString milliseconds(double seconds)
{
    return QStringLiteral("%1 ms").arg(1e3 * seconds, 0, 'f', 1);
}

QString begunText(double offsetS)
{
    return offsetS < 0 ? QStringLiteral("started %1 earlier").arg(milliseconds(-offsetS))
                       : QStringLiteral("started %1 later").arg(milliseconds(offsetS));
}

QString stepText(const RecordingRecord &view)
{
    if (view.syncMethod == "told")
        return QStringLiteral("%1, as entered").arg(begunText(view.startOffsetS));
    if (!isStepMeasured(view))
        return QStringLiteral("not synchronised; assumed to have started at the same time");
    QString text = QStringLiteral("synchronised to ±%1 by %2; %3")
                       .arg(milliseconds(view.startOffsetSigmaS),
                            view.syncMethod == "clock"   ? QStringLiteral("the cameras' time stamps")
                            : view.syncMethod == "flash" ? QStringLiteral("a flash of light")
                            : view.syncMethod == "audio" ? QStringLiteral("sound")
                                                         : QStringLiteral("the motion"),
                            begunText(view.startOffsetS));
    if (view.clockRate != 0)
        text += QStringLiteral(", its clock %1 ppm %2")
                    .arg(1e6 * std::abs(view.clockRate), 0, 'f', 0)
                    .arg(view.clockRate > 0 ? QStringLiteral("fast") : QStringLiteral("slow"));
    return text;
}

} // namespace

QStringList stepSentences(const std::vector<RecordingRecord> &views)
{
    QStringList lines;
    for (std::size_t i = 1; i < views.size(); ++i)
        lines << QStringLiteral("View %1: %2")
                     .arg(QString::fromStdString(views[i].cameraName), stepText(views[i]));
    return lines;
}

} // namespace odo
