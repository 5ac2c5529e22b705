// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <QTemporaryDir>

#include <atomic>
#include <cstdint>
#include <linux/videodev2.h>
#include <mutex>
#include <optional>
#include <string>

namespace odo::test {

/// A webcam as its driver shows it, played on this side of the kernel: a test that links played_driver.cpp
/// gives ioctl, and what the kernel tells of nodes, itself. For what neither real hardware nor an emulated
/// machine can be brought to do at will. One at a time, YUYV of 64×48 pixels, 30 a second; for one source,
/// whose two threads may call at once.
class PlayedDriver
{
public:
    PlayedDriver();
    ~PlayedDriver();
    PlayedDriver(const PlayedDriver &) = delete;
    PlayedDriver &operator=(const PlayedDriver &) = delete;

    std::string uri() const { return "v4l2:" + m_node; }

    std::atomic<int> streamOnFailure = 0;  ///< the errno with which the camera does not start
    std::atomic<bool> isUnplugged = false; ///< as long as it is, it is not listed either
    std::atomic<int> framesPerSecond = 30; ///< that it really takes

    /// What ioctl does with its node: 0 or the errno.
    int call(unsigned long request, void *argument);
    const std::string &node() const { return m_node; }
    static PlayedDriver *atDescriptor(int descriptor);
    static PlayedDriver *present();

    static constexpr unsigned width = 64, height = 48, rate = 30;

private:
    int describe(unsigned long request, void *argument);
    int stream(unsigned long request, void *argument);
    int giveOut(v4l2_buffer &buffer);

    QTemporaryDir m_folder;
    std::string m_node;
    int m_memory; ///< the node's file, in which the buffers lie

    std::mutex m_mutex;               ///< guards what follows
    std::optional<Nanoseconds> m_due; ///< the next picture, by CLOCK_MONOTONIC; none: it does not stream
    std::uint32_t m_sequence = 0, m_buffers = 0;
    std::vector<std::uint32_t> m_free;
};

} // namespace odo::test
