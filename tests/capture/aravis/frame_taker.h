// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "tests/support/gige/raw_painters.h"
#include "tests/support/patience.h"

#include <QTest>

#include <mutex>
#include <thread>
#include <vector>

namespace odo::test {

/// The camera at an address; a failure of the test where it cannot be opened.
inline std::unique_ptr<CameraSource> opened(const std::string &uri)
{
    auto source = openCamera(uri);
    if (!source)
        QTest::qFail(source.error().message().c_str(), __FILE__, __LINE__);
    return source ? std::move(*source) : nullptr;
}

/// Takes all that a camera gives, on a thread of its own, as a recording does.
class FrameTaker
{
public:
    struct Taken
    {
        std::uint64_t sequence;
        Nanoseconds time, hostTime;
        FrameCode code;
        std::optional<ClockReading> clock;
        std::uint64_t lostHere;
    };
    struct Failure
    {
        Error error;
        Nanoseconds at;
    };

    explicit FrameTaker(CameraSource &source) : m_source(source), m_thread([this] { run(); }) {}
    ~FrameTaker()
    {
        m_source.stop();
        m_thread.join();
    }

    std::vector<Taken> frames() const
    {
        const std::lock_guard lock(m_mutex);
        return m_frames;
    }
    std::size_t count() const
    {
        const std::lock_guard lock(m_mutex);
        return m_frames.size();
    }
    std::vector<Failure> failures() const
    {
        const std::lock_guard lock(m_mutex);
        return m_failures;
    }
    /// When it was first said; nullopt when it was not.
    std::optional<Nanoseconds> said(const std::string &words) const
    {
        for (const Failure &failure : failures()) {
            if (failure.error.message().find(words) != std::string::npos)
                return failure.at;
        }
        return std::nullopt;
    }
    /// Of those taken since then.
    std::size_t countSince(Nanoseconds begin) const
    {
        const auto all = frames();
        return static_cast<std::size_t>(
            std::ranges::count_if(all, [begin](const Taken &one) { return one.code.begin > begin; }));
    }

private:
    void run()
    {
        for (;;) {
            auto captured = m_source.next();
            const std::lock_guard lock(m_mutex);
            if (captured) {
                m_frames.push_back({captured->sequence, captured->frame.time, captured->hostTime,
                                    readCode(captured->frame), captured->clock, captured->lostHere});
                continue;
            }
            if (captured.error().code == ErrorCode::Cancelled)
                return;
            m_failures.push_back({captured.error(), steadyNow()});
            if (captured.error().code != ErrorCode::Unavailable)
                return;
        }
    }

    CameraSource &m_source;
    mutable std::mutex m_mutex;
    std::vector<Taken> m_frames;
    std::vector<Failure> m_failures;
    std::thread m_thread;
};

} // namespace odo::test
