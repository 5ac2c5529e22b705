// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace odo {

/// An IPv4 address as a number: 127.0.0.1 is 0x7f000001. Nothing of what is none. Any thread.
std::optional<std::uint32_t> ipv4Address(const std::string &text);
/// The names of this machine's network interfaces; none where the system does not say. Any thread.
std::vector<std::string> networkInterfaceNames();

/// Sends packets over the network (UDP on IPv4), open as long as it lives. One thread at a time.
class DatagramSocket
{
public:
    static SystemResult<DatagramSocket> open();
    ~DatagramSocket();
    DatagramSocket(DatagramSocket &&other) noexcept;
    DatagramSocket &operator=(DatagramSocket &&) = delete;

    /// Multicast leaves by this interface, is heard on this machine too, and goes no further than the network
    /// here. std::errc::no_such_device where there is no such interface; the system's reason where it takes
    /// no multicast.
    std::error_code sendMulticastBy(const std::string &interfaceName) const;
    /// Never waits. Whether the system took all of it.
    bool send(std::string_view packet, std::uint32_t address, std::uint16_t port) const;

private:
    explicit DatagramSocket(std::intptr_t number) : m_number(number) {}

    std::intptr_t m_number; ///< the system's; below zero: moved away
};

} // namespace odo
