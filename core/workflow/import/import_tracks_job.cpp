// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/import_tracks_job.h"

#include "core/analysis/profile.h"
#include "core/base/error.h"
#include "core/base/file_system.h"
#include "core/exchange/file_name.h"
#include "core/files/protected_files.h"
#include "core/project/names.h"
#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "core/trajectory/imported_track.h"
#include "core/workflow/import/teams.h"
#include "core/workflow/import/track_of_robot.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/stored_verdicts.h"
#include "core/workflow/track/track_warnings.h"
#include "core/workflow/track/view_tracking.h"
#include "core/workflow/trials/trial_changes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

namespace odo {

namespace {

constexpr auto mostBlankAtStart = std::chrono::hours(1);
/// Okabe and Ito 2008: for robots without a given colour.
constexpr std::array<RgbColour, 6> freshColours{{{0x00, 0x72, 0xB2},
                                                 {0xD5, 0x5E, 0x00},
                                                 {0x00, 0x9E, 0x73},
                                                 {0xCC, 0x79, 0xA7},
                                                 {0xE6, 0x9F, 0x00},
                                                 {0x56, 0xB4, 0xE9}}};

/// The first colour that no robot has yet, or the first of all.
RgbColour freshColour(const std::vector<RobotRecord> &robots)
{
    for (const RgbColour colour : freshColours) {
        if (std::ranges::find(robots, colour, &RobotRecord::colour) == robots.end())
            return colour;
    }
    return freshColours.front();
}

/// Whether every position has a σ above zero.
bool statesErrors(const std::vector<ImportedPosition> &track)
{
    return std::ranges::all_of(track, [](const ImportedPosition &one) {
        return !one.position || (one.sigmaM && one.sigmaM->minCoeff() > 0);
    });
}

} // namespace

ImportTracksJob::ImportTracksJob(ImportTracksSettings settings) : m_settings(std::move(settings)) {}

Result<void> ImportTracksJob::checkTracks() const
{
    const Message what = importSubject(m_settings.trial);
    if (m_settings.tracks.empty())
        return fail(ErrorCode::InvalidInput, what, ODO_TEXT("workflow.no_track_given", "no track was given"),
                    ODO_TEXT("workflow.give_tracks", "give one or more, like --track R=run.csv"));
    std::set<std::string> names;
    for (const auto &[robot, file] : m_settings.tracks) {
        if (!names.insert(robot).second)
            return fail(ErrorCode::InvalidInput, what,
                        ODO_TEXT("workflow.robot_given_two_tracks",
                                 "robot '%1' was given two tracks")(Named::robot(robot)),
                        ODO_TEXT("workflow.give_each_robot_one", "give each robot one"));
        ODO_TRY(checkMayBeRead(file, quotedName(Named::file(file))));
    }
    return {};
}

Result<void> ImportTracksJob::prepare(Project &project)
{
    ODO_TRY(checkTracks());
    if (project.trials().find(m_settings.trial))
        return trialIsThere(importSubject(m_settings.trial));
    m_trial.name = m_settings.trial;
    m_trial.task = m_settings.task;
    m_trial.syncMethod = "none";
    ODO_TRY(readTask(project));
    return readRobots(project);
}

Result<void> ImportTracksJob::readTask(Project &project)
{
    if (m_settings.task.empty())
        return {};
    m_task = ODO_TRY(project.tasks().find(m_settings.task));
    return {};
}

Result<void> ImportTracksJob::readRobots(Project &project)
{
    auto robots = ODO_TRY(project.robots().all());
    for (const auto &track : m_settings.tracks) {
        const auto known = std::ranges::find(robots, track.first, &RobotRecord::name);
        if (known != robots.end()) {
            m_imported.push_back({*known, {}, {}});
            continue;
        }
        RobotRecord fresh;
        fresh.name = track.first;
        fresh.colour = freshColour(robots);
        m_warnings.push_back(
            joined({ODO_TEXT("workflow.robot_is_new", "robot '%1' is new")(Named::robot(fresh.name)),
                    ODO_TEXT("workflow.added_with_colour",
                             "it was added with the colour %1")(fresh.colour->toString())},
                   Join::Colon));
        robots.push_back(fresh);
        m_imported.push_back({std::move(fresh), {}, {}});
    }
    return {};
}

Result<void> ImportTracksJob::run(const JobControl &control)
{
    m_control = control;
    ODO_TRY(readFiles(control));
    setClock();
    for (std::size_t robot = 0; robot < m_imported.size(); ++robot) {
        control.report(
            0.5 + 0.5 * double(robot) / double(m_imported.size()),
            ODO_TEXT("workflow.analysing_robot", "analysing %1")(Named::robot(m_imported[robot].robot.name)));
        ODO_TRY(analyse(robot));
    }
    return {};
}

Result<void> ImportTracksJob::readFiles(const JobControl &control)
{
    for (std::size_t i = 0; i < m_settings.tracks.size(); ++i) {
        const auto &[robot, path] = m_settings.tracks[i];
        const bool isPiped = !m_settings.standardInput.empty() && path == m_settings.standardInput;
        TrackReading how = m_settings.reading;
        if (isPiped)
            how.shownAs = "standard input";
        auto file = ODO_TRY(readTrackFile(path, how, control));
        ImportedTrack &source = m_imported[i].source;
        source.format = trackFormatWord(file.format);
        auto track = ODO_TRY(trackOfRobot(std::move(file), robot, path));
        const auto hash = ODO_TRY(fileSha256(path, control));
        const std::string name = isPiped ? "standard input" : path.filename().string();
        // files may be called as nothing else may
        source.file = checkName(RecordKind::Track, name) ? name : fileNameOf(name);
        source.sha256 = hash;
        std::error_code problem; // the file was just read; 0 where it went since
        const auto bytes = files::sizeOf(path, problem);
        source.bytes = problem ? 0 : static_cast<std::int64_t>(bytes);
        for (const Message &notice : track.notices)
            m_warnings.push_back(joined({quotedName(Named::file(name)), notice}, Join::Colon));
        m_read.push_back(std::move(track));
    }
    return {};
}

/// One clock for all robots of the trial.
void ImportTracksJob::setClock()
{
    Nanoseconds first = Nanoseconds::max();
    for (const FileTrack &read : m_read)
        first = std::min(first, read.positions.front().time);
    m_zero = first >= Nanoseconds(0) && first < mostBlankAtStart ? Nanoseconds(0) : first;
    for (FileTrack &read : m_read) {
        for (ImportedPosition &position : read.positions) {
            position.time -= m_zero;
            if (m_read.size() > 1)
                m_times.push_back(position.time);
        }
        m_trial.durationS = std::max(m_trial.durationS, toSeconds(read.positions.back().time));
    }
    std::ranges::sort(m_times);
    m_times.erase(std::unique(m_times.begin(), m_times.end()), m_times.end());
}

/// The raw measurement, and how it was read.
void ImportTracksJob::makeSamples(std::size_t robot)
{
    FileTrack &read = m_read[robot];
    ImportedTrack &source = m_imported[robot].source;
    const bool isStated = statesErrors(read.positions);
    if (!isStated) {
        for (ImportedPosition &position : read.positions)
            position.sigmaM.reset(); // some may be stated, and some not
    }
    m_series.emplace_back(read.positions, isStated ? 0 : estimateImportedNoiseM(read.positions, m_control));
    read.positions = {};
    NoiseLevel level;
    for (std::size_t i = 0; i < m_series.back().size(); ++i)
        level.add({m_series.back().sample(i)});
    // Rounding that exceeds the scatter is no noise: it is the same from frame to frame.
    const double roundingM = read.roundedM / std::sqrt(12.0);
    const bool isRounded = !isStated && !m_settings.sigmaM && roundingM > level.sigmaM();
    m_roundingM.push_back(isRounded ? roundingM : 0);
    source.noiseM = level.sigmaM();
    const MessageArgument noise =
        quantity(toMillimetres(std::hypot(source.noiseM, m_roundingM.back())), 2, "mm");
    std::vector<Message> reading{
        isStated ? ODO_TEXT("workflow.error_stated", "positions to %1, as stated in the file")(noise)
                 : ODO_TEXT("workflow.error_estimated", "positions to %1, estimated from the track")(noise)};
    if (isRounded)
        reading.push_back(ODO_TEXT("workflow.positions_rounded",
                                   "rounded to %1")(quantity(toMillimetres(read.roundedM), 2, "mm")));
    if (m_settings.sigmaM)
        reading.push_back(ODO_TEXT("workflow.accuracy_given", "accurate to %1, as given")(
            quantity(toMillimetres(*m_settings.sigmaM), 2, "mm")));
    else if (!isStated)
        reading.push_back(
            ODO_TEXT("workflow.slow_errors_not_seen", "errors that change slowly are not included"));
    if (!read.name.empty())
        reading.push_back(ODO_TEXT("workflow.track_of_file", "the file's track '%1'")(read.name));
    if (m_zero != Nanoseconds(0))
        reading.push_back(ODO_TEXT("workflow.times_count_from",
                                   "its times start at %1")(quantity(toSeconds(m_zero), 3, "s")));
    std::ranges::move(read.facts, std::back_inserter(reading));
    std::ranges::move(read.notices, std::back_inserter(reading));
    source.reading = joined(std::move(reading), Join::Semicolon);
}

/// As they were read, or with the flags of their analysis; they end when the job is cancelled.
SampleSource ImportTracksJob::samplesOf(std::size_t robot, std::span<const SampleFlags> flags) const
{
    const auto chunk = [this, robot, flags](std::size_t first,
                                            std::size_t count) -> Result<std::vector<Sample>> {
        if (m_control.isCancelled())
            return cancelled(importSubject(m_settings.trial));
        std::vector<Sample> samples;
        samples.reserve(count);
        for (std::size_t i = first; i < first + count; ++i) {
            Sample &sample = samples.emplace_back(m_series[robot].sample(i));
            const double commonM = m_settings.sigmaM.value_or(m_roundingM[robot]);
            if (commonM > 0 && sample.position)
                sample.commonCovariance = Eigen::Matrix2d::Identity() * commonM * commonM;
            if (!m_times.empty())
                sample.frame = std::ranges::lower_bound(m_times, sample.time) - m_times.begin();
            if (!flags.empty())
                sample.flags = flags[i];
        }
        return samples;
    };
    return {m_series[robot].size(), chunk};
}

Result<void> ImportTracksJob::analyse(std::size_t robot)
{
    makeSamples(robot);
    auto &[record, source, analysis] = m_imported[robot];
    const SampleSource raw = samplesOf(robot);
    const auto options = ODO_TRY(optionsForImported({}, raw));
    const double share = 0.5 / double(m_imported.size()), from = 0.5 + share * double(robot);
    const JobControl part = partOf(m_control, from, from + share);
    auto analysed = analyseByTask([&](const AnalysisOptions &by) { return analyseImported(raw, by, part); },
                                  options, m_task);
    if (m_control.isCancelled())
        return cancelled(importSubject(m_settings.trial));
    if (!analysed) {
        Error error = analysed.error();
        error.what = robotInTrialSubject(record.name, m_settings.trial);
        return tl::unexpected(error);
    }
    if (!analysed->caveat.isEmpty())
        m_warnings.push_back(
            joined({robotInTrialSubject(record.name, m_settings.trial), analysed->caveat}, Join::Colon));
    analysis = newAnalysis(m_trial, record, {}, std::move(analysed->options));
    analysis.task = m_task ? m_task->id : 0;
    analysis.profile = std::move(analysed->profile);
    for (Message &warning : analysisWarnings(analysis, m_settings.trial))
        m_warnings.push_back(std::move(warning));
    return {};
}

Result<void> ImportTracksJob::commit(Project &project)
{
    return addTrial(project, importChange(m_settings.trial), [&]() -> Result<RecordId> {
        ODO_TRY(store(project));
        return m_trial.id;
    });
}

Result<void> ImportTracksJob::store(Project &project)
{
    if (!m_settings.team.empty()) {
        const auto team = ODO_TRY(findOrAddTeam(project, m_settings.team));
        m_trial.team = team.id;
    }
    for (Imported &one : m_imported) {
        if (one.robot.id == 0) {
            one.robot = ODO_TRY(project.robots().add(one.robot));
        }
        m_trial.robots.push_back(one.robot.id);
    }
    m_trial.date = m_settings.date.value_or(instantNow());
    m_trial = ODO_TRY(project.trials().add(m_trial, {}));
    std::vector<AnalysisRecord> made;
    for (std::size_t robot = 0; robot < m_imported.size(); ++robot) {
        Imported &one = m_imported[robot];
        one.source.trial = one.analysis.trial = m_trial.id;
        one.source.robot = one.analysis.robot = one.robot.id;
        one.source.imported = instantNow();
        ODO_TRY(project.trials().addImportedTrack(one.source, samplesOf(robot)));
        const std::vector<SampleFlags> flags = one.analysis.profile.flags;
        made.push_back(ODO_TRY(project.analyses().add(std::move(one.analysis), samplesOf(robot, flags))));
    }
    const auto stored = storeVerdict(project, m_trial, made);
    for (std::size_t robot = 0; robot < made.size(); ++robot)
        m_imported[robot].analysis = std::move(made[robot]);
    return stored.map([](const TrialVerdict &) {});
}

} // namespace odo
