// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/v4l2/v4l2_mode.h"
#include "core/capture/v4l2/v4l2_stamps.h"

#include <memory>
#include <span>
#include <vector>

struct v4l2_pix_format;

namespace odo {

/// A camera that delivers into buffers that are shared with its driver; a third of a second of them, so that
/// who takes the pictures may be late. Stops with its end. One thread.
class V4l2Stream
{
public:
    struct Buffer
    {
        unsigned index = 0;
        std::span<const std::uint8_t> bytes; ///< until giveBack()
        V4l2BufferStamp stamp;
        bool isDamaged = false; ///< by the driver's own word
    };

    /// Sets the mode and starts. Errors: those of v4l2Failure, EBUSY and ENOSPC above all; Unavailable when
    /// the camera takes another format.
    static Result<std::unique_ptr<V4l2Stream>> start(std::shared_ptr<V4l2Device> device, const V4l2Mode &mode,
                                                     const std::string &uri);
    ~V4l2Stream();
    V4l2Stream(const V4l2Stream &) = delete;
    V4l2Stream &operator=(const V4l2Stream &) = delete;

    const v4l2_pix_format &format() const { return *m_format; }
    int descriptor() const { return m_device->descriptor(); }
    double framesPerSecond() const { return m_framesPerSecond; } ///< as the driver has set it
    /// The oldest full buffer, or the errno: EAGAIN where none is full, ENODEV unplugged, EIO the stream has
    /// broken.
    int take(Buffer &taken);
    /// 0 or the errno.
    int giveBack(unsigned index);

private:
    V4l2Stream(std::shared_ptr<V4l2Device> device);
    int setMode(const V4l2Mode &mode);
    int makeBuffers();

    const std::shared_ptr<V4l2Device> m_device;
    std::unique_ptr<v4l2_pix_format> m_format;
    double m_framesPerSecond = 0;
    std::vector<std::span<std::uint8_t>> m_buffers; ///< mapped
};

} // namespace odo
