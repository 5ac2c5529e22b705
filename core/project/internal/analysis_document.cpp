// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/series_blobs.h"
#include "core/project/internal/trial_document.h"
#include "core/project/internal/words.h"
#include "core/project/message_json.h"
#include "core/project/project.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <utility>

namespace odo {

namespace {

constexpr std::size_t mostMetrics = 1000, mostPassages = 100'000, mostOverrides = 1'000'000;
constexpr std::size_t mostChunks = maxBlobRows / rowsPerChunk + 1;

template <class Row, class Pack>
QCborArray chunksOf(const std::vector<Row> &rows, const Pack &pack)
{
    QCborArray chunks;
    const std::span<const Row> all(rows);
    for (std::size_t start = 0; start == 0 || start < all.size(); start += rowsPerChunk)
        chunks.append(pack(all.subspan(start, std::min(rowsPerChunk, all.size() - start))));
    return chunks;
}

QCborMap resultsOf(const Profile &profile)
{
    QCborArray metrics, spikes, passages;
    for (const Metric &metric : profile.metrics)
        metrics.append(QCborMap{{QStringLiteral("name"), documentText(metric.name)},
                                {QStringLiteral("unit"), documentText(metric.unit)},
                                {QStringLiteral("value"), metric.value},
                                {QStringLiteral("sigma"), documentOptional(metric.sigma)},
                                {QStringLiteral("at_least"), metric.isAtLeast}});
    for (const Spike &spike : profile.spikes)
        spikes.append(QCborMap{{QStringLiteral("sample"), qint64(spike.sampleIndex)},
                               {QStringLiteral("time_ns"), qint64(spike.time.count())},
                               {QStringLiteral("flags"), qint64(spike.flags)},
                               {QStringLiteral("reason"), documentText(storedMessage(spike.reason))}});
    for (const GatePassage &passage : profile.passages)
        passages.append(
            QCborMap{{QStringLiteral("gate"), documentText(passage.gate)},
                     {QStringLiteral("role"), documentText(storedWord(gateRoleWords, passage.role))},
                     {QStringLiteral("time_ns"), qint64(passage.time.count())},
                     {QStringLiteral("sigma_s"), passage.sigmaS},
                     {QStringLiteral("common_sigma_s"), passage.commonSigmaS}});
    return {{QStringLiteral("metrics"), metrics},
            {QStringLiteral("spikes"), spikes},
            {QStringLiteral("passages"), passages},
            {QStringLiteral("height_m"), profile.heightM},
            {QStringLiteral("height_estimated"), profile.heightEstimated},
            {QStringLiteral("view_disagreement_m"), profile.meanViewDisagreementM},
            {QStringLiteral("samples"),
             chunksOf(profile.samples, [](std::span<const Sample> rows) { return packSamples(rows); })},
            {QStringLiteral("points"),
             chunksOf(profile.points, [](std::span<const ProfilePoint> rows) { return packPoints(rows); })}};
}

QCborArray overridesDocument(const std::vector<ManualOverride> &overrides)
{
    QCborArray list;
    for (const ManualOverride &one : overrides)
        list.append(QCborMap{{QStringLiteral("frame"), qint64(one.frame)},
                             {QStringLiteral("is_spike"), one.isSpike}});
    return list;
}

std::vector<ManualOverride> overridesIn(const DocumentFields &fields)
{
    std::vector<ManualOverride> overrides;
    for (const DocumentFields &one : fields.parts("overrides", mostOverrides))
        overrides.push_back({one.integer("frame"), one.flag("is_spike")});
    return overrides;
}

QCborArray ambiguousDocument(const std::vector<AmbiguousName> &names)
{
    QCborArray list;
    for (const AmbiguousName &name : names)
        list.append(QCborMap{{QStringLiteral("from_ns"), qint64(name.from.count())},
                             {QStringLiteral("to_ns"), qint64(name.to.count())},
                             {QStringLiteral("others"), documentTexts(name.otherNames)}});
    return list;
}

QCborMap analysisDocument(const AnalysisRecord &analysis, const std::string &task,
                          const std::vector<ManualOverride> &inForce)
{
    const Profile whole = analysis.range ? wholeRun(analysis.profile, analysis.outside) : analysis.profile;
    QCborMap map = resultsOf(whole);
    const AnalysisOptions &options = analysis.options;
    map.insert(QStringLiteral("robot"), documentText(analysis.robotName));
    map.insert(QStringLiteral("made_ms"), qint64(analysis.made.time_since_epoch().count()));
    map.insert(QStringLiteral("software_version"), documentText(analysis.softwareVersion));
    map.insert(QStringLiteral("task"), documentText(task));
    map.insert(QStringLiteral("smoother"), documentText(storedWord(smootherWords, options.smoother)));
    map.insert(QStringLiteral("max_speed_m_s"), options.maxSpeedMps);
    map.insert(QStringLiteral("max_accel_m_s2"), options.maxAccelMps2);
    map.insert(QStringLiteral("bridged_gap_ns"), qint64(options.longestBridgedGap.count()));
    map.insert(QStringLiteral("overrides"), overridesDocument(options.overrides));
    map.insert(QStringLiteral("overrides_in_force"), overridesDocument(inForce));
    map.insert(QStringLiteral("views"), documentTexts(analysis.views));
    map.insert(QStringLiteral("range_from_ns"),
               analysis.range ? QCborValue(qint64(analysis.range->begin.count())) : QCborValue(nullptr));
    map.insert(QStringLiteral("range_to_ns"),
               analysis.range ? QCborValue(qint64(analysis.range->end.count())) : QCborValue(nullptr));
    map.insert(QStringLiteral("ambiguous"),
               ambiguousDocument(analysis.range ? analysis.allAmbiguousNames : analysis.ambiguousNames));
    return map;
}

void readResults(const DocumentFields &fields, Profile &into)
{
    for (const DocumentFields &metric : fields.parts("metrics", mostMetrics))
        into.metrics.push_back({metric.text("name"), metric.text("unit"), metric.real("value"),
                                metric.optionalReal("sigma"), metric.flag("at_least")});
    for (const DocumentFields &spike : fields.parts("spikes", maxBlobRows))
        into.spikes.push_back({spike.integer("sample"), Nanoseconds(spike.integer("time_ns")),
                               static_cast<SampleFlags>(spike.integer("flags")),
                               messageFromStored(spike.text("reason", maxTextLength))});
    for (const DocumentFields &passage : fields.parts("passages", mostPassages))
        into.passages.push_back({passage.text("gate"), wordIn<GateRole>(passage, "role", gateRoleWords),
                                 Nanoseconds(passage.integer("time_ns")), passage.real("sigma_s"),
                                 passage.real("common_sigma_s")});
    into.heightM = fields.real("height_m");
    into.heightEstimated = fields.flag("height_estimated");
    into.meanViewDisagreementM = fields.real("view_disagreement_m");
    for (const QByteArray &chunk : fields.blobs("samples", mostChunks)) {
        if (into.samples.size() > maxBlobRows || !unpackSamples(chunk, Message(), into.samples))
            return fields.refuse("samples");
    }
    for (const QByteArray &chunk : fields.blobs("points", mostChunks)) {
        if (into.points.size() > maxBlobRows || !unpackPoints(chunk, Message(), into.points))
            return fields.refuse("points");
    }
    if (into.samples.size() != into.points.size() || into.samples.size() > maxBlobRows)
        fields.refuse("points");
    const auto count = static_cast<std::int64_t>(into.samples.size());
    if (std::ranges::any_of(into.spikes, [count](const Spike &spike) {
            return spike.sampleIndex < 0 || spike.sampleIndex >= count;
        }))
        fields.refuse("spikes");
}

std::optional<TimeSpan> spanIn(const DocumentFields &fields)
{
    const auto from = fields.optionalInteger("range_from_ns"), to = fields.optionalInteger("range_to_ns");
    if (!from || !to)
        return std::nullopt;
    if (*from < 0 || *to < *from)
        fields.refuse("range_to_ns");
    return TimeSpan{Nanoseconds(*from), Nanoseconds(*to)};
}

Result<AnalysisRecord> analysisIn(Project &project, const DocumentFields &fields, RecordId trial,
                                  RecordId robot)
{
    AnalysisRecord analysis;
    analysis.trial = trial;
    analysis.robot = robot;
    analysis.robotName = fields.text("robot");
    analysis.made = Instant(std::chrono::milliseconds(fields.integer("made_ms")));
    analysis.softwareVersion = fields.text("software_version");
    analysis.options.smoother = wordIn<Smoother>(fields, "smoother", smootherWords);
    analysis.options.maxSpeedMps = fields.real("max_speed_m_s");
    analysis.options.maxAccelMps2 = fields.real("max_accel_m_s2");
    analysis.options.longestBridgedGap = Nanoseconds(fields.integer("bridged_gap_ns"));
    analysis.options.overrides = overridesIn(fields);
    analysis.views = fields.texts("views", mostViews);
    analysis.registrations.assign(analysis.views.size(), 0);
    if (const std::string task = fields.text("task"); !task.empty())
        analysis.task = ODO_TRY(project.tasks().find(task)).id;
    readResults(fields, analysis.profile);
    analysis.range = spanIn(fields);
    for (const DocumentFields &one : fields.parts("ambiguous", maxBlobRows)) {
        AmbiguousName name{Nanoseconds(one.integer("from_ns")), Nanoseconds(one.integer("to_ns")), {}, {}};
        for (const std::string &other : one.texts("others", mostRobots)) {
            if (const auto alike = project.robots().find(other))
                name.others.push_back(alike->id);
        }
        (analysis.range ? analysis.allAmbiguousNames : analysis.ambiguousNames).push_back(std::move(name));
    }
    if (analysis.range)
        analysis.outside = cutToRange(analysis.profile, *analysis.range);
    return analysis;
}

} // namespace

Result<QCborArray> analysesDocument(Project &project, RecordId trial)
{
    QCborArray list;
    const auto analyses = ODO_TRY(project.analyses().current(trial));
    for (const AnalysisRecord &analysis : analyses) {
        std::string task;
        if (analysis.task != 0)
            task = ODO_TRY(project.tasks().get(analysis.task)).name;
        const auto inForce = ODO_TRY(project.trials().overrides(trial, analysis.robot));
        list.append(analysisDocument(analysis, task, inForce));
    }
    return list;
}

Result<void> storeAnalyses(Project &project, const DocumentFields &trial, RecordId id)
{
    const auto known = ODO_TRY(analysesDocument(project, id));
    for (const DocumentFields &fields : trial.parts("analyses", mostRobots)) {
        if (known.contains(fields.map()))
            continue;
        const auto robot = ODO_TRY(project.robots().find(fields.text("robot")));
        std::vector<ManualOverride> inForce;
        for (const DocumentFields &one : fields.parts("overrides_in_force", mostOverrides))
            inForce.push_back({one.integer("frame"), one.flag("is_spike")});
        ODO_TRY(project.trials().setManualOverrides(id, robot.id, inForce));
        const auto analysis = ODO_TRY(analysisIn(project, fields, id, robot.id));
        if (fields.isSound())
            ODO_TRY(project.analyses().add(analysis));
    }
    return {};
}

QCborArray tracksDocument(Project &project, const TrialRecord &trial)
{
    QCborArray list;
    for (std::size_t i = 0; i < trial.robots.size(); ++i) {
        const auto track = project.trials().currentImportedTrack(trial.id, trial.robots[i]);
        if (!track || !*track)
            continue;
        const ImportedTrack &one = **track;
        list.append(QCborMap{
            {QStringLiteral("robot"), documentText(trial.robotNames[i])},
            {QStringLiteral("imported_ms"), qint64(one.imported.time_since_epoch().count())},
            {QStringLiteral("file"), documentText(one.file)},
            {QStringLiteral("sha256"), documentText(one.sha256)},
            {QStringLiteral("bytes"), qint64(one.bytes)},
            {QStringLiteral("format"), documentText(one.format)},
            {QStringLiteral("reading"), documentText(storedMessage(one.reading))},
            {QStringLiteral("samples"),
             chunksOf(one.samples, [](std::span<const Sample> rows) { return packSamples(rows); })}});
    }
    return list;
}

Result<void> storeTracks(Project &project, const DocumentFields &trial, RecordId id)
{
    for (const DocumentFields &fields : trial.parts("tracks", mostRobots)) {
        ImportedTrack track;
        track.trial = id;
        track.robot = ODO_TRY(project.robots().find(fields.text("robot"))).id;
        track.imported = Instant(std::chrono::milliseconds(fields.integer("imported_ms")));
        track.file = fields.text("file");
        track.sha256 = fields.text("sha256");
        track.bytes = fields.integer("bytes");
        track.format = fields.text("format");
        track.reading = messageFromStored(fields.text("reading", maxTextLength));
        for (const QByteArray &chunk : fields.blobs("samples", mostChunks)) {
            if (track.samples.size() > maxBlobRows || !unpackSamples(chunk, Message(), track.samples))
                fields.refuse("samples");
        }
        const auto known = ODO_TRY(project.trials().currentImportedTrack(id, track.robot, false));
        const bool isKnown = known && known->sha256 == track.sha256 && known->imported == track.imported;
        if (fields.isSound() && !isKnown)
            ODO_TRY(project.trials().addImportedTrack(track));
    }
    return {};
}

} // namespace odo
