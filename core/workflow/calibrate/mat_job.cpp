// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/mat_job.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/calibration_images.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr int matVideoStep = 10, mostMatImages = 12, enoughSame = 2;
constexpr double largestStretch = 0.2; // of a print; beyond it something else was measured

Message matSubject()
{
    return ODO_TEXT("workflow.floor_mat", "floor mat");
}

} // namespace

Result<void> FindMatJob::prepare(Project &)
{
    return {};
}

Result<void> FindMatJob::findIn(const std::filesystem::path &file, const JobControl &control)
{
    std::optional<FloorMat> seen;
    bool areTwo = false;
    int looked = 0, same = 0;
    ODO_TRY(visitImages(
        file, matVideoStep,
        [&](const Frame &frame, const std::string &name) {
            control.report(double(looked) / mostMatImages, detectingMarkersIn(name));
            if (const auto here = findMat(frame)) {
                const auto more = seen ? joined(*seen, *here) : here;
                areTwo |= !more;
                same = more == seen ? same + 1 : 0;
                seen = more;
            }
            return !areTwo && same < enoughSame && ++looked < mostMatImages && !control.isCancelled();
        },
        control.cancel));
    if (control.isCancelled())
        return cancelled(matSubject());
    m_isSeen.push_back(seen.has_value());
    if (seen && m_mat) {
        seen = joined(*m_mat, *seen);
        areTwo |= !seen;
    }
    if (areTwo)
        return fail(ErrorCode::Undetermined, matSubject(),
                    ODO_TEXT("workflow.two_mats", "the files show mats of different paper"),
                    ODO_TEXT("workflow.leave_one_mat", "leave one mat on the floor, and use newer files"));
    if (seen)
        m_mat = seen;
    return {};
}

Result<void> FindMatJob::run(const JobControl &control)
{
    for (const std::filesystem::path &file : m_settings.files)
        ODO_TRY(findIn(file, control));
    if (!m_mat)
        return fail(ErrorCode::Undetermined, matSubject(),
                    ODO_TEXT("workflow.no_mat_seen", "no file shows four or more of its tags"),
                    ODO_TEXT("workflow.show_mat",
                             "print the mat, lay it where the cameras see all of it, and record again"));
    if (!m_settings.checkLineM)
        return {};
    // That of a mat of few columns is shorter; of the printed one the files may show a part.
    for (const double lineM : matLinesM) {
        if (std::abs(*m_settings.checkLineM / lineM - 1) <= largestStretch) {
            m_mat->scale = *m_settings.checkLineM / lineM;
            return {};
        }
    }
    return fail(ErrorCode::InvalidInput, matSubject(),
                ODO_TEXT("workflow.check_line_is",
                         "its check line is 1000 or 200 mm long; no print is off by so much"),
                ODO_TEXT("workflow.measure_check_line", "measure the line from end mark to end mark"));
}

Result<void> FindMatJob::commit(Project &project)
{
    const std::string name = layoutName();
    if (project.layouts().find(name))
        return {};
    return project.change(ODO_TEXT("workflow.add_layout_of_mat", "add layout %1")(Named::layout(name)),
                          [&]() -> Result<void> {
                              ODO_TRY(project.layouts().add(matLayout(*m_mat)));
                              return {};
                          });
}

} // namespace odo
