// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/curve_maker.h"

#include <utility>

namespace odo {

namespace {

std::size_t sampleCount(const TrialScene &scene)
{
    std::size_t count = 0;
    for (const SceneRobot &robot : scene.robots)
        count += robot.analysis ? robot.analysis->profile.samples.size() : 0;
    return count;
}

} // namespace

CurveMaker::CurveMaker(QObject *parent) : QObject(parent)
{
    connect(&m_task, &BackgroundTask::finished, this, &CurveMaker::finish);
}

void CurveMaker::make(TrialScenePtr scene, Quantity quantity, std::shared_ptr<const SamplePlaces> places)
{
    m_wanted.reset();
    m_curves = {};
    if (scene && sampleCount(*scene) > mostAtOnce) {
        m_wanted = std::make_shared<Request>(Request{std::move(scene), quantity, std::move(places), {}});
        begin();
        return;
    }
    m_curves = TrialCurves(std::move(scene), quantity, *places);
}

void CurveMaker::begin()
{
    if (!m_wanted || m_task.isRunning()) // else it begins when that has ended
        return;
    m_running = m_wanted;
    m_task.start([request = m_running](const JobControl &) -> Result<void> {
        request->curves = TrialCurves(request->scene, request->quantity, *request->places);
        return {};
    });
}

void CurveMaker::finish()
{
    const auto done = std::exchange(m_running, nullptr);
    if (!m_wanted || m_wanted != done)
        return begin(); // it was overtaken
    m_wanted.reset();
    m_curves = std::move(done->curves);
    Q_EMIT made();
}

} // namespace odo
