// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/aravis/internal/aravis_session.h"

#include "core/capture/camera_source.h"

namespace odo {

namespace {

constexpr std::size_t mostFrames = 32; // a second at 30 frames/s; at 1280×720 some 45 MB

} // namespace

Result<CapturedFrame> AravisSession::next(Nanoseconds patience)
{
    std::unique_lock lock(m_mutex);
    m_forUser.wait_for(lock, patience, [this] { return m_stopped || !m_frames.empty(); });
    if (m_stopped)
        return cancelled(cameraAtAddress(m_uri));
    if (!m_frames.empty()) {
        CapturedFrame frame = std::move(m_frames.front());
        m_frames.pop_front();
        return frame;
    }
    if (m_problem)
        return tl::unexpected(*m_problem);
    return fail(ErrorCode::Unavailable, cameraAtAddress(m_uri),
                ODO_TEXT("capture.no_picture_came", "no frame arrived for half a second"),
                ODO_TEXT("capture.wait_or_check_cable", "wait, or check its cable"));
}

CameraCounts AravisSession::counts() const
{
    const std::lock_guard lock(m_mutex);
    return m_counts;
}

void AravisSession::stop()
{
    const std::lock_guard lock(m_mutex);
    m_stopped = true;
    m_forUser.notify_all();
    m_forCamera.notify_all();
}

void AravisSession::ask(Task task)
{
    {
        const std::lock_guard lock(m_mutex);
        if (!m_ended) {
            m_tasks.push_back(std::move(task));
            m_forCamera.notify_all();
            return;
        }
    }
    task(nullptr);
}

bool AravisSession::waitForEnd(Nanoseconds patience)
{
    std::unique_lock lock(m_mutex);
    return m_forUser.wait_for(lock, patience, [this] { return m_ended; });
}

bool AravisSession::isStopped() const
{
    const std::lock_guard lock(m_mutex);
    return m_stopped;
}

void AravisSession::deliver(CapturedFrame frame)
{
    const std::lock_guard lock(m_mutex);
    m_problem.reset();
    m_frames.push_back(std::move(frame));
    if (m_frames.size() > mostFrames) { // leaves a gap in the sequence
        const std::uint64_t lost = m_frames.front().lostHere + 1;
        m_frames.pop_front();
        m_frames.front().lostHere += lost;
    }
    m_forUser.notify_all();
}

void AravisSession::setProblem(Error error)
{
    const std::lock_guard lock(m_mutex);
    m_problem = std::move(error);
}

void AravisSession::count(const CameraCounts &counts)
{
    const std::lock_guard lock(m_mutex);
    m_counts = counts;
}

void AravisSession::runTasks(AravisDevice *device)
{
    std::deque<Task> tasks;
    {
        const std::lock_guard lock(m_mutex);
        tasks.swap(m_tasks);
    }
    for (const Task &task : tasks)
        task(device);
}

void AravisSession::waitWithoutCamera(Nanoseconds howLong)
{
    runTasks(nullptr);
    std::unique_lock lock(m_mutex);
    m_forCamera.wait_for(lock, howLong, [this] { return m_stopped || !m_tasks.empty(); });
}

void AravisSession::end()
{
    {
        const std::lock_guard lock(m_mutex);
        m_ended = true;
        m_forUser.notify_all();
    }
    runTasks(nullptr);
}

} // namespace odo
