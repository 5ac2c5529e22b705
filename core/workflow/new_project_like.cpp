// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/new_project_like.h"

#include "core/base/file_system.h"
#include "core/base/without_value.h"
#include "core/files/output_guard.h"
#include "core/project/new_file.h"
#include "core/project/project.h"
#include "core/project/repositories.h"

namespace odo {
namespace {

template <class Record, class Take>
Result<void> takeAll(const Result<std::vector<Record>> &records, const Take &take)
{
    if (!records)
        return tl::unexpected(records.error());
    for (const Record &record : *records)
        if (Result<void> taken = take(record); !taken)
            return taken;
    return {};
}

/// Without the pictures that it was calibrated from.
Result<void> takeLens(Project &from, RecordId camera, Project &to, RecordId newCamera)
{
    auto lens = from.cameras().currentIntrinsics(camera);
    if (!lens || !*lens)
        return lens ? Result<void>() : tl::unexpected(lens.error());
    IntrinsicsRecord taken = **lens;
    taken.camera = newCamera;
    taken.files.clear();
    return withoutValue(to.cameras().addIntrinsics(taken));
}

Result<void> takeSetUp(Project &from, Project &to, const JobControl &control)
{
    const auto camera = [&](const CameraRecord &record) -> Result<void> {
        if (control.isCancelled())
            return cancelled("new project");
        const auto added = to.cameras().add(record);
        return added ? takeLens(from, record.id, to, added->id) : tl::unexpected(added.error());
    };
    const auto layout = [&](const LayoutRecord &record) { return withoutValue(to.layouts().add(record.layout)); };
    const auto robot = [&](const RobotRecord &record) { return withoutValue(to.robots().add(record)); };
    const auto task = [&](const TaskRecord &record) -> Result<void> {
        const auto scoring = from.tasks().scoring(record.id);
        const auto added = to.tasks().add(record);
        if (!scoring || !added)
            return tl::unexpected(scoring ? added.error() : scoring.error());
        return scoring->empty() ? Result<void>() : to.tasks().setScoring(added->id, *scoring);
    };
    if (auto taken = takeAll(from.cameras().all(), camera); !taken)
        return taken;
    if (auto taken = takeAll(from.layouts().all(), layout); !taken)
        return taken;
    if (auto taken = takeAll(from.robots().all(), robot); !taken)
        return taken;
    return takeAll(from.tasks().current(), task);
}

/// In place of the empty file that is there. Closed it is one file, with everything in it.
Result<void> makeFilled(Project &from, const std::filesystem::path &file, const std::string &title, const JobControl &control)
{
    files::remove(file);
    const auto original = from.title();
    if (!original)
        return tl::unexpected(original.error());
    const auto to = Project::create(file, title);
    if (!to)
        return tl::unexpected(to.error());
    return (*to)->note("take over the set-up of " + *original, [&] { return takeSetUp(from, **to, control); });
}

} // namespace

Result<std::filesystem::path> makeProjectLike(const std::filesystem::path &original, const std::filesystem::path &file,
                                              const std::string &title, const JobControl &control)
{
    control.report(0, "taking over the set-up");
    const auto from = Project::openAgain(original, Project::Access::ReadOnly);
    if (!from)
        return tl::unexpected(from.error());
    const std::string what = "project '" + file.string() + "'";
    if (auto may = checkNewProject(file, what); !may)
        return tl::unexpected(may.error());
    NewFile made(file, what);
    if (auto ready = made.prepare(); !ready)
        return tl::unexpected(ready.error());
    if (auto filled = makeFilled(**from, made.temporary(), title, control); !filled)
        return tl::unexpected(filled.error());
    if (auto published = made.publish(); !published)
        return tl::unexpected(published.error());
    return file;
}

} // namespace odo
