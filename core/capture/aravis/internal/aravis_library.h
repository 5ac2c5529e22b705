// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <arv.h>
#include <functional>
#include <memory>
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

    /// The USB devices. Waits for an opening in progress.
    std::vector<UsbVisionCamera> usbCameras();

    /// Takes over a thread that is still letting go of a camera: one that is gone takes Aravis up to 7.5 s.
    /// Waits for it when the program ends, at the latest.
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

struct GObjectRelease
{
    void operator()(void *object) const { g_object_unref(object); }
};
/// Owns one reference of an object of Aravis.
template <class T>
using ArvPointer = std::unique_ptr<T, GObjectRelease>;

struct GFree
{
    void operator()(void *memory) const { g_free(memory); }
};
/// Owns a list that Aravis has allocated, not what is in it.
template <class T>
using ArvList = std::unique_ptr<T[], GFree>;

/// Takes the error of one call of Aravis: `ArvFailure failure; arv_...(camera, failure.out()); if (failure)
/// ...`.
class ArvFailure
{
public:
    ArvFailure() = default;
    ~ArvFailure() { g_clear_error(&m_error); }
    ArvFailure(const ArvFailure &) = delete;
    ArvFailure &operator=(const ArvFailure &) = delete;

    GError **out()
    {
        g_clear_error(&m_error);
        return &m_error;
    }
    explicit operator bool() const { return m_error != nullptr; }
    bool is(ArvDeviceError code) const { return g_error_matches(m_error, ARV_DEVICE_ERROR, code); }
    Message words() const { return m_error ? foreignWords(m_error->message) : Message(); }

private:
    GError *m_error = nullptr;
};

} // namespace odo
