// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/trial_json.h"

#include "core/trajectory/heading.h"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace odo {

namespace {

constexpr int schemaVersion = 1;

QString qtText(const std::string &text)
{
    return QString::fromStdString(text);
}

QString isoText(Instant instant)
{
    return QDateTime::fromMSecsSinceEpoch(instant.time_since_epoch().count(), Qt::UTC)
        .toString(Qt::ISODateWithMs);
}

QJsonValue numberOrNull(double value)
{
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue();
}

QJsonArray flagsOf(SampleFlags flags)
{
    QJsonArray names;
    const QString joined = qtText(flagNames(flags));
    for (const QString &name : joined.split(u'|', Qt::SkipEmptyParts))
        names.append(name);
    return names;
}

QJsonObject trialObject(const TrialRecord &trial)
{
    const QJsonObject sync{{QStringLiteral("method"), qtText(trial.syncMethod)},
                           {QStringLiteral("offset_s"), numberOrNull(trial.syncOffsetS)},
                           {QStringLiteral("offset_sigma_s"), numberOrNull(trial.syncOffsetSigmaS)},
                           {QStringLiteral("score"), numberOrNull(trial.syncScore)},
                           {QStringLiteral("rate"), numberOrNull(trial.syncRate)},
                           {QStringLiteral("rate_sigma"), numberOrNull(trial.syncRateSigma)}};
    return {{QStringLiteral("name"), qtText(trial.name)},
            {QStringLiteral("team"), qtText(trial.teamName)},
            {QStringLiteral("class"), qtText(trial.className)},
            {QStringLiteral("task"), qtText(trial.task)},
            {QStringLiteral("date"), isoText(trial.date)},
            {QStringLiteral("notes"), qtText(trial.notes)},
            {QStringLiteral("duration_s"), numberOrNull(trial.durationS)},
            {QStringLiteral("sync"), sync}};
}

QJsonObject viewObject(const RecordingRecord &recording)
{
    return {{QStringLiteral("name"), qtText(recording.cameraName)},
            {QStringLiteral("path"), qtText(recording.path)},
            {QStringLiteral("sha256"), qtText(recording.sha256)},
            {QStringLiteral("bytes"), static_cast<qint64>(recording.bytes)},
            {QStringLiteral("width_px"), recording.widthPx},
            {QStringLiteral("height_px"), recording.heightPx},
            {QStringLiteral("frames_per_second"), numberOrNull(recording.framesPerSecond)},
            {QStringLiteral("start_offset_s"), numberOrNull(recording.startOffsetS)},
            {QStringLiteral("clock_rate"), numberOrNull(recording.clockRate)},
            {QStringLiteral("frames"), static_cast<qint64>(recording.frameTimes.size())}};
}

/// Where the track came from; null: our own views measured it.
QJsonValue importedOf(const AnalysisRecord &analysis, const std::vector<ImportedTrack> &imported)
{
    for (const ImportedTrack &source : imported) {
        if (source.robot != analysis.robot)
            continue;
        return QJsonObject{{QStringLiteral("file"), qtText(source.file)},
                           {QStringLiteral("sha256"), qtText(source.sha256)},
                           {QStringLiteral("bytes"), static_cast<qint64>(source.bytes)},
                           {QStringLiteral("format"), qtText(source.format)},
                           {QStringLiteral("noise_m"), source.noiseM},
                           {QStringLiteral("reading"), qtText(source.reading)}};
    }
    return {};
}

QJsonObject provenanceObject(const AnalysisRecord &analysis, const std::vector<ImportedTrack> &imported)
{
    QJsonArray views, registrations, overrules;
    for (const Overrule &overrule : analysis.options.overrules)
        overrules.append(QJsonObject{{QStringLiteral("frame"), static_cast<qint64>(overrule.frame)},
                                     {QStringLiteral("spike"), overrule.isSpike}});
    for (const std::string &view : analysis.views)
        views.append(qtText(view));
    for (const RecordId id : analysis.registrations)
        registrations.append(id == 0 ? QJsonValue() : QJsonValue(static_cast<qint64>(id)));
    return {
        {QStringLiteral("made"), isoText(analysis.made)},
        {QStringLiteral("software_version"), qtText(analysis.softwareVersion)},
        {QStringLiteral("smoother"), qtText(std::string(smootherName(analysis.options.smoother)))},
        {QStringLiteral("max_speed_m_s"), numberOrNull(analysis.options.maxSpeedMps)},
        {QStringLiteral("max_accel_m_s2"), numberOrNull(analysis.options.maxAccelMps2)},
        {QStringLiteral("longest_bridged_gap_s"), toSeconds(analysis.options.longestBridgedGap)},
        {QStringLiteral("overrules"), overrules},
        {QStringLiteral("views"), views},
        {QStringLiteral("registrations"), registrations},
        {QStringLiteral("imported"), importedOf(analysis, imported)},
        {QStringLiteral("height_m"), numberOrNull(analysis.profile.heightM)},
        {QStringLiteral("height_estimated"), analysis.profile.heightEstimated},
        {QStringLiteral("mean_view_disagreement_m"), numberOrNull(analysis.profile.meanViewDisagreementM)}};
}

QJsonArray metricsOf(const Profile &profile)
{
    QJsonArray metrics;
    for (const Metric &metric : profile.metrics)
        metrics.append(QJsonObject{
            {QStringLiteral("name"), qtText(metric.name)},
            {QStringLiteral("unit"), qtText(metric.unit)},
            {QStringLiteral("value"), numberOrNull(metric.value)},
            {QStringLiteral("sigma"), metric.sigma ? numberOrNull(*metric.sigma) : QJsonValue()}});
    return metrics;
}

QJsonArray gatesOf(const Profile &profile)
{
    QJsonArray gates;
    for (const GatePassage &passage : profile.passages)
        gates.append(QJsonObject{{QStringLiteral("name"), qtText(passage.gate)},
                                 {QStringLiteral("role"), qtText(std::string(gateRoleWord(passage.role)))},
                                 {QStringLiteral("t_s"), static_cast<double>(passage.time.count()) / 1e9},
                                 {QStringLiteral("sigma_s"), numberOrNull(passage.sigmaS)}});
    return gates;
}

QJsonArray spikesOf(const Profile &profile)
{
    QJsonArray spikes;
    for (const Spike &spike : profile.spikes)
        spikes.append(QJsonObject{{QStringLiteral("t_s"), static_cast<double>(spike.time.count()) / 1e9},
                                  {QStringLiteral("sample"), static_cast<qint64>(spike.sampleIndex)},
                                  {QStringLiteral("flags"), flagsOf(spike.flags)},
                                  {QStringLiteral("reason"), qtText(spike.reason)}});
    return spikes;
}

/// Direction of motion without steps of a whole turn (also while the robot stands, then without σ), and turn
/// rate; SI units.
void addHeadings(QJsonObject &columns, const Profile &profile)
{
    QJsonArray headings, sigmas, turnRates, turnRateSigmas;
    const auto headingSeries = headingsOf(profile.points);
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        const auto &heading = headingSeries[i];
        const auto course = courseOf(profile.points[i]);
        headings.append(heading ? numberOrNull(heading->radians) : QJsonValue());
        sigmas.append(heading && heading->sigmaRad ? numberOrNull(*heading->sigmaRad) : QJsonValue());
        turnRates.append(course ? numberOrNull(course->turnRateRadps) : QJsonValue());
        turnRateSigmas.append(course ? numberOrNull(course->sigmaTurnRateRadps) : QJsonValue());
    }
    columns.insert(QStringLiteral("heading_rad"), headings);
    columns.insert(QStringLiteral("sigma_heading_rad"), sigmas);
    columns.insert(QStringLiteral("turn_rate_rad_s"), turnRates);
    columns.insert(QStringLiteral("sigma_turn_rate_rad_s"), turnRateSigmas);
}

