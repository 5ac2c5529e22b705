// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/platform/datagram_socket.h"

#include <arpa/inet.h>
#include <cerrno>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

namespace odo {

std::optional<std::uint32_t> ipv4Address(const std::string &text)
{
    in_addr address{};
    return ::inet_pton(AF_INET, text.c_str(), &address) == 1 ? std::optional(ntohl(address.s_addr))
                                                             : std::nullopt;
}

std::vector<std::string> networkInterfaceNames()
{
    std::vector<std::string> names;
    if (struct if_nameindex *all = ::if_nameindex()) {
        for (const struct if_nameindex *one = all; one->if_index != 0; ++one)
            names.emplace_back(one->if_name);
        ::if_freenameindex(all);
    }
    return names;
}

SystemResult<DatagramSocket> DatagramSocket::open()
{
    const int number = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (number < 0)
        return tl::unexpected(std::error_code(errno, std::generic_category()));
    return DatagramSocket(number);
}

DatagramSocket::DatagramSocket(DatagramSocket &&other) noexcept : m_number(std::exchange(other.m_number, -1))
{
}

DatagramSocket::~DatagramSocket()
{
    if (m_number >= 0)
        ::close(static_cast<int>(m_number));
}

std::error_code DatagramSocket::sendMulticastBy(const std::string &interfaceName) const
{
    const int number = static_cast<int>(m_number);
    const auto set = [number](int option, const auto &value) {
        return ::setsockopt(number, IPPROTO_IP, option, &value, sizeof value) == 0;
    };
    ip_mreqn by{};
    by.imr_ifindex = static_cast<int>(::if_nametoindex(interfaceName.c_str()));
    const unsigned char hops = 1, heardHere = 1;
    if (by.imr_ifindex == 0)
        return std::make_error_code(std::errc::no_such_device);
    if (!set(IP_MULTICAST_IF, by) || !set(IP_MULTICAST_TTL, hops) || !set(IP_MULTICAST_LOOP, heardHere))
        return {errno, std::generic_category()};
    return {};
}

bool DatagramSocket::send(std::string_view packet, std::uint32_t address, std::uint16_t port) const
{
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(address);
    return ::sendto(static_cast<int>(m_number), packet.data(), packet.size(), 0,
                    reinterpret_cast<const sockaddr *>(&to),
                    sizeof to) == static_cast<ssize_t>(packet.size());
}

} // namespace odo
