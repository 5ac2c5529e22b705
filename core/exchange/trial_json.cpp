// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/trial_json.h"

#include "core/analysis/quantity_curve.h"
#include "core/project/message_json.h"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

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
    const QJsonObject sync{{QStringLiteral("method"), qtText(publishedSyncMethod(trial.syncMethod))},
                           {QStringLiteral("offset_s"), numberOrNull(trial.syncOffsetS)},
                           {QStringLiteral("offset_sigma_s"), numberOrNull(trial.syncOffsetSigmaS)},
                           {QStringLiteral("score"), numberOrNull(trial.syncScore)},
                           {QStringLiteral("rate"), numberOrNull(trial.syncRate)},
                           {QStringLiteral("rate_sigma"), numberOrNull(trial.syncRateSigma)}};
    const TimeSpan range = rangeOf(trial);
    return {
        {QStringLiteral("name"), qtText(trial.name)},
        {QStringLiteral("team"), qtText(trial.teamName)},
        {QStringLiteral("class"), qtText(trial.className)},
        {QStringLiteral("task"), qtText(trial.task)},
        {QStringLiteral("date"), isoText(trial.date)},
        {QStringLiteral("notes"), qtText(trial.notes)},
        {QStringLiteral("duration_s"), numberOrNull(trial.durationS)},
        {QStringLiteral("range"), QJsonObject{{QStringLiteral("from_s"), double(range.begin.count()) / 1e9},
                                              {QStringLiteral("to_s"), double(range.end.count()) / 1e9}}},
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
                           {QStringLiteral("reading"), qtText(source.reading.english())}};
    }
    return {};
}

QJsonObject provenanceObject(const AnalysisRecord &analysis, const std::vector<ImportedTrack> &imported)
{
    QJsonArray views, registrations, overrides;
    for (const ManualOverride &manualOverride : analysis.options.overrides)
        overrides.append(QJsonObject{{QStringLiteral("frame"), static_cast<qint64>(manualOverride.frame)},
                                     {QStringLiteral("spike"), manualOverride.isSpike}});
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
        {QStringLiteral("overrules"), overrides},
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
        metrics.append(
            QJsonObject{{QStringLiteral("name"), qtText(metric.name)},
                        {QStringLiteral("unit"), qtText(metric.unit)},
                        {QStringLiteral("value"), numberOrNull(metric.value)},
                        {QStringLiteral("sigma"), metric.sigma ? numberOrNull(*metric.sigma) : QJsonValue()},
                        {QStringLiteral("at_least"), metric.isAtLeast}});
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
                                  {QStringLiteral("reason"), qtText(spike.reason.english())}});
    return spikes;
}

/// A column of the curves: "name":[1,null,2], of so many values as `value(i)` gives.
template <class Value>
void addColumn(TextPieces &text, const char *name, std::size_t count, const Value &value)
{
    text.add(std::string(",\n\"") + name + "\": [");
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0)
            text.add(",");
        const std::optional<double> number = value(i);
        text.add(number && std::isfinite(*number)
                     ? QByteArray::number(*number, 'g', QLocale::FloatingPointShortest).toStdString()
                     : "null");
    }
    text.add("]");
}

/// Heading without steps of a whole turn (kept while it is not known, then without σ), what it is of, and
/// turn rate; SI units.
void addHeadings(TextPieces &text, const Profile &profile)
{
    using Number = std::optional<double>;
    const auto headings = headingsOf(profile);
    const std::size_t count = profile.points.size();
    addColumn(text, "heading_rad", count,
              [&](std::size_t i) { return headings[i] ? Number(headings[i]->radians) : std::nullopt; });
    addColumn(text, "sigma_heading_rad", count,
              [&](std::size_t i) { return headings[i] ? headings[i]->sigmaRad : std::nullopt; });
    text.add(",\n\"heading_source\": [");
    for (std::size_t i = 0; i < count; ++i) {
        text.add(i > 0 ? "," : "");
        text.add(headings[i] ? '"' + std::string(headingSource(*headings[i])) + '"' : std::string("null"));
    }
    text.add("]");
    addColumn(text, "turn_rate_rad_s", count, [&](std::size_t i) {
        const auto rate = turnRateOf(profile.points[i]);
        return rate ? Number(rate->value) : std::nullopt;
    });
    addColumn(text, "sigma_turn_rate_rad_s", count, [&](std::size_t i) {
        const auto rate = turnRateOf(profile.points[i]);
        return rate ? Number(rate->sigma) : std::nullopt;
    });
}

