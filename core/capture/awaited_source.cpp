// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/awaited_source.h"

#include "core/base/shortage.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr auto cameraWithin = 500ms;

CameraDescription knownOf(const std::string &uri)
{
    return {.uri = uri, .kind = uri.substr(0, uri.find(':')), .name = uri};
}

class AwaitedSource : public CameraSource
{
public:
    using Open = std::function<Result<std::unique_ptr<CameraSource>>()>;

    AwaitedSource(const std::string &uri, Error why, Open open, Nanoseconds betweenAttempts)
        : m_known(knownOf(uri)), m_open(std::move(open)), m_betweenAttempts(betweenAttempts),
          m_why(std::move(why))
    {
        if (auto opener = startThread("camera " + uri, [this] { await(); })) {
            m_opener = std::move(*opener);
        } else {
            m_why = opener.error();
            m_why.code = ErrorCode::InvalidInput; // nobody tries again
        }
    }
    ~AwaitedSource() override
    {
        stop();
        if (m_opener.joinable())
            m_opener.join();
    }

    const CameraDescription &description() const override
    {
        const CameraSource *source = camera();
        return source ? source->description() : m_known;
    }
    Result<CapturedFrame> next() override
    {
        CameraSource *source = nullptr;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait_for(lock, cameraWithin, [this] { return m_stopped || m_camera || isHopeless(); });
            if (m_stopped)
                return cancelled(m_known.uri);
            if (!m_camera && isHopeless())
                return tl::unexpected(m_why);
            if (!m_camera)
                return fail(ErrorCode::Unavailable, m_why.what, m_why.why, m_why.advice);
            source = m_camera.get();
        }
        return source->next();
    }
    void stop() override
    {
        const std::lock_guard lock(m_mutex);
        m_stopped = true;
        m_wake.notify_all();
        if (m_camera)
            m_camera->stop();
    }

    CameraCounts counts() const override
    {
        const CameraSource *source = camera();
        return source ? source->counts() : CameraCounts{};
    }
    Result<std::vector<CameraControl>> controls() override
    {
        if (CameraSource *source = camera())
            return source->controls();
        return notThere();
    }
    Result<void> set(const std::string &id, double value) override
    {
        if (CameraSource *source = camera())
            return source->set(id, value);
        return notThere();
    }
    std::vector<std::string> holdAutomatics() override
    {
        {
            const std::lock_guard lock(m_mutex);
            if (!m_camera) {
                m_isHoldMissed = true;
                return {};
            }
        }
        return camera()->holdAutomatics();
    }
    void showRobots(const std::vector<RobotAppearance> &robots) override
    {
        const std::lock_guard lock(m_mutex);
        m_robots = robots;
        if (m_camera)
            m_camera->showRobots(robots);
    }
    void releaseAutomatics() override
    {
        {
            const std::lock_guard lock(m_mutex);
            m_isHoldMissed = false;
        }
        if (CameraSource *source = camera())
            source->releaseAutomatics();
    }

private:
    bool isHopeless() const { return m_why.code == ErrorCode::InvalidInput; }
    /// Once it is there it stays.
    CameraSource *camera() const
    {
        const std::lock_guard lock(m_mutex);
        return m_camera.get();
    }
    tl::unexpected<Error> notThere() const
    {
        const std::lock_guard lock(m_mutex);
        return fail(ErrorCode::Unavailable, m_why.what, m_why.why, m_why.advice);
    }

    /// With the mutex held.
    void adopt(std::unique_ptr<CameraSource> camera)
    {
        m_camera = std::move(camera);
        if (m_robots)
            m_camera->showRobots(*m_robots);
    }

    /// The thread that opens it.
    void await()
    {
        std::unique_lock lock(m_mutex);
        while (!m_camera && !isHopeless() &&
               !m_wake.wait_for(lock, m_betweenAttempts, [this] { return m_stopped; })) {
            lock.unlock();
            auto opened = orShortage("camera " + m_known.uri, m_open);
            lock.lock();
            if (!opened)
                m_why = opened.error();
            else if (!m_stopped)
                adopt(std::move(*opened));
            m_wake.notify_all();
        }
        if (!m_camera || !m_isHoldMissed)
            return;
        lock.unlock();
        m_camera->holdAutomatics();
    }

    const CameraDescription m_known;
    const Open m_open;
    const Nanoseconds m_betweenAttempts;
    mutable std::mutex m_mutex; ///< guards what follows
    std::condition_variable m_wake;
    std::unique_ptr<CameraSource> m_camera; ///< set once
    Error m_why;
    bool m_stopped = false, m_isHoldMissed = false;
    std::optional<std::vector<RobotAppearance>> m_robots; ///< that it is to show
    std::thread m_opener; ///< last, so that it begins when all is there
};

} // namespace

std::unique_ptr<CameraSource> awaitCamera(const std::string &uri, Error why,
                                          std::function<Result<std::unique_ptr<CameraSource>>()> open,
                                          Nanoseconds betweenAttempts)
{
    return std::make_unique<AwaitedSource>(uri, std::move(why), std::move(open), betweenAttempts);
}

} // namespace odo