/// The curves, one array a column; SI units.
QJsonObject columnsOf(const Profile &profile)
{
    QJsonArray times, flags;
    for (const Sample &sample : profile.samples) {
        times.append(static_cast<double>(sample.time.count()) / 1e9);
        flags.append(flagsOf(sample.flags));
    }
    QJsonObject columns{{QStringLiteral("t_s"), times}, {QStringLiteral("flags"), flags}};
    const auto addCurve = [&](const QString &name, auto value) {
        QJsonArray numbers;
        for (const ProfilePoint &point : profile.points)
            numbers.append(point.valid ? numberOrNull(value(point)) : QJsonValue());
        columns.insert(name, numbers);
    };
    addCurve(QStringLiteral("x_m"), [](const ProfilePoint &p) { return p.position.x(); });
    addCurve(QStringLiteral("y_m"), [](const ProfilePoint &p) { return p.position.y(); });
    addCurve(QStringLiteral("vx_m_s"), [](const ProfilePoint &p) { return p.velocity.x(); });
    addCurve(QStringLiteral("vy_m_s"), [](const ProfilePoint &p) { return p.velocity.y(); });
    addCurve(QStringLiteral("ax_m_s2"), [](const ProfilePoint &p) { return p.acceleration.x(); });
    addCurve(QStringLiteral("ay_m_s2"), [](const ProfilePoint &p) { return p.acceleration.y(); });
    addCurve(QStringLiteral("speed_m_s"), [](const ProfilePoint &p) { return p.speedMps; });
    addCurve(QStringLiteral("accel_m_s2"), [](const ProfilePoint &p) { return p.accelMps2; });
    addCurve(QStringLiteral("sigma_x_m"), [](const ProfilePoint &p) { return p.sigmaXM; });
    addCurve(QStringLiteral("sigma_y_m"), [](const ProfilePoint &p) { return p.sigmaYM; });
    addCurve(QStringLiteral("sigma_speed_m_s"), [](const ProfilePoint &p) { return p.sigmaSpeedMps; });
    addCurve(QStringLiteral("sigma_accel_m_s2"), [](const ProfilePoint &p) { return p.sigmaAccelMps2; });
    addHeadings(columns, profile);
    for (int axis : {0, 1}) {
        QJsonArray numbers;
        for (const Sample &sample : profile.samples)
            numbers.append(sample.position ? numberOrNull((*sample.position)[axis]) : QJsonValue());
        columns.insert(axis == 0 ? QStringLiteral("raw_x_m") : QStringLiteral("raw_y_m"), numbers);
    }
    return columns;
}

} // namespace

