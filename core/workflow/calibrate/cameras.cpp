// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/cameras.h"

#include "core/base/error.h"
#include "core/capture/camera_source.h"
#include "core/exchange/calibration_file.h"
#include "core/geometry/sensor_format.h"
#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/register_job.h"
#include "core/workflow/calibrate/result_axes.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace odo {

Result<CameraRecord> findOrAddCamera(Project &project, const std::string &name)
{
    auto found = project.cameras().find(name);
    if (found || found.error().code != ErrorCode::NotFound)
        return found;
    return project.cameras().add({0, name, ""});
}

Result<IntrinsicsRecord> importIntrinsics(Project &project, const std::string &camera,
                                          const std::filesystem::path &file, const std::string &entry)
{
    const auto held = ODO_TRY(camerasInCalibration(file));
    const bool isNamed = entry.empty() && std::ranges::find(held, camera) != held.end();
    auto intrinsics = ODO_TRY(readIntrinsics(file, isNamed ? camera : entry));
    IntrinsicsRecord record;
    record.made = instantNow();
    const MessageArgument name = Named::file(file.filename());
    record.origin = ODO_TEXT("workflow.lens_imported_from", "imported from %1")(name);
    record.calibration.intrinsics = std::move(intrinsics);
    const auto stored =
        project.change(ODO_TEXT("workflow.import_lens", "import the lens calibration of camera %1 from %2")(
                           Named::camera(camera), name),
                       [&]() -> Result<void> {
                           const auto found = ODO_TRY(findOrAddCamera(project, camera));
                           record.camera = found.id;
                           record = ODO_TRY(project.cameras().addIntrinsics(record));
                           return {};
                       });
    if (!stored)
        return tl::unexpected(stored.error());
    return record;
}

Result<void> exportIntrinsics(Project &project, const std::string &camera, const OutputTarget &target)
{
    const auto found = ODO_TRY(project.cameras().find(camera));
    const auto intrinsics = ODO_TRY(project.cameras().currentIntrinsics(found.id));
    if (!intrinsics)
        return fail(
            ErrorCode::NotFound,
            ODO_TEXT("workflow.intrinsics_of_camera", "intrinsics of camera '%1'")(Named::camera(camera)),
            ODO_TEXT("workflow.never_calibrated", "it was never calibrated"),
            ODO_TEXT("workflow.run_calibrate", "calibrate its lens, or import its intrinsics"));
    return writeIntrinsics(target, camera, intrinsics->calibration.intrinsics);
}

Result<RegistrationRecord> storeRegistration(Project &project, const std::string &camera,
                                             RegistrationRecord record)
{
    const auto owner = ODO_TRY(findOrAddCamera(project, camera));
    record.camera = owner.id;
    record.made = instantNow();
    record.softwareVersion = ODOGRAPH_VERSION;
    return project.cameras().addRegistration(record);
}

Result<RegistrationRecord> storeFromOldMarkers(Project &project, const std::string &camera,
                                               RegistrationRecord record,
                                               const std::optional<RegistrationCheck> &lastCheck)
{
    auto stored = storeRegistration(project, camera, std::move(record));
    if (!stored || !lastCheck)
        return stored;
    ODO_TRY(project.cameras().addCheck(stored->id, *lastCheck));
    return project.cameras().registration(stored->id);
}

Result<std::vector<RegisteredCamera>> camerasOnLayout(Project &project, RecordId layout)
{
    const auto cameras = ODO_TRY(project.cameras().all());
    std::vector<RegisteredCamera> registered;
    for (const CameraRecord &camera : cameras) {
        auto registration = ODO_TRY(project.cameras().currentRegistration(camera.id));
        if (registration && registration->layout == layout)
            registered.push_back({camera, std::move(*registration)});
    }
    return registered;
}

Result<RegisteredCamera> registeredCamera(Project &project, const std::string &camera)
{
    const auto found = ODO_TRY(project.cameras().find(camera));
    auto registration = ODO_TRY(project.cameras().currentRegistration(found.id));
    if (!registration)
        return fail(ErrorCode::NotFound, cameraSubject(camera), notRegisteredToFloor(), registerItFirst());
    return RegisteredCamera{found, std::move(*registration)};
}

