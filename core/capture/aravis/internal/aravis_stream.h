// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/aravis/internal/aravis_device.h"

namespace odo {

/// A frame that came whole, with the camera's own number and clock.
struct AravisFrame
{
    Frame frame;
    std::uint64_t id = 0;
    Nanoseconds stamp{0};   ///< by the camera's clock
    Nanoseconds arrival{0}; ///< when its first packet came, by this machine's steady clock
};

/// The frames of an open camera, from start to stop. On the thread of its device, which outlives it.
class AravisStream
{
public:
    /// Errors: Unavailable.
    static Result<std::unique_ptr<AravisStream>> start(AravisDevice &device, const AravisAddress &address);
    ~AravisStream();
    AravisStream(const AravisStream &) = delete;
    AravisStream &operator=(const AravisStream &) = delete;

    /// Waits for a frame; those that did not come whole are counted. nullopt when none came in time.
    std::optional<AravisFrame> next(Nanoseconds patience);

    std::uint64_t damaged() const { return m_damaged; }
    std::uint64_t resent() const;
    /// Grows with each frame that came while none of our buffers was free, perhaps by more than one.
    std::uint64_t unbuffered() const;
    /// Why frames may come incomplete, where this machine is the cause; empty otherwise.
    const Message &warning() const { return m_warning; }
    /// The camera is gone: do not ask it to stop, which would take seconds.
    void abandon() { m_abandoned = true; }

private:
    AravisStream(AravisDevice &device, ArvPointer<ArvStream> stream);
    void enlargeReceiveBuffer();
    std::optional<AravisFrame> frameIn(ArvBuffer *buffer);

    AravisDevice &m_device;
    ArvPointer<ArvStream> m_stream;
    std::uint64_t m_damaged = 0;
    Message m_warning;
    bool m_abandoned = false;
};

} // namespace odo
