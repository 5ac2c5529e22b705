// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/revisions.h"

#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <map>
#include <set>

namespace odo {

namespace {

using TrialsById = std::map<RecordId, std::vector<std::string>>;

void addName(std::vector<std::string> &names, const std::string &name)
{
    if (std::ranges::find(names, name) == names.end())
        names.push_back(name);
}

std::filesystem::path pictureOf(Project &project, const StoredPicture &picture)
{
    return picture.path.empty() ? std::filesystem::path() : absolutePath(project.file(), picture.path);
}

Revision revisionOf(Project &project, const IntrinsicsRecord &record)
{
    Revision revision;
    revision.kind = Revision::Kind::Calibration;
    revision.id = record.id;
    revision.made = record.made;
    revision.softwareVersion = record.softwareVersion;
    revision.origin = record.origin;
    revision.evidence = static_cast<int>(record.calibration.picturesUsed());
    revision.rmsPx = record.calibration.rmsPx;
    revision.verdict = record.calibration.verdict;
    const auto kept =
        std::ranges::find_if(record.files, [](const StoredPicture &file) { return !file.path.empty(); });
    if (kept != record.files.end())
        revision.picture = pictureOf(project, *kept);
    return revision;
}

Result<Revision> revisionOf(Project &project, const RegistrationRecord &record)
{
    const auto layout = project.layouts().get(record.layout);
    if (!layout)
        return tl::unexpected(layout.error());
    Revision revision;
    revision.kind = Revision::Kind::Registration;
    revision.id = record.id;
    revision.made = record.made;
    revision.softwareVersion = record.softwareVersion;
    revision.origin = "layout '" + layout->layout.name + "', ";
    revision.origin += record.intrinsics == 0 ? "lens not calibrated"
                                              : "lens of calibration " + std::to_string(record.intrinsics);
    revision.evidence = static_cast<int>(record.registration.markers.size());
    revision.rmsPx = record.registration.rmsPx;
    revision.verdict = record.registration.verdict;
    revision.picture = pictureOf(project, record.picture);
    revision.markers = record.pixels;
    return revision;
}

} // namespace

Result<std::vector<Revision>> revisionsOf(Project &project, const std::string &camera)
{
    const auto found = project.cameras().find(camera);
    if (!found)
        return tl::unexpected(found.error());
    const auto intrinsics = project.cameras().allIntrinsics(found->id);
    if (!intrinsics)
        return tl::unexpected(intrinsics.error());
    const auto registrations = project.cameras().allRegistrations(found->id);
    if (!registrations)
        return tl::unexpected(registrations.error());
    const auto currentIntrinsics = project.cameras().currentIntrinsics(found->id);
    if (!currentIntrinsics)
        return tl::unexpected(currentIntrinsics.error());
    const auto currentRegistration = project.cameras().currentRegistration(found->id);
    if (!currentRegistration)
        return tl::unexpected(currentRegistration.error());
    const auto trials = project.analyses().trialsByRegistration();
    if (!trials)
        return tl::unexpected(trials.error());

    TrialsById byIntrinsics;
    std::vector<Revision> made;
    for (const RegistrationRecord &record : *registrations) {
        auto revision = revisionOf(project, record);
        if (!revision)
            return tl::unexpected(revision.error());
        revision->isCurrent = (*currentRegistration)->id == record.id;
        if (const auto its = trials->find(record.id); its != trials->end())
            revision->trials = its->second;
        for (const std::string &trial : revision->trials)
            addName(byIntrinsics[record.intrinsics], trial);
        made.push_back(std::move(*revision));
    }
    std::vector<Revision> all;
    for (const IntrinsicsRecord &record : *intrinsics) {
        all.push_back(revisionOf(project, record));
        all.back().isCurrent = (*currentIntrinsics)->id == record.id;
        all.back().trials = byIntrinsics[record.id];
    }
    all.insert(all.end(), std::make_move_iterator(made.begin()), std::make_move_iterator(made.end()));
    return all;
}

Result<void> chooseRevision(Project &project, const std::string &camera, Revision::Kind kind, RecordId id)
{
    const auto revisions = revisionsOf(project, camera);
    if (!revisions)
        return tl::unexpected(revisions.error());
    const bool isThere = std::ranges::any_of(
        *revisions, [&](const Revision &each) { return each.kind == kind && each.id == id; });
    const bool isCalibration = kind == Revision::Kind::Calibration;
    if (!isThere)
        return fail(ErrorCode::NotFound,
                    std::string(isCalibration ? "calibration " : "registration ") + std::to_string(id),
                    "camera '" + camera + "' has none of that number",
                    "see its revisions for those there are");
    return project.change(std::string("choose ") + (isCalibration ? "calibration " : "registration ") +
                              std::to_string(id) + " of camera " + camera,
                          [&] {
                              return isCalibration ? project.cameras().chooseIntrinsics(id)
                                                   : project.cameras().chooseRegistration(id);
                          });
}

Result<std::vector<std::string>> outdatedTrials(Project &project)
{
    const auto cameras = project.cameras().all();
    if (!cameras)
        return tl::unexpected(cameras.error());
    std::set<RecordId> inForce;
    for (const CameraRecord &camera : *cameras) {
        const auto registration = project.cameras().currentRegistration(camera.id);
        if (!registration)
            return tl::unexpected(registration.error());
        if (*registration)
            inForce.insert((*registration)->id);
    }
    const auto trials = project.analyses().trialsByRegistration();
    if (!trials)
        return tl::unexpected(trials.error());
    std::set<std::string> outdated;
    for (const auto &[registration, names] : *trials) {
        if (!inForce.contains(registration))
            outdated.insert(names.begin(), names.end());
    }
    return std::vector<std::string>(outdated.begin(), outdated.end());
}

namespace {

std::string sizeText(int width, int height)
{
    return std::to_string(width) + "×" + std::to_string(height);
}

void warnOfAge(const std::string &what, Instant made, Instant now, std::chrono::days oldAfter,
               const char *advice, std::vector<std::string> &warnings)
{
    const auto age = std::chrono::floor<std::chrono::days>(now - made);
    if (age > oldAfter)
        warnings.push_back(what + " is " + std::to_string(age.count()) + " days old: " + advice + ".");
}

} // namespace

Result<std::vector<std::string>> calibrationWarnings(Project &project, const CameraRecord &camera,
                                                     Instant now, std::chrono::days oldAfter)
{
    const auto intrinsics = project.cameras().currentIntrinsics(camera.id);
    if (!intrinsics)
        return tl::unexpected(intrinsics.error());
    const auto registration = project.cameras().currentRegistration(camera.id);
    if (!registration)
        return tl::unexpected(registration.error());
    const auto recording = project.trials().newestRecording(camera.id);
    if (!recording)
        return tl::unexpected(recording.error());
    std::vector<std::string> warnings;
    const std::string name = "camera '" + camera.name + "'";
    if (!*intrinsics) {
        warnings.push_back("The lens of " + name +
                           " was never calibrated, its distortion is taken as none: calibrate it.");
    } else {
        warnOfAge("The lens calibration of " + name, (*intrinsics)->made, now, oldAfter,
                  "if zoom, focus or the camera's settings were touched since, calibrate it again", warnings);
        const Intrinsics &lens = (*intrinsics)->calibration.intrinsics;
        if (*recording && ((*recording)->widthPx != lens.widthPx || (*recording)->heightPx != lens.heightPx))
            warnings.push_back("The newest recording of " + name + " is " +
                               sizeText((*recording)->widthPx, (*recording)->heightPx) +
                               ", its lens was calibrated at " + sizeText(lens.widthPx, lens.heightPx) +
                               ": calibrate it at the size it records.");
    }
    if (!*registration)
        return warnings;
    warnOfAge("The floor registration of " + name, (*registration)->made, now, oldAfter,
              "check that the camera has not moved, or register it again", warnings);
    if (*intrinsics && (*registration)->intrinsics != (*intrinsics)->id)
        warnings.push_back("The floor registration of " + name + " was made " +
                           ((*registration)->intrinsics == 0
                                ? "before its lens was calibrated"
                                : "with another calibration of its lens than the one in force") +
                           ": register it again.");
    return warnings;
}

} // namespace odo
