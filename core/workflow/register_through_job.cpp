// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/register_through_job.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/registered_view.h"
#include "core/workflow/stored_registration.h"

#include <algorithm>

namespace odo {

namespace {

constexpr const char *throughWord = " through ";

std::string subject(const RegisterThroughSettings &settings)
{
    return "registration of camera '" + settings.camera + "' through '" + settings.through + "'";
}

std::string freeName(const std::vector<LayoutRecord> &layouts, const std::string &wanted)
{
    const auto isTaken = [&](const std::string &name) {
        return std::ranges::any_of(layouts, [&](const LayoutRecord &one) { return one.layout.name == name; });
    };
    std::string name = wanted;
    for (int number = 2; isTaken(name); ++number)
        name = wanted + " (" + std::to_string(number) + ")";
    return name;
}

} // namespace

RegisterThroughJob::RegisterThroughJob(RegisterThroughSettings settings) : m_settings(std::move(settings)) {}

Result<void> RegisterThroughJob::prepare(Project &project)
{
    if (m_settings.camera == m_settings.through)
        return fail(ErrorCode::InvalidInput, subject(m_settings),
                    "a camera cannot be registered through itself", "name another camera that is registered");
    const auto through = project.cameras().find(m_settings.through);
    if (!through)
        return tl::unexpected(through.error());
    const auto registration = project.cameras().currentRegistration(through->id);
    if (!registration)
        return tl::unexpected(registration.error());
    if (!*registration)
        return fail(ErrorCode::NotFound, subject(m_settings),
                    "camera '" + m_settings.through + "' is not registered",
                    "register it first, by markers or through another camera");
    auto view = floorViewOf(project, **registration);
    if (!view)
        return tl::unexpected(view.error());
    m_through = std::move(*view);
    m_throughRegistration = (*registration)->id;
    return findCamera(project);
}

Result<void> RegisterThroughJob::findCamera(Project &project)
{
    const auto camera = project.cameras().find(m_settings.camera);
    if (!camera)
        return tl::unexpected(camera.error());
    const auto intrinsics = project.cameras().currentIntrinsics(camera->id);
    if (!intrinsics)
        return tl::unexpected(intrinsics.error());
    if (*intrinsics) {
        auto model = CameraModel::create((*intrinsics)->calibration.intrinsics);
        if (!model)
            return tl::unexpected(model.error());
        m_camera = std::move(*model);
        m_intrinsicsKnown = true;
        m_record.intrinsics = (*intrinsics)->id;
        return {};
    }
    const auto recording = project.trials().newestRecording(camera->id);
    if (!recording)
        return tl::unexpected(recording.error());
    if (!*recording)
        return fail(ErrorCode::NotFound, subject(m_settings),
                    "the size of its pictures is not known: it has no intrinsics and no recording",
                    "calibrate it, import its intrinsics, or import a trial with it first");
    m_camera = CameraModel::assumed((*recording)->widthPx, (*recording)->heightPx);
    return {};
}

Result<void> RegisterThroughJob::run(const JobControl &)
{
    auto chained = registerThrough(*m_through, "camera '" + m_settings.through + "'", m_settings.points, *m_camera,
                                   m_intrinsicsKnown);
    if (!chained) {
        Error error = chained.error();
        error.what = subject(m_settings);
        return tl::unexpected(error);
    }
    m_layout = std::move(chained->places);
    m_record.pixels = std::move(chained->pixels);
    m_record.registration = std::move(chained->registration);
    m_record.assumedIntrinsics = m_record.registration.intrinsics;
    m_record.picture = m_settings.picture;
    m_record.registration.verdict +=
        " It was made through registration " + std::to_string(m_throughRegistration) + " of the project.";
    return {};
}

Result<void> RegisterThroughJob::commit(Project &project)
{
    return project.note("register camera " + m_settings.camera + " through camera " + m_settings.through, [&]() -> Result<void> {
        const auto layouts = project.layouts().all();
        if (!layouts)
            return tl::unexpected(layouts.error());
        m_layout.name = freeName(*layouts, m_settings.camera + throughWord + m_settings.through);
        const auto layout = project.layouts().add(m_layout);
        if (!layout)
            return tl::unexpected(layout.error());
        m_record.layout = layout->id;
        const auto stored = storeRegistration(project, m_settings.camera, m_record);
        if (!stored)
            return tl::unexpected(stored.error());
        m_record = *stored;
        return {};
    });
}

bool isLayoutThrough(const std::string &layoutName, const std::string &through)
{
    // freeName() may have put a number behind it.
    const std::string ending = throughWord + through;
    const auto at = layoutName.rfind(ending);
    if (at == std::string::npos || at == 0)
        return false;
    const std::string rest = layoutName.substr(at + ending.size());
    return rest.empty() || (rest.starts_with(" (") && rest.ends_with(")"));
}

} // namespace odo
