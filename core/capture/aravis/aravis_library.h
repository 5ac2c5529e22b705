// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace odo {

/// A USB3 Vision camera as Aravis lists it.
struct UsbVisionCamera
{
    std::string id; ///< what Aravis opens it by
    std::string vendor, model, serial;
};

/// What is one in the process when Aravis is used. Any thread.
class AravisLibrary
{
public:
    static AravisLibrary &instance();
    AravisLibrary(const AravisLibrary &) = delete;
    AravisLibrary &operator=(const AravisLibrary &) = delete;

    /// Whoever opens a camera holds it: opening two at once corrupts Aravis 0.8.26's memory.
    std::mutex &openMutex() { return m_openMutex; }

    /// What is on the USB. Takes as long as an opening that is under way.
    std::vector<UsbVisionCamera> usbCameras();

    /// Takes over a thread that is still letting go of a camera: one that is gone takes Aravis up to 7.5 s.
    /// It is waited for when the program ends, at the latest.
    void finishLater(std::thread thread, std::function<bool()> hasEnded);

private:
    AravisLibrary();
    ~AravisLibrary();

    struct Finishing
    {
        std::thread thread;
        std::function<bool()> hasEnded;
    };
    std::mutex m_openMutex, m_threadsMutex;
    std::vector<Finishing> m_threads;
};

} // namespace odo
