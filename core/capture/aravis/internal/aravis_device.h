// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/aravis/aravis_address.h"
#include "core/capture/aravis/internal/aravis_library.h"
#include "core/capture/camera_source.h"
#include "core/video/frame.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace odo {

/// A pixel format that can be made planes of, as GenICam's Pixel Format Naming Convention has it.
struct GenicamFormat
{
    std::uint32_t code = 0;
    const char *name = "";
    int bytesPerPixel = 1;
};

/// Those that can be used, the best for tracking first: colours as the sensor has them, then colours that the
/// camera made of them, then none.
std::span<const GenicamFormat> usableGenicamFormats();
std::optional<GenicamFormat> usableGenicamFormat(std::uint32_t code);

/// "BayerRG8, RGB8, ..."
MessageArgument namesOfUsableFormats();

Message doesNotAnswer();
Message checkPowerAndCable();

/// The planes of a frame of a usable format; rows lie behind one another. The bytes are copied.
Frame genicamPlanes(const GenicamFormat &format, const std::uint8_t *bytes, int widthPx, int heightPx);

/// Where a camera is, as found by its address.
struct AravisLocation
{
    std::string openId;     ///< what Aravis opens it by; on the network its IPv4 address
    bool onNetwork = false; ///< GigE Vision; else USB3 Vision
    std::string vendor, model, serial;
};

/// How a camera was found to be set, read back from it.
struct AravisMode
{
    GenicamFormat format;
    int widthPx = 0, heightPx = 0;
    double framesPerSecond = 0;
    Nanoseconds exposure{0}; ///< 0 where not reported
    std::size_t payload = 0; ///< bytes that it sends for a frame

    std::size_t imageSize() const
    {
        return static_cast<std::size_t>(widthPx) * static_cast<std::size_t>(heightPx) *
               static_cast<std::size_t>(format.bytesPerPixel);
    }
};

/// An open camera of Aravis: setting it up, its clock, its trigger. Everything on one thread. Calls to one
/// that does not answer any more block for 2.5 s and more: ask it by GVCP before.
class AravisDevice
{
public:
    /// Finds the camera, on the network or on the USB; takes two seconds for a serial number, none for an
    /// IPv4 address. Errors: Unavailable where none answers.
    static Result<AravisLocation> find(const AravisAddress &address);
    /// Opens it and sets it as wanted. Errors: Unavailable when it does not answer or another program has it;
    /// InvalidInput for what it cannot do.
    static Result<std::unique_ptr<AravisDevice>> open(const AravisLocation &location,
                                                      const AravisAddress &wanted);
    AravisDevice(const AravisDevice &) = delete;
    AravisDevice &operator=(const AravisDevice &) = delete;

    ArvCamera *camera() const { return m_camera.get(); }
    const AravisLocation &location() const { return m_location; }
    const AravisMode &mode() const { return m_mode; }
    /// Aravis has found that a camera on the network is not ours any more, or not there.
    bool isLost() const;

    /// Reads the camera's clock, in nanoseconds, the quickest of some tries; nullopt where it cannot be
    /// asked.
    std::optional<ClockReading> readClock();
    /// True when the camera took the order.
    bool fireTrigger();
    /// Reads the exposure again, after it was set.
    void readExposure();

private:
    AravisDevice(AravisLocation location, ArvPointer<ArvCamera> camera);
    std::optional<ClockReading> readClockOnce();
    Result<void> setUp(const AravisAddress &wanted);
    Result<void> chooseFormat(const AravisAddress &wanted);
    Result<void> chooseSize(const AravisAddress &wanted);
    Result<void> choosePace(const AravisAddress &wanted);
    Result<void> setUpTransport(const AravisAddress &wanted);
    Result<void> readBack(const AravisAddress &wanted);
    tl::unexpected<Error> refused(const AravisAddress &wanted, Message why, const ArvFailure &failure) const;

    AravisLocation m_location;
    ArvPointer<ArvCamera> m_camera;
    AravisMode m_mode;
    enum class Latch { None, Gige, Sfnc };
    Latch m_latch = Latch::None;
    std::int64_t m_ticksPerSecond = 0;
};

} // namespace odo
