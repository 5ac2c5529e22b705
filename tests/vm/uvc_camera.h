// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/vm/uvc_controls.h"

#include <chrono>
#include <deque>
#include <mutex>
#include <thread>

namespace odo::test {

/// A USB webcam that this process plays for the kernel's own driver, through the USB/IP host (module
/// vhci_hcd) and a pair of sockets. YUYV is a gradient that moves, brighter with the control; MJPEG the
/// pictures given, in turn. Needs root. Any thread.
class UvcCamera
{
public:
    struct Identity
    {
        std::string name = "Played Camera", serial;
    };
    /// pictures: JPEG files of 320×240.
    UvcCamera(unsigned port, Identity identity, std::vector<UsbBytes> frames);
    ~UvcCamera();
    UvcCamera(const UvcCamera &) = delete;
    UvcCamera &operator=(const UvcCamera &) = delete;

    bool plug(); ///< false when the kernel does not take it
    void unplug();
    void setStalled(bool stalled);
    void breakOne();   ///< the next picture is sent with the error bit
    void shortenOne(); ///< of the next picture only a half is sent
    UvcControls controls() const;

private:
    struct Request
    {
        std::uint32_t sequence, length;
    };
    struct Setup;

    void run();
    bool readable();
    void control(std::uint32_t sequence, const Setup &setup, std::uint32_t length,
                 std::span<const std::uint8_t> data);
    std::optional<UsbBytes> standardAnswer(const Setup &setup);
    std::optional<UsbBytes> streamAnswer(const Setup &setup, std::span<const std::uint8_t> data);
    void unlink(std::uint32_t sequence, std::uint32_t victim);
    void reply(std::uint32_t command, std::uint32_t sequence, int status, std::size_t actual,
               const UsbBytes &data);
    void settle();
    void startStream();
    void sendWhatIsDue();
    UsbBytes payload();
    UsbBytes nextFrame();
    int waitMs() const;
    void wake();

    const unsigned m_port;
    const Identity m_identity;
    const std::vector<UsbBytes> m_frames;
    std::thread m_thread;
    int m_socket = -1, m_wake = -1;

    mutable std::mutex m_mutex; ///< guards what follows
    UvcControls m_controls;
    UsbBytes m_probe; ///< what was negotiated (USB Video Class 1.0, table 4-47)
    bool m_ending = false, m_streaming = false, m_stalled = false, m_break = false, m_shorten = false;
    bool m_toggle = false;
    unsigned m_count = 0;
    std::chrono::steady_clock::time_point m_due;
    UsbBytes m_frame; ///< that is under way
    std::size_t m_sent = 0;
    std::deque<Request> m_pending;
};

} // namespace odo::test
