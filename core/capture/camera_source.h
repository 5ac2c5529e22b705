// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/video/frame.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace odo {

/// A picture as a camera delivered it.
struct CapturedFrame
{
    Frame frame;                ///< time: by the camera's own clock, since its first picture
    std::uint64_t sequence = 0; ///< the camera's count; a gap is a picture that was lost
    Nanoseconds hostTime{0};    ///< when it arrived, by this machine's steady clock
};

/// What a source is, as it is shown to a person.
struct CameraDescription
{
    std::string uri;  ///< what openCamera takes
    std::string kind; ///< "simulated", "file"
    std::string name;
    int widthPx = 0, heightPx = 0;
    double framesPerSecond = 0;
    std::string serial; ///< empty where it has none
};

/// A camera, or what stands for one. One thread calls next(); stop() may be called from any.
class CameraSource
{
public:
    virtual ~CameraSource() = default;
    virtual const CameraDescription &description() const = 0;
    /// Waits for the next picture. Errors: Cancelled after stop(); Io where the camera is lost or a file has ended.
    virtual Result<CapturedFrame> next() = 0;
    virtual void stop() = 0;
};

/// By address: "sim:A" and "sim:B" are the cameras of the demo's testbed, "sim:A?board" the same while somebody holds a
/// calibration board before it; "file:PATH" plays a video at its own pace. Errors: NotFound for anything else, and
/// those of VideoReader.
Result<std::unique_ptr<CameraSource>> openCamera(const std::string &uri);

/// The cameras that can be opened now.
std::vector<CameraDescription> listCameras();

} // namespace odo
