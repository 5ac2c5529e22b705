// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/gige/gige_packets.h"
#include "tests/support/gige/gige_registers.h"
#include "tests/support/gige/simulated_clock.h"

#include <netinet/in.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <thread>

namespace odo::test {

/// A picture that a simulated camera is to take.
struct Exposure
{
    std::uint16_t id = 0;
    Nanoseconds begin{0}, length{0}; ///< by this machine's steady clock
    std::uint32_t pixelFormat = 0;
    int width = 0, height = 0;
};

/// A GigE Vision camera on this machine's loopback: answers GVCP and streams GVSP like a real one, with a
/// clock of its own and with whatever can go wrong on a cable. It exists on the network as long as the object
/// lives: destroying it is pulling the plug.
///
/// Sockets are its own, and so is its memory: it shares no code with Aravis. Each test takes addresses of its
/// own, because the port is fixed.
class SimulatedGigeCamera
{
public:
    struct Settings
    {
        std::string address = "127.0.0.2", serial = "SIM1", model = "Simulated";
        int sensorWidth = 640, sensorHeight = 480;
        double framesPerSecond = 30, exposureS = 0.005;
        std::uint32_t pixelFormat = 0x01080001; ///< Mono8
        double clockOffsetS = 1000, clockPpm = 0;
        std::uint64_t ticksPerSecond = 1'000'000'000;
        Nanoseconds grid{0}; ///< pictures begin at this steady time, and every interval of its clock after it
        double deliveryJitterS = 0; ///< pictures are sent up to this much late
        std::uint16_t firstId = 1;
        bool timestampLatch = true, automatics = false, answersResends = true;
        std::chrono::milliseconds heartbeat{3000};
        unsigned seed = 1;
    };
    /// Paints raw pixels; called in the camera's own thread. Pixel format and size are the same as long as
    /// the camera streams.
    using Painter = std::function<void(const Exposure &, std::span<std::uint8_t>)>;

    SimulatedGigeCamera(Settings settings, Painter painter);
    ~SimulatedGigeCamera();
    SimulatedGigeCamera(const SimulatedGigeCamera &) = delete;
    SimulatedGigeCamera &operator=(const SimulatedGigeCamera &) = delete;

    // What goes wrong; any thread.
    std::atomic<double> loss = 0;          ///< of packets, 0 to 1
    std::atomic<bool> muteStream = false;  ///< takes pictures and sends none
    std::atomic<bool> muteControl = false; ///< answers nothing
    std::atomic<int> skipIds = 0;          ///< so many pictures are taken and never sent
    std::atomic<int> cutRows = 0;          ///< sends so many rows less than it promised

    // What happened; any thread.
    std::atomic<std::uint64_t> frames = 0, resent = 0, refused = 0, triggered = 0;

    /// Its clock begins anew, as after a loss of power that nobody noticed.
    void resetClock();
    bool isControlled() const;
    std::uint32_t read(std::uint32_t address) const;
    float readFloat(std::uint32_t address) const;

private:
    using Lock = std::unique_lock<std::mutex>;

    void setUpRegisters();
    void answerControl();
    void answer(int socket);
    void handle(std::span<const std::uint8_t> message, const sockaddr_in &from);
    void acknowledge(const sockaddr_in &to, std::uint16_t status, std::uint16_t command, std::uint16_t id,
                     std::span<const std::uint8_t> content);
    std::uint16_t write(std::uint32_t address, std::uint32_t value, const sockaddr_in &from);
    bool mayWrite(const sockaddr_in &from) const;
    void releaseControl();
    void updatePayload();
    void resend(std::uint16_t imageId, std::uint32_t first, std::uint32_t last);
    sockaddr_in destination() const;

    void stream();
    std::optional<Nanoseconds> waitForExposure(Lock &lock);
    bool sleepUntil(Lock &lock, Nanoseconds time);
    void wanderAutomatics();
    void takeFrame(Lock &lock, Nanoseconds begin);
    void send(const std::vector<Packet> &packets, const sockaddr_in &to, double delayS);

    const Settings m_settings;
    Painter m_painter;
    const int m_control, m_broadcast, m_data; ///< sockets

    mutable std::mutex m_mutex; ///< guards what follows
    std::condition_variable m_wake;
    GigeRegisters m_registers;
    SimulatedClock m_clock;
    std::optional<sockaddr_in> m_controller;
    Nanoseconds m_lastHeard{0};
    bool m_acquiring = false, m_stopped = false;
    unsigned m_acquisition = 0; ///< counts starts and stops
    std::optional<Nanoseconds> m_trigger;
    Nanoseconds m_next{0};
    std::uint16_t m_lastId;
    std::deque<std::pair<std::uint16_t, std::vector<Packet>>> m_sent; ///< the last pictures, for resending
    std::mt19937 m_random;

    std::thread m_controlThread, m_streamThread;
};

} // namespace odo::test
