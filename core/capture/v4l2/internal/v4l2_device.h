// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/camera_source.h"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace odo {

/// By what a camera is known again, wherever its node is.
struct V4l2Identity
{
    std::string driver, name;
    std::string busInfo; ///< the port it is plugged in at: "usb-0000:00:14.0-1"
    std::string serial;  ///< of the USB device; empty where it has none
    std::string index;   ///< which of its nodes it is: a camera may have one in colour and one in infrared
};

/// An open V4L2 node that captures video. Its calls may come from any thread; it is closed with its last
/// share.
class V4l2Device
{
public:
    /// Errors: those of v4l2Failure; InvalidInput for a node that does not capture video (a webcam has one
    /// for metadata too).
    static Result<std::shared_ptr<V4l2Device>> open(const std::filesystem::path &node,
                                                    const std::string &uri);
    ~V4l2Device();
    V4l2Device(const V4l2Device &) = delete;
    V4l2Device &operator=(const V4l2Device &) = delete;

    /// ioctl, again when a signal interrupts it. 0 or the errno.
    int call(unsigned long request, void *argument) const;
    int descriptor() const { return m_descriptor; }
    const std::filesystem::path &node() const { return m_node; }
    const V4l2Identity &identity() const { return m_identity; }
    /// Another program has taken its buffers; found out without changing anything.
    bool isBusy() const;

private:
    V4l2Device(std::filesystem::path node, int descriptor) : m_node(std::move(node)), m_descriptor(descriptor)
    {
    }

    const std::filesystem::path m_node;
    const int m_descriptor;
    V4l2Identity m_identity;
};

/// All nodes that capture video and may be opened, in the order of their numbers.
std::vector<std::shared_ptr<V4l2Device>> openV4l2Devices();

/// What a failed call to a camera means for its user. NotFound: no such node; Io: no permission; Unavailable:
/// everything that may pass (used by another program, unplugged, no bandwidth left on the USB bus, a
/// failure).
Error v4l2Failure(const std::string &uri, int errorNumber);
/// The same; of one that another program uses, the programs that have it open are named where the kernel
/// reports them.
Error v4l2Failure(const V4l2Device &device, const std::string &uri, int errorNumber);

/// What was set at a camera, to be set again when it comes back: ids and values, in their order.
using V4l2Settings = std::vector<std::pair<std::string, double>>;

/// All that can be set and has one value; texts and tables are left out. A button is a Boolean that is never
/// on. Ids are the names in lower case with underscores, as v4l2-ctl writes them. Errors: those of
/// v4l2Failure.
Result<std::vector<CameraControl>> v4l2Controls(const V4l2Device &device, const std::string &uri);

/// Errors: as CameraSource::set.
Result<void> setV4l2Control(const V4l2Device &device, const std::string &uri, const std::string &id,
                            double value);

/// As CameraSource::holdAutomatics.
struct V4l2Held
{
    V4l2Settings settings;        ///< what was set for it
    V4l2Settings automatics;      ///< those that were on, with their values
    std::vector<Message> stillOn; ///< names of what could not be turned off
};
V4l2Held holdV4l2Automatics(const V4l2Device &device, const std::string &uri);

} // namespace odo