namespace {

using TrialsById = std::map<RecordId, std::vector<std::string>>;

void addName(std::vector<std::string> &names, const std::string &name)
{
    if (std::ranges::find(names, name) == names.end())
        names.push_back(name);
}

Revision revisionOf(Project &project, const IntrinsicsRecord &record)
{
    Revision revision;
    revision.kind = Revision::Kind::Calibration;
    revision.id = record.id;
    revision.made = record.made;
    revision.softwareVersion = record.softwareVersion;
    revision.origin = record.origin;
    revision.evidence = static_cast<int>(record.calibration.imagesUsed());
    revision.rmsPx = record.calibration.rmsPx;
    revision.verdict = record.calibration.verdict;
    const auto kept =
        std::ranges::find_if(record.files, [](const StoredImage &file) { return !file.path.empty(); });
    if (kept != record.files.end())
        revision.image = imageFileOf(project, *kept);
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
            : ODO_TEXT("workflow.by_layout_and_lens", "layout '%1', lens calibration %2")(name,
                                                                                          record.intrinsics);
    revision.evidence = static_cast<int>(record.registration.markers.size());
    revision.rmsPx = record.registration.rmsPx;
    revision.verdict = record.registration.verdict;
    revision.image = imageFileOf(project, record.image);
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

namespace {

/// A registration in other axes than its layout has now would mix both on one floor.
Result<void> chooseInPresentAxes(Project &project, const std::string &camera, RecordId id)
{
    RegistrationRecord record = ODO_TRY(project.cameras().registration(id));
    const auto axes = ODO_TRY(presentAxesOf(project, record));
    if (!axes)
        return fail(ErrorCode::InvalidInput, ODO_TEXT("workflow.registration", "registration %1")(id),
                    ODO_TEXT("workflow.registration_in_older_axes",
                             "it has other axes: those of its layout were changed since"),
                    ODO_TEXT("workflow.register_camera_anew", "register the camera again"));
    if (axes->scale == 1 && axes->turnRad == 0 && axes->shiftM.isZero(0))
        return project.cameras().chooseRegistration(id);
    std::optional<RegistrationCheck> check = record.lastCheck;
    if (check)
        check->shiftM *= axes->scale;
    record.registration = transformed(record.registration, *axes);
    return withoutValue(storeFromOldMarkers(project, camera, std::move(record), check));
}

} // namespace

Result<void> chooseRevision(Project &project, const std::string &camera, Revision::Kind kind, RecordId id)
{
    const auto revisions = ODO_TRY(revisionsOf(project, camera));
    const bool isThere = std::ranges::any_of(
        revisions, [&](const Revision &each) { return each.kind == kind && each.id == id; });
    const bool isCalibration = kind == Revision::Kind::Calibration;
    if (!isThere)
        return fail(
            ErrorCode::NotFound,
            isCalibration ? ODO_TEXT("workflow.calibration", "calibration %1")(id)
                          : ODO_TEXT("workflow.registration", "registration %1")(id),
            ODO_TEXT("workflow.none_of_that_number", "camera '%1' has no such number")(Named::camera(camera)),
            ODO_TEXT("workflow.see_revisions", "see the list of its revisions"));
    return project.change(isCalibration
                              ? ODO_TEXT("workflow.choose_calibration",
                                         "choose calibration %1 of camera %2")(id, Named::camera(camera))
                              : ODO_TEXT("workflow.choose_registration",
                                         "choose registration %1 of camera %2")(id, Named::camera(camera)),
                          [&] {
                              return isCalibration ? project.cameras().chooseIntrinsics(id)
                                                   : chooseInPresentAxes(project, camera, id);
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
        if (!registration ||
            intrinsicsSourceOf(registration->assumedIntrinsics, false) == IntrinsicsSource::Assumed)
            warn(ODO_TEXT(
                     "workflow.lens_never_calibrated",
                     "The lens of camera '%1' is neither calibrated nor determined by the floor's markers")(
                     name),
                 ODO_TEXT("workflow.calibrate_it", "calibrate it."));
    } else {
        if (const auto days = daysOfOld(intrinsics->made, now, oldAfter))
            warn(ODO_TEXT("workflow.old_calibration",
                          "The lens calibration of camera '%1' is %2 days old")(name, *days),
                 ODO_TEXT("workflow.calibrate_if_touched",
                          "if zoom, focus or the camera's settings have changed since, calibrate it again."));
        const Intrinsics &lens = intrinsics->calibration.intrinsics;
        if (recording &&
            !determinedFormat(lens.widthPx, lens.heightPx, recording->widthPx, recording->heightPx))
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
                            "The floor registration of camera '%1' uses another lens calibration than the "
                            "current one")(name),
             ODO_TEXT("workflow.register_it_again", "register it again."));
    return warnings;
}

namespace {

/// The layout, and those in its axes because a camera was registered via one of its cameras.
Result<std::vector<LayoutRecord>> layoutsOfWorld(Project &project, const LayoutRecord &first)
{
    const auto all = ODO_TRY(project.layouts().all());
    std::vector<LayoutRecord> world{first};
    for (std::size_t i = 0; i < world.size(); ++i) {
        const auto cameras = ODO_TRY(camerasOnLayout(project, world[i].id));
        for (const LayoutRecord &layout : all) {
            const bool isViaCamera = std::ranges::any_of(cameras, [&](const RegisteredCamera &camera) {
                return isLayoutOfReference(layout.layout.name, camera.camera.name);
            });
            if (isViaCamera && std::ranges::find(world, layout.id, &LayoutRecord::id) == world.end())
                world.push_back(layout);
        }
    }
    return world;
}

Result<void> carryCameras(Project &project, const LayoutRecord &layout, LayoutAxesOutcome &outcome)
{
    const auto cameras = ODO_TRY(camerasOnLayout(project, layout.id));
    for (const RegisteredCamera &camera : cameras) {
        RegistrationRecord record = camera.registration;
        record.registration = transformed(record.registration, outcome.newFromOld);
        std::optional<RegistrationCheck> check = record.lastCheck;
        if (check)
            check->shiftM *= outcome.newFromOld.scale;
        ODO_TRY(storeFromOldMarkers(project, camera.camera.name, std::move(record), check));
        outcome.cameras.push_back(camera.camera.name);
    }
    return {};
}

bool hasPositions(const Task &task)
{
    return !task.gates.empty() || !task.path.points.empty() || !task.zones.empty();
}

/// Whether the runs of a task were measured on these floors alone; of one that was never driven: whether
/// there is no other floor.
class TasksOfFloor
{
public:
    static Result<TasksOfFloor> of(Project &project, const std::vector<LayoutRecord> &floor)
    {
        TasksOfFloor tasks;
        const auto isOfFloor = [&](RecordId layout) {
            return std::ranges::find(floor, layout, &LayoutRecord::id) != floor.end();
        };
        const auto layouts = ODO_TRY(project.layouts().all());
        tasks.m_isOnlyFloor =
            std::ranges::all_of(layouts, [&](const LayoutRecord &layout) { return isOfFloor(layout.id); });
        std::set<std::string> here, elsewhere;
        const auto registrations = ODO_TRY(project.analyses().trialsByRegistration());
        for (const auto &[id, names] : registrations) {
            const auto registration = ODO_TRY(project.cameras().registration(id));
            (isOfFloor(registration.layout) ? here : elsewhere).insert(names.begin(), names.end());
        }
        const auto trials = ODO_TRY(project.trials().all());
        for (const TrialRecord &trial : trials) {
            // A track that was imported is in axes of its own.
            const auto tracks = ODO_TRY(importedTracksOf(project, trial));
            const bool isElsewhere =
                elsewhere.contains(trial.name) || (!here.contains(trial.name) && !tracks.empty());
            if (isElsewhere)
                tasks.m_elsewhere.insert(trial.task);
            else if (here.contains(trial.name))
                tasks.m_here.insert(trial.task);
        }
        return tasks;
    }

    bool contains(const TaskRecord &task) const
    {
        return !m_elsewhere.contains(task.name) && (m_isOnlyFloor || m_here.contains(task.name));
    }

private:
    bool m_isOnlyFloor = false;
    std::set<std::string> m_here, m_elsewhere;
};

Result<void> carryTasks(Project &project, const std::vector<LayoutRecord> &floor, LayoutAxesOutcome &outcome)
{
    const auto ofFloor = ODO_TRY(TasksOfFloor::of(project, floor));
    const auto uses = ODO_TRY(project.tasks().uses());
    const auto tasks = ODO_TRY(project.tasks().all());
    for (TaskRecord task : tasks) {
        const auto use = uses.find(task.id);
        if (!hasPositions(task.task) || (use != uses.end() && isEarlierVersion(task, use->second)))
            continue;
        if (!ofFloor.contains(task)) {
            outcome.tasks.push_back(task.name);
            continue;
        }
        task.task = transformed(task.task, outcome.newFromOld);
        ODO_TRY(project.tasks().change(task));
        outcome.movedTasks.push_back(task.name);
    }
    return {};
}

} // namespace

Result<LayoutAxesOutcome> changeLayoutAxes(Project &project, const std::string &layout,
                                           const AxesChange &change)
{
    auto stored = ODO_TRY(project.layouts().find(layout));
    const auto newFromOld = ODO_TRY(axesTransformOf(stored.layout, change));
    LayoutAxesOutcome outcome{std::move(stored), newFromOld, {}, {}, {}};
    const auto world = ODO_TRY(layoutsOfWorld(project, outcome.layout));
    const auto done = project.change(
        ODO_TEXT("workflow.put_axes_elsewhere", "change the world axes of layout %1")(Named::layout(layout)),
        [&]() -> Result<void> {
            for (LayoutRecord each : world) {
                each.layout = transformed(each.layout, newFromOld);
                ODO_TRY(project.layouts().setPoints(each));
                ODO_TRY(carryCameras(project, each, outcome));
            }
            outcome.layout.layout = transformed(outcome.layout.layout, newFromOld);
            return carryTasks(project, world, outcome);
        });
    if (!done)
        return tl::unexpected(done.error());
    return outcome;
}

} // namespace odo
