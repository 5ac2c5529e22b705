// SPDX-License-Identifier: GPL-3.0-or-later
// The stream channel of a simulated camera: when pictures are taken, and how they are sent.
#include "tests/support/gige/simulated_gige_camera.h"

#include <sys/socket.h>

#include <cmath>

namespace odo::test {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t keptForResending = 8;
constexpr int mostFramesBehind = 30; // of a thread that this machine has let wait; after more it begins anew
constexpr Nanoseconds longestBurst = 500us;
constexpr double bytesPerSecond = 400e6;

std::uint16_t idAfter(std::uint16_t id)
{
    return id == 0xffff ? 1 : static_cast<std::uint16_t>(id + 1); // 0 is not used
}

} // namespace

/// False when it was stopped, or the acquisition was.
bool SimulatedGigeCamera::sleepUntil(Lock &lock, Nanoseconds time)
{
    const unsigned acquisition = m_acquisition;
    m_wake.wait_for(lock, time - steadyNow(), [&] { return m_stopped || m_acquisition != acquisition; });
    return !m_stopped && m_acquisition == acquisition;
}

/// When the next picture begins; waits for it. nullopt: look again.
std::optional<Nanoseconds> SimulatedGigeCamera::waitForExposure(Lock &lock)
{
    if (m_registers.get(reg::TriggerMode) != 0) {
        const unsigned acquisition = m_acquisition;
        m_wake.wait(lock, [&] { return m_stopped || m_acquisition != acquisition || m_trigger; });
        if (m_stopped || m_acquisition != acquisition)
            return std::nullopt;
        return std::exchange(m_trigger, std::nullopt);
    }
    // A sensor is exposed and read out one after the other: a long exposure lowers the rate.
    const double exposureS = 1e-6 * double{m_registers.getFloat(reg::ExposureTime)};
    const Nanoseconds interval = m_clock.hostSpan(
        std::max(1 / std::max(0.1, double{m_registers.getFloat(reg::FrameRate)}), exposureS));
    const Nanoseconds now = steadyNow();
    m_next += interval;
    if (m_next < now - mostFramesBehind * interval || m_next > now + interval) {
        const auto passed =
            static_cast<std::int64_t>(std::floor(toSeconds(now - m_settings.grid) / toSeconds(interval)));
        m_next = m_settings.grid + (passed + 1) * interval;
    }
    if (!sleepUntil(lock, m_next))
        return std::nullopt;
    return m_next;
}

void SimulatedGigeCamera::wanderAutomatics()
{
    const auto wander = [this](std::uint32_t automatic, std::uint32_t value, double least, double most) {
        if (m_registers.get(automatic) == 0)
            return;
        const double share = 0.5 + 0.5 * std::sin(0.3 * static_cast<double>(frames));
        m_registers.setFloat(value, static_cast<float>(least + share * (most - least)));
    };
    wander(reg::ExposureAuto, reg::ExposureTime, 2000, 8000);
    wander(reg::GainAuto, reg::Gain, 0, 6);
}

void SimulatedGigeCamera::stream()
{
    Lock lock(m_mutex);
    unsigned acquisition = m_acquisition;
    for (;;) {
        m_wake.wait(lock, [this] { return m_stopped || m_acquiring; });
        if (m_stopped)
            return;
        if (acquisition != m_acquisition) {
            acquisition = m_acquisition;
            m_next = Nanoseconds(0);
            m_lastId = static_cast<std::uint16_t>(m_settings.firstId - 1);
            m_sent.clear();
        }
        if (const auto begin = waitForExposure(lock))
            takeFrame(lock, *begin);
    }
}

void SimulatedGigeCamera::takeFrame(Lock &lock, Nanoseconds begin)
{
    wanderAutomatics();
    const unsigned acquisition = m_acquisition;
    Exposure exposure;
    exposure.begin = begin;
    exposure.length = fromSeconds(1e-6 * double{m_registers.getFloat(reg::ExposureTime)});
    exposure.pixelFormat = m_registers.get(reg::PixelFormat);
    exposure.width = static_cast<int>(m_registers.get(reg::Width));
    exposure.height = static_cast<int>(m_registers.get(reg::Height));
    for (int i = skipIds.exchange(0); i >= 0; --i)
        m_lastId = idAfter(m_lastId);
    exposure.id = m_lastId;
    GigeImage image{exposure.id, m_clock.ticks(begin), exposure.pixelFormat,
                    static_cast<std::uint32_t>(exposure.width), static_cast<std::uint32_t>(exposure.height)};
    std::vector<std::uint8_t> pixels(m_registers.get(reg::Payload));
    lock.unlock();
    m_painter(exposure, pixels);
    lock.lock();
    const double late = m_settings.deliveryJitterS * std::uniform_real_distribution<>(0, 1)(m_random);
    if (m_acquisition != acquisition || !sleepUntil(lock, begin + exposure.length + fromSeconds(late)))
        return; // a picture under way when the camera was stopped must not come into the next stream
    if (const auto cut = static_cast<std::uint32_t>(cutRows.load()); cut > 0) {
        pixels.resize(pixels.size() / image.height * (image.height - cut));
        image.height -= cut;
    }
    const std::size_t packetSize = std::max<std::size_t>(m_registers.get(reg::PacketSize) & 0xffff, 100);
    m_sent.emplace_back(image.id, packetsOf(image, pixels, packetSize));
    while (m_sent.size() > keptForResending)
        m_sent.pop_front();
    const std::vector<Packet> packets = m_sent.back().second;
    const double delayS = static_cast<double>(m_registers.get(reg::PacketDelay)) /
                          static_cast<double>(m_settings.ticksPerSecond);
    const sockaddr_in to = destination();
    lock.unlock();
    send(packets, to, delayS);
    ++frames;
    lock.lock();
}

void SimulatedGigeCamera::send(const std::vector<Packet> &packets, const sockaddr_in &to, double delayS)
{
    if (muteStream || to.sin_port == 0)
        return;
    std::uniform_real_distribution<> chance(0, 1);
    Nanoseconds due = steadyNow();
    for (const Packet &packet : packets) {
        if (chance(m_random) >= loss)
            sendto(m_data, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr *>(&to),
                   sizeof to);
        due += fromSeconds(delayS + static_cast<double>(packet.size()) / bytesPerSecond);
        if (due - steadyNow() > longestBurst)
            std::this_thread::sleep_for(due - steadyNow());
    }
}

} // namespace odo::test
