// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/scene_report.h"

#include <QJsonArray>
#include <cmath>

namespace odo::test {

namespace {

QString shareText(const AccuracySums &sums, long count)
{
    return QString::number(100 * sums.share(count), 'f', 1).rightJustified(6);
}

QString ofText(long part, long whole)
{
    return whole > 0 ? QStringLiteral("%1/%2").arg(part).arg(whole).rightJustified(9)
                     : QStringLiteral("-").rightJustified(9);
}

QString demandText(const BarResult &bar)
{
    if (bar.atLeast == bar.atMost)
        return QString::number(bar.atLeast);
    if (bar.atLeast > 0 && bar.atMost > 1)
        return QStringLiteral("%1 to %2").arg(bar.atLeast).arg(bar.atMost);
    return bar.atLeast > 0 ? QStringLiteral("at least %1").arg(bar.atLeast)
                           : QStringLiteral("at most %1").arg(bar.atMost);
}

QJsonValue jsonOf(const std::optional<double> &value)
{
    return value ? QJsonValue(*value) : QJsonValue();
}

QJsonObject sceneJson(const MeasuredScene &measured)
{
    const AccuracySums sums = measured.sums();
    return {{QStringLiteral("scene"), QString::fromStdString(measured.scene.name)},
            {QStringLiteral("seed"), int(measured.scene.seed)},
            {QStringLiteral("hard"), measured.scene.kind == SceneKind::Hard},
            {QStringLiteral("size_told"), measured.scene.hasGivenSize()},
            {QStringLiteral("frames"), qint64(sums.frames)},
            {QStringLiteral("with_position"), qint64(sums.withPosition)},
            {QStringLiteral("position_rms_mm"), sums.positionRmsMm()},
            {QStringLiteral("position_bias_mm"), sums.biasMm()},
            {QStringLiteral("velocity_rms_mm_s"), sums.velocityRmsMmS()},
            {QStringLiteral("acceleration_rms_mm_s2"), sums.accelerationRmsMmS2()},
            {QStringLiteral("inside_95_x"), sums.share(sums.insideX)},
            {QStringLiteral("inside_95_y"), sums.share(sums.insideY)},
            {QStringLiteral("inside_95_speed"), sums.share(sums.insideSpeed)},
            {QStringLiteral("true_spikes"), qint64(sums.trueSpikes)},
            {QStringLiteral("found_spikes"), qint64(sums.foundSpikes)},
            {QStringLiteral("flagged"), qint64(sums.flagged)},
            {QStringLiteral("justly_flagged"), qint64(sums.justlyFlagged)},
            {QStringLiteral("disturbed"), qint64(sums.disturbed)},
            {QStringLiteral("hidden_in_one_view"), qint64(sums.hiddenInOneView)},
            {QStringLiteral("hidden_with_position"), qint64(sums.hiddenWithPosition)},
            {QStringLiteral("elsewhere"), qint64(sums.elsewhere)},
            {QStringLiteral("exchanges"), qint64(sums.exchanges)},
            {QStringLiteral("offset_error_s"), jsonOf(measured.offsetErrorS)},
            {QStringLiteral("wall_s"), measured.wallS},
            {QStringLiteral("problem"), measured.problem}};
}

} // namespace

QString tableHead()
{
    return QStringLiteral(
        "scene                 frames with%    pos   bias    vel    acc  sigma  in x%  in y%  in "
        "v%   spikes  flagged  hidden "
        "swaps offset_ms  wall_s");
}

QString tableLine(const MeasuredScene &measured)
{
    const AccuracySums sums = measured.sums();
    const double with = sums.frames > 0 ? 100.0 * double(sums.withPosition) / double(sums.frames) : 0;
    QString line =
        QStringLiteral("%1 %2 %3 %4 %5 %6 %7 %8")
            .arg(QStringLiteral("%1/%2")
                     .arg(QString::fromStdString(measured.scene.name))
                     .arg(measured.scene.seed),
                 -21)
            .arg(sums.frames, 6)
            .arg(with, 5, 'f', 1)
            .arg(sums.positionRmsMm(), 6, 'f', 2)
            .arg(sums.biasMm(), 6, 'f', 2)
            .arg(sums.velocityRmsMmS(), 6, 'f', 1)
            .arg(sums.accelerationRmsMmS2(), 6, 'f', 0)
            .arg(sums.withPosition > 0 ? sums.sigmaSumMm / double(sums.withPosition) : 0, 6, 'f', 2);
    line += u' ' + shareText(sums, sums.insideX) + u' ' + shareText(sums, sums.insideY) + u' ' +
            shareText(sums, sums.insideSpeed) + ofText(sums.foundSpikes, sums.trueSpikes) +
            ofText(sums.justlyFlagged, sums.flagged) + ofText(sums.hiddenWithPosition, sums.hiddenInOneView);
    line += QString::number(sums.exchanges).rightJustified(5);
    line += measured.offsetErrorS ? QString::number(1000 * *measured.offsetErrorS, 'f', 2).rightJustified(10)
                                  : QStringLiteral("-").rightJustified(10);
    line += QString::number(measured.wallS, 'f', 1).rightJustified(8);
    return measured.problem.isEmpty() ? line : line + QStringLiteral("\n  ") + measured.problem;
}

QString barsTable(const std::vector<BarResult> &bars)
{
    QString text;
    for (const BarResult &bar : bars)
        text += QStringLiteral("%1 %2  %3 %4 %5\n")
                    .arg(bar.metric, -40)
                    .arg(bar.value, 9, 'f', 3)
                    .arg(demandText(bar), -14)
                    .arg(bar.isMet() ? QStringLiteral("met   ") : QStringLiteral("MISSED"), bar.where);
    return text;
}

QJsonObject reportJson(const std::vector<MeasuredScene> &scenes, const std::vector<BarResult> &bars)
{
    QJsonArray sceneList, barList;
    for (const MeasuredScene &scene : scenes)
        sceneList.append(sceneJson(scene));
    for (const BarResult &bar : bars)
        barList.append(QJsonObject{{QStringLiteral("figure"), bar.metric},
                                   {QStringLiteral("value"), bar.value},
                                   {QStringLiteral("at_least"), bar.atLeast},
                                   {QStringLiteral("at_most"), bar.atMost},
                                   {QStringLiteral("met"), bar.isMet()},
                                   {QStringLiteral("where"), bar.where}});
    return {{QStringLiteral("scenes"), sceneList}, {QStringLiteral("bars"), barList}};
}

} // namespace odo::test