std::string trialJson(const TrialRecord &trial, const std::vector<RecordingRecord> &recordings,
                      const std::vector<AnalysisRecord> &analyses, const std::vector<ImportedTrack> &imported)
{
    QJsonArray views, robots;
    for (const RecordingRecord &recording : recordings)
        views.append(viewObject(recording));
    for (const AnalysisRecord &analysis : analyses)
        robots.append(QJsonObject{{QStringLiteral("name"), qtText(analysis.robotName)},
                                  {QStringLiteral("analysis"), provenanceObject(analysis, imported)},
                                  {QStringLiteral("metrics"), metricsOf(analysis.profile)},
                                  {QStringLiteral("gates"), gatesOf(analysis.profile)},
                                  {QStringLiteral("spikes"), spikesOf(analysis.profile)},
                                  {QStringLiteral("columns"), columnsOf(analysis.profile)}});
    const QJsonObject document{{QStringLiteral("schema"), QStringLiteral("odograph.trial")},
                               {QStringLiteral("version"), schemaVersion},
                               {QStringLiteral("trial"), trialObject(trial)},
                               {QStringLiteral("views"), views},
                               {QStringLiteral("robots"), robots}};
    return QJsonDocument(document).toJson(QJsonDocument::Indented).toStdString();
}

} // namespace odo
