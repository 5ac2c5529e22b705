// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/aravis/internal/gvcp.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>

namespace odo {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint16_t controlPort = 3956;
constexpr std::size_t headerSize = 8;
constexpr std::chrono::seconds discoveryPatience{1};
// Key, flags (answer requested), command, length, and the number of the request.
constexpr std::array<std::uint8_t, 8> discoveryQuestion{0x42, 0x01, 0x00, 0x02, 0x00, 0x00, 0xff, 0xfe};
constexpr std::array<std::uint8_t, 12> privilegeQuestion{0x42, 0x01, 0x00, 0x80, 0x00, 0x04,
                                                         0xff, 0xfd, 0x00, 0x00, 0x0a, 0x00};
constexpr std::uint8_t discoveryAnswer = 0x03, readAnswer = 0x81;
// Places in a discovery's answer: of the bootstrap registers.
constexpr std::size_t vendorAt = 0x48, modelAt = 0x68, serialAt = 0xd8, nameSize = 32, serialSize = 16,
                      discoverySize = 0xf8;

class UdpSocket
{
public:
    UdpSocket() : m_handle(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
    ~UdpSocket()
    {
        if (m_handle >= 0)
            close(m_handle);
    }
    UdpSocket(const UdpSocket &) = delete;
    UdpSocket &operator=(const UdpSocket &) = delete;

    int handle() const { return m_handle; }
    bool send(std::span<const std::uint8_t> bytes, const sockaddr_in &to) const
    {
        return sendto(m_handle, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr *>(&to),
                      sizeof to) == static_cast<ssize_t>(bytes.size());
    }

private:
    int m_handle;
};

sockaddr_in nameOf(in_addr address, std::uint16_t port)
{
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_port = htons(port);
    name.sin_addr = address;
    return name;
}

using Answer = std::array<std::uint8_t, 576>;

/// The text of a fixed field, without what is behind its end.
std::string fieldOf(const Answer &answer, std::size_t at, std::size_t size)
{
    const auto *text = reinterpret_cast<const char *>(answer.data() + headerSize + at);
    return std::string(text, strnlen(text, size));
}

std::optional<GvcpCamera> cameraIn(const Answer &answer, ssize_t size, in_addr from)
{
    if (size < static_cast<ssize_t>(headerSize + discoverySize) || answer[0] != 0 ||
        answer[3] != discoveryAnswer)
        return std::nullopt;
    std::array<char, INET_ADDRSTRLEN> address{};
    inet_ntop(AF_INET, &from, address.data(), address.size());
    return GvcpCamera{address.data(), fieldOf(answer, vendorAt, nameSize), fieldOf(answer, modelAt, nameSize),
                      fieldOf(answer, serialAt, serialSize)};
}

bool waitReadable(int handle, Clock::time_point until)
{
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
    pollfd waiting{handle, POLLIN, 0};
    return poll(&waiting, 1, static_cast<int>(std::max<std::int64_t>(0, left.count()))) > 0;
}

/// Asks one address. Who refuses (nobody listens there) is known at once. Less than 0 without an answer.
ssize_t ask(const std::string &address, std::span<const std::uint8_t> question,
            std::chrono::milliseconds patience, Answer &answer)
{
    in_addr ip{};
    if (inet_pton(AF_INET, address.c_str(), &ip) != 1)
        return -1;
    const UdpSocket socket;
    const sockaddr_in name = nameOf(ip, controlPort);
    if (connect(socket.handle(), reinterpret_cast<const sockaddr *>(&name), sizeof name) != 0 ||
        ::send(socket.handle(), question.data(), question.size(), 0) < 0)
        return -1;
    if (!waitReadable(socket.handle(), Clock::now() + patience))
        return -1;
    return recv(socket.handle(), answer.data(), answer.size(), MSG_DONTWAIT);
}

/// The addresses of this machine's networks that are up.
std::vector<in_addr> ownAddresses()
{
    std::vector<in_addr> addresses;
    ifaddrs *first = nullptr;
    if (getifaddrs(&first) != 0)
        return addresses;
    for (const ifaddrs *one = first; one; one = one->ifa_next) {
        if (one->ifa_addr && one->ifa_addr->sa_family == AF_INET && (one->ifa_flags & IFF_UP))
            addresses.push_back(reinterpret_cast<const sockaddr_in *>(one->ifa_addr)->sin_addr);
    }
    freeifaddrs(first);
    return addresses;
}

/// Sends the question out into one network; false where that cannot be.
bool broadcastFrom(const UdpSocket &socket, in_addr own)
{
    const int yes = 1;
    const sockaddr_in name = nameOf(own, 0);
    return setsockopt(socket.handle(), SOL_SOCKET, SO_BROADCAST, &yes, sizeof yes) == 0 &&
           bind(socket.handle(), reinterpret_cast<const sockaddr *>(&name), sizeof name) == 0 &&
           socket.send(discoveryQuestion, nameOf(in_addr{htonl(INADDR_BROADCAST)}, controlPort));
}

void receiveAll(const UdpSocket &socket, std::vector<GvcpCamera> &cameras)
{
    Answer answer{};
    sockaddr_in from{};
    for (;;) {
        socklen_t length = sizeof from;
        const ssize_t size = recvfrom(socket.handle(), answer.data(), answer.size(), MSG_DONTWAIT,
                                      reinterpret_cast<sockaddr *>(&from), &length);
        if (size < 0)
            return;
        const auto camera = cameraIn(answer, size, from.sin_addr);
        if (camera && std::ranges::find(cameras, camera->address, &GvcpCamera::address) == cameras.end())
            cameras.push_back(*camera);
    }
}

} // namespace

bool isIpAddress(const std::string &text)
{
    in_addr ip{};
    return inet_pton(AF_INET, text.c_str(), &ip) == 1;
}

std::optional<GvcpCamera> askGvcpCamera(const std::string &address, std::chrono::milliseconds patience)
{
    Answer answer{};
    in_addr ip{};
    const ssize_t size = ask(address, discoveryQuestion, patience, answer);
    if (size < 0 || inet_pton(AF_INET, address.c_str(), &ip) != 1)
        return std::nullopt;
    return cameraIn(answer, size, ip);
}

std::optional<bool> isGvcpControlled(const std::string &address, std::chrono::milliseconds patience)
{
    Answer answer{};
    const ssize_t size = ask(address, privilegeQuestion, patience, answer);
    if (size < static_cast<ssize_t>(headerSize + 4) || answer[0] != 0 || answer[3] != readAnswer)
        return std::nullopt;
    constexpr std::uint8_t exclusiveOrControl = 3;
    return (answer[headerSize + 3] & exclusiveOrControl) != 0;
}

std::vector<GvcpCamera> discoverGvcpCameras()
{
    std::vector<GvcpCamera> cameras;
    std::vector<std::unique_ptr<UdpSocket>> sockets;
    std::vector<pollfd> waiting;
    for (const in_addr own : ownAddresses()) {
        auto socket = std::make_unique<UdpSocket>();
        if (!broadcastFrom(*socket, own))
            continue;
        waiting.push_back({socket->handle(), POLLIN, 0});
        sockets.push_back(std::move(socket));
    }
    const Clock::time_point end = Clock::now() + discoveryPatience;
    while (!sockets.empty() && Clock::now() < end) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
        if (poll(waiting.data(), waiting.size(), static_cast<int>(left.count())) <= 0)
            break;
        for (const auto &socket : sockets)
            receiveAll(*socket, cameras);
    }
    std::ranges::sort(cameras, {}, &GvcpCamera::address);
    return cameras;
}

} // namespace odo
