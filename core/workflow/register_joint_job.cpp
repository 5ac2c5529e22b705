// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/register_joint_job.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/registered_view.h"
#include "core/workflow/stored_registration.h"

namespace odo {

RegisterJointJob::RegisterJointJob(RegisterJointSettings settings) : m_settings(std::move(settings)) {}

Result<void> RegisterJointJob::prepare(Project &project)
{
    const auto layout = project.layouts().find(m_settings.layout);
    if (!layout)
        return tl::unexpected(layout.error());
    m_layout = layout->layout;
    auto cameras = camerasOnLayout(project, layout->id);
    if (!cameras)
        return tl::unexpected(cameras.error());
    for (RegisteredCamera &camera : *cameras) {
        const auto view = floorViewOf(project, camera.registration);
        if (!view)
            return tl::unexpected(view.error());
        m_names.push_back(camera.camera.name);
        m_cameras.push_back({camera.camera.name, view->camera(), view->worldFromCamera(), camera.registration.pixels});
        m_records.push_back(std::move(camera.registration));
    }
    return {};
}

Result<void> RegisterJointJob::run(const JobControl &control)
{
    control.report(0, "fitting " + std::to_string(m_cameras.size()) + " cameras together");
    auto joint = registerJointly(m_layout, m_cameras, m_settings.tapeSigmaM);
    if (!joint)
        return tl::unexpected(joint.error());
    m_joint = std::move(*joint);
    return {};
}

Result<void> RegisterJointJob::commit(Project &project)
{
    return project.note("register the cameras of layout " + m_settings.layout + " together", [&]() -> Result<void> {
        for (std::size_t i = 0; i < m_records.size(); ++i) {
            m_records[i].registration = m_joint.registrations[i];
            const auto stored = storeFromOldMarkers(project, m_names[i], m_records[i], m_records[i].lastCheck);
            if (!stored)
                return tl::unexpected(stored.error());
            m_records[i] = *stored;
        }
        return {};
    });
}

} // namespace odo
