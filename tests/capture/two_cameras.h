// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/steady_now.h"
#include "core/capture/capture_session.h"
#include "tests/capture/played_camera.h"

#include <QTemporaryDir>
#include <QTest>

/// What the tests of a capture session share.
namespace odo::test {

using namespace std::chrono_literals;

/// Two played cameras, of which B takes its pictures 7 ms later by a clock that began an hour before A's.
struct TwoCameras
{
    /// Pictures of the past are given up at once where they find no partner; those of the future never are.
    explicit TwoCameras(Nanoseconds preRoll = 0s, Nanoseconds ago = 20s, PlayedCamera::Kind first = {},
                        DiskWatch disk = {})
    {
        first.beginning = steadyNow() - ago;
        std::vector<std::unique_ptr<CameraSource>> cameras;
        cameras.push_back(std::make_unique<PlayedCamera>(a, first));
        cameras.push_back(std::make_unique<PlayedCamera>(
            b, PlayedCamera::Kind{.beginning = first.beginning, .clockStart = -3600s, .phase = 7ms}));
        session =
            std::make_unique<CaptureSession>(std::move(cameras), CaptureSettings{preRoll, std::move(disk)});
    }
    void frames(int count) const
    {
        a->frames(count);
        b->frames(count);
    }
    ViewHealth health(std::size_t view) const { return session->health().views[view]; }
    std::uint64_t delivered() const { return std::min(health(0).delivered, health(1).delivered); }

    std::shared_ptr<Script> a = std::make_shared<Script>(), b = std::make_shared<Script>();
    std::unique_ptr<CaptureSession> session;
};

/// So many pictures at a time find room on the way to the coder, however slow this machine is just now.
inline constexpr int lot = 30;

/// Has both cameras take some lots of pictures, each lot recorded before the next one is taken.
inline void record(TwoCameras &cameras, int lots)
{
    std::size_t written[2] = {0, 0};
    for (int i = 1; i <= lots; ++i) {
        cameras.frames(lot);
        for (std::size_t view = 0; view < 2; ++view)
            QTRY_COMPARE(written[view] += cameras.session->takeWritten(view).frames.size(),
                         std::size_t(i * lot));
    }
}

/// The files of the two, in a folder.
inline std::vector<std::filesystem::path> filesIn(const QTemporaryDir &folder, const char *a = "a.mkv",
                                                  const char *b = "b.mkv")
{
    const std::filesystem::path path = folder.path().toStdString();
    return {path / a, path / b};
}

} // namespace odo::test