/// The curves, one array a column; SI units. They may be long, so that they are written as they are made.
void addColumns(TextPieces &text, const Profile &profile)
{
    using Number = std::optional<double>;
    const std::size_t count = profile.points.size();
    text.add("{\n\"flags\": [");
    for (std::size_t i = 0; i < profile.samples.size(); ++i) {
        if (i > 0)
            text.add(",");
        const SampleFlags flags = profile.samples[i].flags;
        text.add(flags == 0 ? "[]"
                            : QJsonDocument(flagsOf(flags)).toJson(QJsonDocument::Compact).toStdString());
    }
    text.add("]");
    addColumn(text, "t_s", count, [&](std::size_t i) {
        return Number(static_cast<double>(profile.samples[i].time.count()) / 1e9);
    });
    const auto addCurve = [&](const char *name, auto value) {
        addColumn(text, name, count, [&](std::size_t i) {
            return profile.points[i].valid ? Number(value(profile.points[i])) : std::nullopt;
        });
    };
    addCurve("x_m", [](const ProfilePoint &p) { return p.position.x(); });
    addCurve("y_m", [](const ProfilePoint &p) { return p.position.y(); });
    addCurve("vx_m_s", [](const ProfilePoint &p) { return p.velocity.x(); });
    addCurve("vy_m_s", [](const ProfilePoint &p) { return p.velocity.y(); });
    addCurve("ax_m_s2", [](const ProfilePoint &p) { return p.acceleration.x(); });
    addCurve("ay_m_s2", [](const ProfilePoint &p) { return p.acceleration.y(); });
    addCurve("speed_m_s", [](const ProfilePoint &p) { return p.speedMps; });
    addCurve("accel_m_s2", [](const ProfilePoint &p) { return p.accelMps2; });
    addCurve("sigma_x_m", [](const ProfilePoint &p) { return p.sigmaXM; });
    addCurve("sigma_y_m", [](const ProfilePoint &p) { return p.sigmaYM; });
    addCurve("sigma_speed_m_s", [](const ProfilePoint &p) { return p.sigmaSpeedMps; });
    addCurve("sigma_accel_m_s2", [](const ProfilePoint &p) { return p.sigmaAccelMps2; });
    addHeadings(text, profile);
    for (int axis : {0, 1})
        addColumn(text, axis == 0 ? "raw_x_m" : "raw_y_m", count, [&](std::size_t i) {
            return profile.samples[i].position ? Number((*profile.samples[i].position)[axis]) : std::nullopt;
        });
    text.add("\n}");
}

/// Where the columns of a robot belong in the document; a name of a user cannot be that, for it has a control
/// character.
QString columnsMark(std::size_t robot)
{
    return QStringLiteral("\u0001columns %1").arg(robot);
}

QByteArray withoutColumns(const TrialRecord &trial, const std::vector<RecordingRecord> &recordings,
                          std::span<const AnalysisRecord> analyses,
                          const std::vector<ImportedTrack> &imported, const TrialVerdict &verdict)
{
    QJsonArray views, robots;
    for (const RecordingRecord &recording : recordings)
        views.append(viewObject(recording));
    for (std::size_t i = 0; i < analyses.size(); ++i)
        robots.append(QJsonObject{{QStringLiteral("name"), qtText(analyses[i].robotName)},
                                  {QStringLiteral("analysis"), provenanceObject(analyses[i], imported)},
                                  {QStringLiteral("metrics"), metricsOf(analyses[i].profile)},
                                  {QStringLiteral("gates"), gatesOf(analyses[i].profile)},
                                  {QStringLiteral("spikes"), spikesOf(analyses[i].profile)},
                                  {QStringLiteral("columns"), columnsMark(i)}});
    const QJsonObject document{{QStringLiteral("schema"), QStringLiteral("odograph.trial")},
                               {QStringLiteral("version"), schemaVersion},
                               {QStringLiteral("trial"), trialObject(trial)},
                               {QStringLiteral("views"), views},
                               {QStringLiteral("verdict"), verdictJson(verdict)},
                               {QStringLiteral("robots"), robots}};
    return QJsonDocument(document).toJson(QJsonDocument::Indented);
}

} // namespace

Result<void> writeTrialJson(const TrialRecord &trial, const std::vector<RecordingRecord> &recordings,
                            std::span<const AnalysisRecord> analyses,
                            const std::vector<ImportedTrack> &imported, const TrialVerdict &verdict,
                            const TextSink &sink)
{
    const std::string document = withoutColumns(trial, recordings, analyses, imported, verdict).toStdString();
    TextPieces text(sink);
    std::size_t from = 0;
    for (std::size_t i = 0; i < analyses.size(); ++i) {
        const std::string mark = "\"\\u0001columns " + std::to_string(i) + '"';
        const std::size_t at = document.find(mark, from);
        text.add(std::string_view(document).substr(from, at - from));
        addColumns(text, analyses[i].profile);
        from = at + mark.size();
    }
    text.add(std::string_view(document).substr(from));
    return text.finish();
}

std::string trialJson(const TrialRecord &trial, const std::vector<RecordingRecord> &recordings,
                      const std::vector<AnalysisRecord> &analyses, const std::vector<ImportedTrack> &imported,
                      const TrialVerdict &verdict)
{
    return wholeText([&](const TextSink &sink) {
        return writeTrialJson(trial, recordings, analyses, imported, verdict, sink);
    });
}

QJsonValue verdictJson(const TrialVerdict &verdict)
{
    if (verdict.checks.empty())
        return {};
    QJsonArray checks;
    for (const TrialCheck &check : verdict.checks)
        checks.append(QJsonObject{{QStringLiteral("code"), qtText(check.code)},
                                  {QStringLiteral("level"), qtText(wordOf(check.level))},
                                  {QStringLiteral("text"), qtText(check.text.english())},
                                  {QStringLiteral("arguments"), toJson(check.text)}});
    return QJsonObject{{QStringLiteral("level"), qtText(wordOf(verdict.level()))},
                       {QStringLiteral("accepted"), verdict.isAccepted()},
                       {QStringLiteral("accepted_reason"),
                        verdict.isAccepted() ? QJsonValue(qtText(verdict.acceptance->reason)) : QJsonValue()},
                       {QStringLiteral("checks"), checks}};
}

} // namespace odo
