// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check/expected_accuracy.h"

#include <limits>

namespace odo {
namespace {

constexpr double followedPx = 0.1; // of one coordinate of what the tracker follows
constexpr double marginM = 0.3;    // robots drive beyond the markers too

} // namespace

ExpectedAccuracy expectedAccuracy(const AccuracyRequest &request)
{
    ExpectedAccuracy expected;
    std::vector<FloorView> views;
    std::optional<std::size_t> alone;
    for (std::size_t i = 0; i < request.cameras.size(); ++i) {
        const auto *planned = std::get_if<PlannedCamera>(&request.cameras[i]);
        Result<FloorView> view = planned ? plannedView(*planned, request.layout) : Result<FloorView>(std::get<FloorView>(request.cameras[i]));
        expected.problems.push_back(view ? std::nullopt : std::optional(view.error()));
        if (!view)
            continue;
        if (request.alone == i)
            alone = views.size();
        views.push_back(std::move(*view));
    }
    const FloorGrid grid = gridOver(request.layout, marginM);
    AccuracyMap map = accuracyMap(views, grid, followedPx, request.robotHeightM);
    if (request.alone && !alone) // the one that is asked for cannot be there
        std::ranges::fill(map.fusedSigmaM, std::numeric_limits<double>::quiet_NaN());
    expected.map = {grid, alone ? std::move(map.cameraSigmaM[*alone]) : std::move(map.fusedSigmaM)};
    expected.summary = summariseAccuracy(grid, expected.map.sigmaM, request.layout);
    return expected;
}

AccuracyMaker::AccuracyMaker(QObject *parent) : QObject(parent)
{
    connect(&m_task, &BackgroundTask::finished, this, [this] {
        Q_EMIT ready(*m_made);
        if (m_next)
            begin(*std::exchange(m_next, std::nullopt));
    });
}

void AccuracyMaker::make(AccuracyRequest request)
{
    if (m_task.isRunning())
        m_next = std::move(request);
    else
        begin(std::move(request));
}

void AccuracyMaker::begin(AccuracyRequest request)
{
    m_made = std::make_shared<ExpectedAccuracy>();
    m_task.start([made = m_made, request = std::move(request)](const JobControl &) -> Result<void> {
        *made = expectedAccuracy(request);
        return {};
    });
}

} // namespace odo
