// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record_job.h"

#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/workflow/cameras.h"
#include "core/workflow/media_copy.h"
#include "core/workflow/registered_view.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>
#include <thread>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr auto lookEach = 50ms, longestStart = 10000ms;
constexpr double longestS = 24 * 3600;

std::string whatOf(const RecordSettings &settings)
{
    return "recording of trial '" + settings.trial + "'";
}

} // namespace

RecordJob::RecordJob(RecordSettings settings) : m_settings(std::move(settings)) {}

RecordJob::~RecordJob()
{
    if (!m_committed)
        removeFiles();
}

Result<void> RecordJob::checkSettings(Project &project)
{
    const std::string what = whatOf(m_settings);
    if (m_settings.cameras.empty())
        return fail(ErrorCode::InvalidInput, what, "no camera was given", "give one or more, like --camera A=sim:A");
    if (!(m_settings.seconds > 0 && m_settings.seconds <= longestS))
        return fail(ErrorCode::InvalidInput, what, "it would take no time, or more than a day", "give the seconds, like 10");
    if (project.trials().find(m_settings.trial))
        return fail(ErrorCode::AlreadyExists, what, "the project has a trial of that name", "choose another name");
    std::set<std::string> names, addresses;
    for (const auto &[camera, address] : m_settings.cameras) {
        if (!names.insert(camera).second || !addresses.insert(address).second)
            return fail(ErrorCode::InvalidInput, what, "camera '" + camera + "' or its address '" + address + "' was given twice",
                        "give each view its own camera");
    }
    return {};
}

Result<void> RecordJob::prepare(Project &project)
{
    if (auto checked = checkSettings(project); !checked)
        return checked;
    m_trial.name = m_settings.trial;
    for (const std::string &name : m_settings.robots) {
        const auto robot = project.robots().find(name);
        if (!robot)
            return tl::unexpected(robot.error());
        m_robots.push_back(robot->id);
    }
    m_mediaFolder = project.mediaFolder();
    return {};
}

Result<std::vector<std::unique_ptr<CameraSource>>> RecordJob::openCameras()
{
    std::error_code problem;
    std::filesystem::create_directories(m_mediaFolder, problem);
    if (problem)
        return fail(ErrorCode::Io, whatOf(m_settings), problem.message(), "check the free space and the rights of the project's folder");
    std::vector<std::unique_ptr<CameraSource>> cameras;
    for (const auto &[name, address] : m_settings.cameras) {
        auto source = openCamera(address);
        if (!source)
            return tl::unexpected(source.error());
        m_files.push_back(freeMediaPath(m_mediaFolder, m_settings.trial + "_" + name, ".mkv"));
        cameras.push_back(std::move(*source));
    }
    return cameras;
}

Result<void> RecordJob::run(const JobControl &control)
{
    auto cameras = openCameras();
    if (!cameras)
        return tl::unexpected(cameras.error());
    CaptureSession session(std::move(*cameras), {.preRoll = Nanoseconds(0)});
    if (auto delivering = waitForPictures(session, control); !delivering)
        return delivering;
    session.startRecording(m_files);
    waitWhileRecording(session, control);
    m_outcome = session.stopRecording();
    if (control.isCancelled())
        return cancelled(whatOf(m_settings));
    for (std::size_t i = 0; i < m_outcome.views.size(); ++i) {
        if (auto kept = keep(m_outcome.views[i], i, control); !kept)
            return kept;
    }
    return {};
}

/// The time counts from when all cameras deliver, which may take them a moment.
Result<void> RecordJob::waitForPictures(const CaptureSession &session, const JobControl &control)
{
    const auto until = std::chrono::steady_clock::now() + longestStart;
    for (;;) {
        const std::vector<ViewHealth> views = session.health().views;
        const auto silent = std::ranges::find(views, 0u, &ViewHealth::delivered);
        if (silent == views.end())
            return {};
        if (control.isCancelled())
            return cancelled(whatOf(m_settings));
        if (silent->state == ViewHealth::State::Ended || std::chrono::steady_clock::now() > until)
            return noPicture(silent - views.begin(), silent->trouble ? silent->trouble->error.why : "");
        std::this_thread::sleep_for(lookEach);
    }
}

void RecordJob::waitWhileRecording(const CaptureSession &session, const JobControl &control)
{
    const auto begun = std::chrono::steady_clock::now();
    const auto hasEnded = [](const ViewHealth &view) { return view.state == ViewHealth::State::Ended; };
    double passedS = 0;
    while (passedS < m_settings.seconds && !control.isCancelled()) {
        std::this_thread::sleep_for(lookEach);
        passedS = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        control.report(std::min(1.0, passedS / m_settings.seconds), "recording");
        const CaptureHealth health = session.health();
        if (health.disk.trouble || std::ranges::any_of(health.views, hasEnded))
            return;
    }
}

