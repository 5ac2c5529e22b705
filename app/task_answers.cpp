// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/task_answers.h"

#include "app/json_answers.h"
#include "core/trajectory/gate_passages.h"

#include <QJsonArray>

namespace odo {

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
            {QStringLiteral("limits"), QJsonObject{{QStringLiteral("speed_mm_s"), limit(task.limits.maxSpeedMps)},
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
                     .arg(QString::fromStdString(passage.gate), timeText(toSeconds(passage.time), passage.sigmaS));
    const bool laps = std::any_of(profile.passages.begin(), profile.passages.end(),
                                  [](const GatePassage &passage) { return passage.role == GateRole::StartFinish; });
    int number = 0;
    for (const Lap &lap : lapsOf(profile.passages)) {
        QStringList sectors;
        for (const Sector &sector : lap.sectors)
            sectors << QStringLiteral("to %1 %2").arg(QString::fromStdString(sector.gate), timeText(sector.timeS, sector.sigmaS));
        lines << QStringLiteral("  %1 %2: %3 (%4)")
                     .arg(laps ? QStringLiteral("lap") : QStringLiteral("run"))
                     .arg(++number)
                     .arg(timeText(lap.timeS, lap.sigmaS), sectors.join(QStringLiteral(", ")));
    }
    return lines;
}

QString taskRemark(const Profile &profile)
{
    static constexpr std::array<std::pair<std::string_view, const char *>, 4> told{{{"gate_time", "gate time"},
                                                                                  {"best_lap", "best lap"},
                                                                                  {"cross_track_rms", "off the path (RMS)"},
                                                                                  {"zone_time", "in breach of zones"}}};
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

} // namespace odo
