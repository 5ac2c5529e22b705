// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/simulation/demo_testbed.h"
#include "core/video/frame.h"
#include "core/video/frame_times.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// A frame as a camera delivered it.
struct CapturedFrame
{
    Frame frame;                ///< time: by the camera's own clock, since its first frame
    std::uint64_t sequence = 0; ///< the camera's count; a gap is a lost frame
    Nanoseconds hostTime{0};    ///< when it arrived, by this machine's steady clock
    /// Where the camera codes its frames itself: the JPEG file as it came, complete with its tables. It is
    /// what is recorded.
    std::shared_ptr<const std::vector<std::uint8_t>> jpeg = {};
    /// on the same time scale as frame.time, where the camera can be asked
    std::optional<ClockReading> clock = {};
    /// of the gap before it: came, and were thrown away because nobody took them in time
    std::uint64_t lostHere = 0;
};

/// A kind of frame that a camera offers.
struct CameraFormat
{
    Message words;           ///< "MJPG 1280×720 at 30 frames/s", or why the camera cannot be used
    std::string coding = {}; ///< as the camera names it; empty where it cannot be chosen
    int widthPx = 0, heightPx = 0;
};

/// What a source is, as it is shown to a person.
struct CameraDescription
{
    std::string uri;  ///< what openCamera takes
    std::string kind; ///< "simulated", "file", "v4l2", "aravis"
    Message name;
    int widthPx = 0, heightPx = 0;
    double framesPerSecond = 0;
    std::string serial = {};                ///< empty where it has none
    std::vector<CameraFormat> formats = {}; ///< the best first
    bool busy = false;                      ///< another program holds it
};

/// What a source has counted since it was opened. Gaps in CapturedFrame::sequence are counted by who takes
/// the frames.
struct CameraCounts
{
    /// arrived incomplete and were thrown away; each leaves a gap in the sequence
    std::uint64_t damaged = 0;
    std::uint64_t resent = 0;        ///< packets that came only when asked for again
    std::uint64_t reconnections = 0; ///< how often it was lost and taken up again
};

/// Something that can be set at a camera, as the camera names it.
struct CameraControl
{
    enum class Kind { Integer, Real, Boolean, Choice };
    std::string id;   ///< for set()
    std::string name; ///< for people
    Kind kind = Kind::Integer;
    double minimum = 0, maximum = 0, step = 0, value = 0, standard = 0; ///< of Choice: places in choices
    std::vector<std::string> choices;
    std::string unit;
    bool readOnly = false; ///< cannot be set, or not with the current values of other controls
};

/// A camera, or what stands for one. One thread calls next(); everything else may be called from any thread.
class CameraSource
{
public:
    virtual ~CameraSource() = default;
    virtual const CameraDescription &description() const = 0;
    /// Waits for the next frame. Errors: Unavailable when none came for half a second, with the cause as
    /// far as it is known: call again, the source reconnects to its camera as soon as it can, with its
    /// settings, and the time scale goes on; Cancelled after stop(); Io where nothing more will come (a file
    /// has ended). Another camera at its port: Unavailable.
    virtual Result<CapturedFrame> next() = 0;
    virtual void stop() = 0;

    virtual CameraCounts counts() const { return {}; }
    /// The controls with their current values. Errors: Unavailable.
    virtual Result<std::vector<CameraControl>> controls() { return std::vector<CameraControl>{}; }
    /// Errors: NotFound without such a control; InvalidInput out of its bounds or read-only; Unavailable.
    virtual Result<void> set(const std::string &id, double value);
    /// Turns off whatever changes image or rate automatically (exposure, gain, white balance, focus), each
    /// held where it is now, so that colour and timing hold while recording. Gives the names of what could
    /// not be turned off.
    virtual std::vector<Message> holdAutomatics() { return {}; }
    /// Gives them back: what holdAutomatics has turned off is on again, at once or when the camera is back.
    /// Does nothing where nothing is held.
    virtual void releaseAutomatics() {}
    /// The robots that a simulated camera shows from its next frame on; none given: its own. Other cameras
    /// show what is before them.
    virtual void showRobots(const std::vector<RobotAppearance> &) {}
};

/// "MJPG 1280×720 at 30 frames/s"; the coding may be left out.
Message formatWords(const std::string &coding, int widthPx, int heightPx, double framesPerSecond);

/// By address: "sim:A" and "sim:B" are the cameras of the demo's testbed, where robots drive circles
/// (showRobots), "sim:A?board" the same while somebody holds a calibration board before it; "file:PATH" plays
/// a video at its own pace; "v4l2:/dev/video0" is a USB camera (core/capture/v4l2/ v4l2_address.h);
/// "aravis:192.168.1.20" and "aravis:SERIAL" are GigE Vision and USB3 Vision cameras (core/capture/aravis/
/// aravis_address.h), which take up to two seconds to open. Errors: NotFound for anything else, those of
/// VideoReader, of openV4l2Source and of openAravisSource.
Result<std::unique_ptr<CameraSource>> openCamera(const std::string &uri);

/// The cameras that can be opened now. Those on a network have a second to answer: takes up to two seconds,
/// so never on a window's thread.
std::vector<CameraDescription> listCameras();

/// One of the parts behind the '?' of a camera's address: "rate=30". Without a '=' it has no name.
struct CameraSetting
{
    std::string text; ///< as it was written
    std::string name, value;
};

/// A camera's address taken apart: "SCHEME:PLACE?a=1&b=2".
struct CameraUri
{
    std::string location; ///< empty where the address says none
    std::vector<CameraSetting> cameraSettings =
        {}; ///< in their order; which of them are understood is for the kind of camera
};

/// scheme: with its colon; the address must begin with it.
CameraUri splitCameraUri(std::string_view uri, std::string_view scheme);

/// Which camera an address means, without its settings: "v4l2:/dev/video0".
std::string withoutSettings(const std::string &uri);
/// With these in place of whatever the address wanted before.
std::string withSettings(const std::string &uri, const std::vector<CameraSetting> &cameraSettings);
/// USB and network cameras: others are what they are.
bool acceptsSettings(const std::string &uri);

/// Stands for a camera that could not be opened, so that others can run without it: opens it, again and again
/// on a thread of its own, until it is there, and is that camera from then on. Until then next() says
/// Unavailable, with the reason that the last attempt gave. An address that is not understood (InvalidInput)
/// is not tried again. The destructor waits for an attempt in progress.
std::unique_ptr<CameraSource> awaitCamera(const std::string &uri, Error why,
                                          std::function<Result<std::unique_ptr<CameraSource>>()> open,
                                          Nanoseconds betweenAttempts = std::chrono::seconds(2));

/// One frame of a camera that was just opened, as soon as it has settled: the first ones of a webcam are
/// dark, its exposure is being found. Takes half a second at least; waits some three seconds
/// for a camera that is missing. Any thread. Errors: those of the camera; Cancelled.
Result<Frame> settledFrame(CameraSource &camera, const JobControl &control);

/// What errors of a camera are about: "camera v4l2:/dev/video0".
Message cameraAtAddress(const std::string &uri);

/// InvalidInput: a part of an address.
tl::unexpected<Error> notUnderstood(const std::string &uri, const std::string &part, Message advice);
/// NotFound, for CameraSource::set.
tl::unexpected<Error> noSuchControl(const std::string &uri, const std::string &id);

/// Within what bounds a control can be set.
Message controlGoes(const std::string &name, MessageArgument from, MessageArgument to);

Message usedByAnotherProgram();
Message closeThatProgram();
Message notRegisteredToFloor();

} // namespace odo
