// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/revisions.h"

#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"

#include <algorithm>
#include <map>
#include <optional>
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
    const auto layout = ODO_TRY(project.layouts().get(record.layout));
    Revision revision;
    revision.kind = Revision::Kind::Registration;
    revision.id = record.id;
    revision.made = record.made;
    revision.softwareVersion = record.softwareVersion;
    const MessageArgument name = Named::layout(layout.layout.name);
    revision.origin =
        record.intrinsics == 0
            ? ODO_TEXT("workflow.by_layout_without_lens", "layout '%1', lens not calibrated")(name)
            : ODO_TEXT("workflow.by_layout_and_lens",
                       "layout '%1', lens of calibration %2")(name, record.intrinsics);
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
    const auto found = ODO_TRY(project.cameras().find(camera));
    const auto intrinsics = ODO_TRY(project.cameras().allIntrinsics(found.id));
    const auto registrations = ODO_TRY(project.cameras().allRegistrations(found.id));
    const auto currentIntrinsics = ODO_TRY(project.cameras().currentIntrinsics(found.id));
    const auto currentRegistration = ODO_TRY(project.cameras().currentRegistration(found.id));
    const auto trials = ODO_TRY(project.analyses().trialsByRegistration());

    TrialsById byIntrinsics;
    std::vector<Revision> made;
    for (const RegistrationRecord &record : registrations) {
        auto revision = ODO_TRY(revisionOf(project, record));
        revision.isCurrent = currentRegistration->id == record.id;
        if (const auto its = trials.find(record.id); its != trials.end())
            revision.trials = its->second;
        for (const std::string &trial : revision.trials)
            addName(byIntrinsics[record.intrinsics], trial);
        made.push_back(std::move(revision));
    }
    std::vector<Revision> all;
    for (const IntrinsicsRecord &record : intrinsics) {
        all.push_back(revisionOf(project, record));
        all.back().isCurrent = currentIntrinsics->id == record.id;
        all.back().trials = byIntrinsics[record.id];
    }
    all.insert(all.end(), std::make_move_iterator(made.begin()), std::make_move_iterator(made.end()));
    return all;
}

Result<void> chooseRevision(Project &project, const std::string &camera, Revision::Kind kind, RecordId id)
{
    const auto revisions = ODO_TRY(revisionsOf(project, camera));
    const bool isThere = std::ranges::any_of(
        revisions, [&](const Revision &each) { return each.kind == kind && each.id == id; });
    const bool isCalibration = kind == Revision::Kind::Calibration;
    if (!isThere)
        return fail(ErrorCode::NotFound,
                    isCalibration ? ODO_TEXT("workflow.calibration", "calibration %1")(id)
                                  : ODO_TEXT("workflow.registration", "registration %1")(id),
                    ODO_TEXT("workflow.none_of_that_number",
                             "camera '%1' has none of that number")(Named::camera(camera)),
                    ODO_TEXT("workflow.see_revisions", "see its revisions for those there are"));
    return project.change(isCalibration
                              ? ODO_TEXT("workflow.choose_calibration",
                                         "choose calibration %1 of camera %2")(id, Named::camera(camera))
                              : ODO_TEXT("workflow.choose_registration",
                                         "choose registration %1 of camera %2")(id, Named::camera(camera)),
                          [&] {
                              return isCalibration ? project.cameras().chooseIntrinsics(id)
                                                   : project.cameras().chooseRegistration(id);
                          });
}

Result<std::vector<std::string>> outdatedTrials(Project &project)
{
    const auto cameras = ODO_TRY(project.cameras().all());
    std::set<RecordId> inForce;
    for (const CameraRecord &camera : cameras) {
        const auto registration = ODO_TRY(project.cameras().currentRegistration(camera.id));
        if (registration)
            inForce.insert(registration->id);
    }
    const auto trials = ODO_TRY(project.analyses().trialsByRegistration());
    std::set<std::string> outdated;
    for (const auto &[registration, names] : trials) {
        if (!inForce.contains(registration))
            outdated.insert(names.begin(), names.end());
    }
    return std::vector<std::string>(outdated.begin(), outdated.end());
}

namespace {

/// The days, of what is older than that.
std::optional<std::int64_t> daysOfOld(Instant made, Instant now, std::chrono::days oldAfter)
{
    const auto age = std::chrono::floor<std::chrono::days>(now - made);
    return age > oldAfter ? std::optional<std::int64_t>(age.count()) : std::nullopt;
}

} // namespace

Result<std::vector<Message>> calibrationWarnings(Project &project, const CameraRecord &camera, Instant now,
                                                 std::chrono::days oldAfter)
{
    const auto intrinsics = ODO_TRY(project.cameras().currentIntrinsics(camera.id));
    const auto registration = ODO_TRY(project.cameras().currentRegistration(camera.id));
    const auto recording = ODO_TRY(project.trials().newestRecording(camera.id));
    std::vector<Message> warnings;
    const auto warn = [&warnings](Message what, Message advice) {
        warnings.push_back(joined({std::move(what), std::move(advice)}, Join::Colon));
    };
    const MessageArgument name = Named::camera(camera.name);
    if (!intrinsics) {
        warn(ODO_TEXT("workflow.lens_never_calibrated",
                      "The lens of camera '%1' was never calibrated, its distortion is taken as none")(name),
             ODO_TEXT("workflow.calibrate_it", "calibrate it."));
    } else {
        if (const auto days = daysOfOld(intrinsics->made, now, oldAfter))
            warn(ODO_TEXT("workflow.old_calibration",
                          "The lens calibration of camera '%1' is %2 days old")(name, *days),
                 ODO_TEXT("workflow.calibrate_if_touched",
                          "if zoom, focus or the camera's settings were touched since, calibrate it again."));
        const Intrinsics &lens = intrinsics->calibration.intrinsics;
        if (recording && (recording->widthPx != lens.widthPx || recording->heightPx != lens.heightPx))
            warn(ODO_TEXT("workflow.recorded_at_another_size",
                          "The newest recording of camera '%1' is %2, its lens was calibrated at %3")(
                     name, sizeText(recording->widthPx, recording->heightPx),
                     sizeText(lens.widthPx, lens.heightPx)),
                 ODO_TEXT("workflow.calibrate_at_its_size", "calibrate it at the size it records."));
    }
    if (!registration)
        return warnings;
    if (const auto days = daysOfOld(registration->made, now, oldAfter))
        warn(ODO_TEXT("workflow.old_registration",
                      "The floor registration of camera '%1' is %2 days old")(name, *days),
             ODO_TEXT("workflow.check_or_register_again",
                      "check that the camera has not moved, or register it again."));
    if (intrinsics && registration->intrinsics != intrinsics->id)
        warn(registration->intrinsics == 0
                 ? ODO_TEXT("workflow.registered_before_calibration",
                            "The floor registration of camera '%1' was made before its lens was calibrated")(
                       name)
                 : ODO_TEXT("workflow.registered_with_other_lens",
                            "The floor registration of camera '%1' was made with another calibration of its "
                            "lens than the one in force")(name),
             ODO_TEXT("workflow.register_it_again", "register it again."));
    return warnings;
}

} // namespace odo
