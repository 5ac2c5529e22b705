// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>
#include <arpa/inet.h>
#include <cstdint>
#include <net/if.h>
#include <netinet/in.h>
#include <string>
#include <sys/socket.h>
#include <unistd.h>

namespace odo::test {

/// Hears a port of the loopback, on a multicast group or its own address.
class DatagramReceiver
{
public:
    explicit DatagramReceiver(bool isMulticast) : m_socket(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0))
    {
        sockaddr_in own{};
        own.sin_family = AF_INET;
        own.sin_addr.s_addr = isMulticast ? inet_addr(group) : htonl(INADDR_LOOPBACK);
        if (bind(m_socket, reinterpret_cast<sockaddr *>(&own), sizeof own) != 0) // any port that is free
            qFatal("no port");
        socklen_t length = sizeof own;
        getsockname(m_socket, reinterpret_cast<sockaddr *>(&own), &length);
        port = ntohs(own.sin_port);
        ip_mreqn membership{};
        membership.imr_multiaddr.s_addr = inet_addr(group);
        membership.imr_ifindex = static_cast<int>(if_nametoindex("lo"));
        if (isMulticast &&
            setsockopt(m_socket, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) != 0)
            qFatal("no multicast on the loopback");
        const timeval patience{10, 0};
        setsockopt(m_socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    }
    ~DatagramReceiver() { close(m_socket); }
    /// The next packet; empty after ten seconds without one.
    std::string next() const
    {
        char bytes[4096];
        const auto size = recv(m_socket, bytes, sizeof bytes, 0);
        return size > 0 ? std::string(bytes, std::size_t(size)) : std::string();
    }
    std::uint16_t port = 0;

private:
    static constexpr const char *group = "224.5.23.2";
    int m_socket;
};

} // namespace odo::test
