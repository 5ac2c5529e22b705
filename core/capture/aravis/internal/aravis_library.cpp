// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/aravis/internal/aravis_library.h"

#include <arv.h>

namespace odo {

namespace {

constexpr const char *gigE = "GigEVision", *fake = "Fake";

std::string textOf(const char *text)
{
    return text ? text : "";
}

} // namespace

AravisLibrary &AravisLibrary::instance()
{
    static AravisLibrary library;
    return library;
}

AravisLibrary::AravisLibrary()
{
    arv_disable_interface(fake);
}

AravisLibrary::~AravisLibrary()
{
    for (Finishing &one : m_threads)
        one.thread.join();
    arv_shutdown();
}

std::vector<UsbVisionCamera> AravisLibrary::usbCameras()
{
    const std::lock_guard lock(m_openMutex);
    // Cameras on the network are found by us: Aravis would take a second, with all its locks held.
    arv_disable_interface(gigE);
    arv_update_device_list();
    std::vector<UsbVisionCamera> cameras;
    for (unsigned i = 0; i < arv_get_n_devices(); ++i)
        cameras.push_back({textOf(arv_get_device_id(i)), textOf(arv_get_device_vendor(i)),
                           textOf(arv_get_device_model(i)), textOf(arv_get_device_serial_nbr(i))});
    arv_enable_interface(gigE);
    return cameras;
}

void AravisLibrary::finishLater(std::thread thread, std::function<bool()> hasEnded)
{
    const std::lock_guard lock(m_threadsMutex);
    std::erase_if(m_threads, [](Finishing &one) {
        const bool ended = one.hasEnded();
        if (ended)
            one.thread.join();
        return ended;
    });
    m_threads.push_back({std::move(thread), std::move(hasEnded)});
}

} // namespace odo
