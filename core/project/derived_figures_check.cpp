// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/derived_figures_check.h"

#include "core/geometry/floor_view.h"
#include "core/project/connection.h"
#include "core/project/repositories.h"
#include "core/project/series_blobs.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace odo {

namespace {

const std::string restoreFigures = "restore the project from a backup copy";

bool isOther(double a, double b)
{
    constexpr double relative = 1e-6; // rounding leaves far less, and nobody notices so little
    return std::abs(a - b) > relative * std::max({std::abs(a), std::abs(b), 1e-3});
}

/// The last of packed frame times; nothing where they cannot be read, which other checks report.
std::optional<Nanoseconds> lastOf(const QByteArray &packedTimes)
{
    std::vector<Nanoseconds> times;
    if (!unpackTimes(packedTimes, "frame times", times) || times.empty())
        return std::nullopt;
    return times.back();
}

/// The last time of the newest imported tracks of a trial.
std::optional<Nanoseconds> endOfTracks(const ProjectConnection &connection, RecordId trial)
{
    Statement last(connection,
                   QStringLiteral("SELECT samples FROM imported_track_chunk AS chunk WHERE track_id IN "
                                  "(SELECT MAX(id) FROM imported_track WHERE trial_id=? GROUP BY robot_id) AND position="
                                  "(SELECT MAX(position) FROM imported_track_chunk WHERE track_id=chunk.track_id)"));
    std::optional<Nanoseconds> end;
    const auto read = last.bind(trial).eachRow([&end](const Statement &row) -> Result<void> {
        std::vector<Sample> samples;
        if (auto unpacked = unpackSamples(row.blob(0), "imported track", samples); !unpacked)
            return unpacked;
        if (!samples.empty())
            end = std::max(end.value_or(Nanoseconds(0)), samples.back().time);
        return {};
    });
    return read ? end : std::nullopt;
}

Result<void> checkTrials(const ProjectConnection &connection, std::vector<ProjectProblem> &problems)
{
    Statement trials(connection,
                     QStringLiteral("SELECT trial.id, trial.name, duration_s, first.id, trial.sync_method, sync_offset_s, sync_offset_sigma_s, sync_rate, "
                                    "second.id, second.sync_method, second.start_offset_s, second.start_offset_sigma_s, second.clock_rate, "
                                    "(SELECT times FROM frame_time_chunk WHERE recording_id=first.id ORDER BY position DESC LIMIT 1) FROM trial "
                                    "LEFT JOIN recording AS first ON first.trial_id=trial.id AND first.position=0 "
                                    "LEFT JOIN recording AS second ON second.trial_id=trial.id AND second.position=1 "
                                    "WHERE state='complete' ORDER BY trial.id"));
    return trials.eachRow([&](const Statement &row) -> Result<void> {
        const std::string where = "trial '" + row.name(1) + "'";
        const bool isRecorded = row.integer(3) != 0;
        const double durationS = row.real(2);
        const auto end = isRecorded ? lastOf(row.blob(13)) : endOfTracks(connection, row.integer(0));
        if (end && isOther(durationS, toSeconds(*end)))
            problems.push_back({"its duration is stored as " + formatNumber(durationS, 3) + " s, its " +
                                    (isRecorded ? "recordings last " : "imported tracks last ") + formatNumber(toSeconds(*end), 3) + " s",
                                where, restoreFigures});
        constexpr int method = 4, secondId = 8; // then offset, its standard deviation and rate of the trial and of its second view
        const bool hasSecond = row.integer(secondId) != 0;
        bool isSame = hasSecond ? row.text(method) == row.text(secondId + 1) : row.text(method).empty() || row.text(method) == "none";
        for (int figure = 1; figure <= 3; ++figure)
            isSame = isSame && !isOther(row.real(method + figure), hasSecond ? row.real(secondId + 1 + figure) : 0);
        if (!isSame)
            problems.push_back({hasSecond ? "its stored synchronisation is not that of its second view"
                                          : "a synchronisation is stored, but it has no second view",
                                where, restoreFigures});
        return {};
    });
}

double rmsOf(const std::vector<MarkerError> &markers, double MarkerError::*error)
{
    double squares = 0;
    for (const MarkerError &marker : markers)
        squares += marker.*error * marker.*error;
    return std::sqrt(squares / static_cast<double>(markers.size()));
}

/// The errors of its markers by pose, lens and layout; empty where one cannot be computed.
std::vector<MarkerError> computedErrors(const RegistrationRecord &record, Intrinsics lens, const MarkerLayout &layout)
{
    const auto camera = CameraModel::create(std::move(lens));
    if (!camera)
        return {};
    const FloorView view(*camera, record.registration.worldFromCamera, record.registration.poseCovariance);
    std::vector<MarkerError> computed;
    for (const MarkerError &stored : record.registration.markers) {
        const auto place = std::ranges::find(layout.markers, stored.label, &Marker::label);
        const auto seen = std::ranges::find(record.pixels, stored.label, &MarkerPixel::label);
        if (place == layout.markers.end() || seen == record.pixels.end())
            return {};
        const auto floor = view.floorFromPixel(seen->pixel, 0);
        const auto back = view.pixelFromWorld({place->pointInWorld.x(), place->pointInWorld.y(), 0});
        if (!floor || !back)
            return {};
        computed.push_back({stored.label, (*floor - place->pointInWorld).norm(), (*back - seen->pixel).norm()});
    }
    return computed;
}

/// Either the RMS fits the errors, or the errors fit the markers. A joint registration leaves doubtful markers out of its RMS, and its
/// pixel errors refer to markers that it moved; after the axes were changed, an older registration no longer fits the layout.
bool fitsItsMarkers(const FloorRegistration &registration, const std::vector<MarkerError> &computed)
{
    const auto isComputed = [&](double MarkerError::*error) {
        return std::ranges::equal(registration.markers, computed,
                                  [error](const MarkerError &a, const MarkerError &b) { return !isOther(a.*error, b.*error); });
    };
    if (isOther(registration.rmsM, rmsOf(registration.markers, &MarkerError::errorM)))
        return isComputed(&MarkerError::errorM);
    return !isOther(registration.rmsPx, rmsOf(registration.markers, &MarkerError::errorPx)) || isComputed(&MarkerError::errorPx);
}

void checkRegistration(Project &project, const CameraRecord &camera, std::vector<ProjectProblem> &problems)
{
    const auto record = project.cameras().currentRegistration(camera.id);
    if (!record || !*record || (*record)->registration.markers.empty()) // one that cannot be read is reported elsewhere
        return;
    const auto layout = project.layouts().get((*record)->layout);
    const auto intrinsics = project.cameras().allIntrinsics(camera.id);
    if (!layout || !intrinsics)
        return;
    const auto used = std::ranges::find(*intrinsics, (*record)->intrinsics, &IntrinsicsRecord::id);
    const Intrinsics &lens = used != intrinsics->end() ? used->calibration.intrinsics : (*record)->assumedIntrinsics;
    if (!fitsItsMarkers((*record)->registration, computedErrors(**record, lens, layout->layout)))
        problems.push_back({"the marker errors of registration " + std::to_string((*record)->id) + " are not those that its markers give",
                            "camera '" + camera.name + "'", restoreFigures + ", or register the camera again"});
}

/// That what is in force of a camera is its own. one: "calibration" or "registration", of that table of revisions.
Result<void> checkChoices(const ProjectConnection &connection, const char *table, const std::string &one, std::vector<ProjectProblem> &problems)
{
    Statement choices(connection, QStringLiteral("SELECT camera.name, chosen.id, owner.name FROM camera JOIN %1 AS chosen ON chosen.id=camera.%1_id "
                                                 "JOIN camera AS owner ON owner.id=chosen.camera_id WHERE owner.id<>camera.id")
                                      .arg(QLatin1String(table)));
    return choices.eachRow([&](const Statement &row) -> Result<void> {
        problems.push_back({one + " " + std::to_string(row.integer(1)) + " was chosen for it, which is camera '" + row.name(2) + "'s; its newest own one is used",
                            "camera '" + row.name(0) + "'", "choose one of its own (odograph revisions P.odo CAMERA --use), or restore the project from a backup copy"});
        return {};
    });
}

} // namespace

Result<void> checkDerivedFigures(Project &project, const ProjectConnection &connection, std::vector<ProjectProblem> &problems)
{
    if (auto checked = checkTrials(connection, problems); !checked)
        return checked;
    if (auto checked = checkChoices(connection, "intrinsics", "calibration", problems); !checked)
        return checked;
    if (auto checked = checkChoices(connection, "registration", "registration", problems); !checked)
        return checked;
    const auto cameras = project.cameras().all();
    if (!cameras)
        return tl::unexpected(cameras.error());
    for (const CameraRecord &camera : *cameras)
        checkRegistration(project, camera, problems);
    return {};
}

} // namespace odo
