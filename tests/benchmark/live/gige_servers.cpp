// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/live/gige_servers.h"

#include "tests/benchmark/live/live_scene_setup.h"
#include "tests/support/gige/raw_painters.h"

#include <QCoreApplication>

#include <cstdio>
#include <iostream>

namespace odo::test {

namespace {

constexpr double exposureS = 0.005, jitterS = 0.002;
constexpr int longestPaintingMs = 600000;

std::unique_ptr<SimulatedGigeCamera> plugIn(std::size_t camera, const LiveScene &live, Nanoseconds beginning)
{
    const SimulatedCamera &seen = live.scene.cameras[camera];
    const Intrinsics &lens = seen.view.camera().intrinsics();
    SimulatedGigeCamera::Settings settings;
    settings.address = gigeAddresses[camera];
    settings.serial = camera == 0 ? "LIVE-A" : "LIVE-B";
    settings.sensorWidth = lens.widthPx;
    settings.sensorHeight = lens.heightPx;
    settings.framesPerSecond = seen.framesPerSecond;
    settings.exposureS = exposureS;
    settings.clockOffsetS = camera == 0 ? 7 : 3600;
    settings.clockPpm = camera == 0 ? 50 : -50;
    settings.deliveryJitterS = jitterS;
    settings.grid = beginning;
    settings.seed = static_cast<unsigned>(camera) + 1;
    return std::make_unique<SimulatedGigeCamera>(
        settings, scenePainter(live.scene, static_cast<int>(camera), live.firstFrame, pixel::bayerRg8,
                               beginning + fromSeconds(exposureS / 2)));
}

} // namespace

int serveGigeCameras(int widthPx, double framesPerSecond)
{
    const LiveScene live = liveScene(widthPx, framesPerSecond);
    const Nanoseconds beginning = steadyNow();
    const std::unique_ptr<SimulatedGigeCamera> cameras[] = {plugIn(0, live, beginning),
                                                            plugIn(1, live, beginning)};
    std::cout << "ready" << std::endl;
    std::string word;
    for (std::size_t camera = 0; std::cin >> word >> camera;) {
        if (word == "skip" && camera < 2)
            ++cameras[camera]->skipIds;
    }
    return 0;
}

GigeServers::GigeServers(int widthPx, double framesPerSecond)
{
    m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    m_process.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("--serve"), QString::number(widthPx), QString::number(framesPerSecond)});
    m_ready = m_process.waitForStarted() && m_process.waitForReadyRead(longestPaintingMs) &&
              m_process.readAllStandardOutput().startsWith("ready");
}

GigeServers::~GigeServers()
{
    m_process.closeWriteChannel();
    m_process.waitForFinished();
}

void GigeServers::skip(std::size_t camera)
{
    ++m_skipped[camera];
    m_process.write(camera == 0 ? "skip 0\n" : "skip 1\n");
}

} // namespace odo::test