tl::unexpected<Error> RecordJob::noPicture(std::ptrdiff_t view, const std::string &why) const
{
    return fail(ErrorCode::Io, whatOf(m_settings),
                "camera '" + m_settings.cameras[static_cast<std::size_t>(view)].first + "' gave no picture" + (why.empty() ? "" : ": " + why),
                "check that it is connected and not used by another program");
}

void RecordJob::warnOf(const ViewRecording &view, const std::string &camera)
{
    const std::string who = "view '" + camera + "': ";
    if (view.problem)
        m_warnings.push_back(who + "it ended early, because " + view.problem->message());
    for (const RecordingGap &gap : view.gaps) {
        char seconds[32];
        std::snprintf(seconds, sizeof seconds, "%.1f s", toSeconds(gap.length));
        m_warnings.push_back(who + "nothing came for " + seconds + ", because " + gap.why.message());
    }
    if (view.lostByUs > 0)
        m_warnings.push_back(who + std::to_string(view.lostByUs) + " pictures were lost because the disk was too slow; " +
                             "record to a faster disk, or fewer cameras at once");
    if (view.lostOnWire > 0)
        m_warnings.push_back(who + std::to_string(view.lostOnWire) + " pictures were lost between the camera and this program; " +
                             "check cable, bandwidth and what else this machine does");
}

Result<void> RecordJob::keep(const ViewRecording &view, std::size_t index, const JobControl &control)
{
    const std::string &camera = m_settings.cameras[index].first;
    if (view.taken.empty())
        return noPicture(static_cast<std::ptrdiff_t>(index), view.problem ? view.problem->why : "");
    warnOf(view, camera);
    RecordingRecord record;
    record.cameraName = camera;
    record.position = static_cast<int>(index);
    record.path = std::filesystem::absolute(view.file).string(); // stored relative to the project
    record.widthPx = view.format.width;
    record.heightPx = view.format.height;
    const Nanoseconds first = view.taken.front();
    for (const Nanoseconds taken : view.taken)
        record.frameTimes.push_back(taken - first);
    const double lengthS = toSeconds(record.frameTimes.back());
    record.framesPerSecond = lengthS > 0 ? static_cast<double>(view.taken.size() - 1) / lengthS : 0;
    if (index > 0) {
        const ViewRecording &reference = m_outcome.views.front();
        record.syncMethod = "clock";
        record.startOffsetS = toSeconds(first - reference.taken.front());
        record.startOffsetSigmaS = std::hypot(view.clockSigmaS, reference.clockSigmaS);
    }
    const auto hash = fileSha256(view.file, control);
    if (!hash)
        return tl::unexpected(hash.error());
    record.sha256 = *hash;
    std::error_code ignored; // the hash has just read it
    record.bytes = static_cast<std::int64_t>(std::filesystem::file_size(view.file, ignored));
    m_recordings.push_back(std::move(record));
    return {};
}

Result<void> RecordJob::commit(Project &project)
{
    const auto committed = project.inTransaction([&]() -> Result<void> {
        for (std::size_t i = 0; i < m_recordings.size(); ++i) {
            const auto camera = findOrAddCamera(project, m_recordings[i].cameraName);
            if (!camera)
                return tl::unexpected(camera.error());
            m_recordings[i].camera = camera->id;
        }
        m_trial.robots = m_robots;
        m_trial.durationS = toSeconds(m_recordings.front().frameTimes.back());
        m_trial.syncMethod = "none";
        if (m_recordings.size() > 1) {
            m_trial.syncMethod = m_recordings[1].syncMethod;
            m_trial.syncOffsetS = m_recordings[1].startOffsetS;
            m_trial.syncOffsetSigmaS = m_recordings[1].startOffsetSigmaS;
            m_trial.syncScore = 1;
        }
        m_trial.date = std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
        auto trial = project.trials().add(m_trial, m_recordings);
        if (!trial)
            return tl::unexpected(trial.error());
        m_trial = std::move(*trial);
        return {};
    });
    m_committed = committed.has_value();
    return committed;
}

void RecordJob::removeFiles()
{
    std::error_code ignored; // nothing more can be done for a file that cannot be removed
    for (const std::filesystem::path &file : m_files)
        std::filesystem::remove(file, ignored);
}

} // namespace odo
