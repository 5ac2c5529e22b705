// SPDX-License-Identifier: GPL-3.0-or-later
// The control channel of a simulated camera (GVCP; GigE Vision 2.0, 14 to 18).
#include "tests/support/gige/genicam_description.h"
#include "tests/support/gige/simulated_gige_camera.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <stdexcept>

namespace odo::test {

namespace {

constexpr std::uint16_t controlPort = 3956;
constexpr std::size_t headerSize = 8;
constexpr std::uint8_t key = 0x42;
enum Command : std::uint16_t {
    Discovery = 0x0002,
    PacketResend = 0x0040,
    ReadRegister = 0x0080,
    WriteRegister = 0x0082,
    ReadMemory = 0x0084,
    WriteMemory = 0x0086
};
enum Status : std::uint16_t {
    Success = 0,
    NotImplemented = 0x8001,
    InvalidAddress = 0x8003,
    WriteProtected = 0x8004,
    AccessDenied = 0x8006
};
constexpr std::size_t discoverySize = 0xf8;
constexpr std::uint32_t privilegeBits = 3, latchBit = 2, resetBit = 1, fireTestBit = 0x80000000u;

int boundSocket(const char *address, std::uint16_t port, bool shared)
{
    const int handle = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    const int yes = 1;
    if (shared)
        setsockopt(handle, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_port = htons(port);
    inet_pton(AF_INET, address, &name.sin_addr);
    if (bind(handle, reinterpret_cast<const sockaddr *>(&name), sizeof name) != 0)
        throw std::runtime_error(std::string("simulated camera at ") + address + ": " + std::strerror(errno));
    return handle;
}

bool isSame(const sockaddr_in &a, const sockaddr_in &b)
{
    return a.sin_addr.s_addr == b.sin_addr.s_addr && a.sin_port == b.sin_port;
}

} // namespace

SimulatedGigeCamera::SimulatedGigeCamera(Settings settings, Painter painter)
    : m_settings(std::move(settings)), m_painter(std::move(painter)),
      m_control(boundSocket(m_settings.address.c_str(), controlPort, false)),
      m_broadcast(boundSocket("255.255.255.255", controlPort, true)),
      m_data(boundSocket(m_settings.address.c_str(), 0, false)),
      m_clock(m_settings.clockOffsetS, m_settings.clockPpm, m_settings.ticksPerSecond, steadyNow()),
      m_lastId(static_cast<std::uint16_t>(m_settings.firstId - 1)), m_random(m_settings.seed)
{
    setUpRegisters();
    m_controlThread = std::thread([this] { answerControl(); });
    m_streamThread = std::thread([this] { stream(); });
}

SimulatedGigeCamera::~SimulatedGigeCamera()
{
    {
        const std::lock_guard lock(m_mutex);
        m_stopped = true;
    }
    m_wake.notify_all();
    m_controlThread.join();
    m_streamThread.join();
    for (const int handle : {m_control, m_broadcast, m_data})
        close(handle);
}

void SimulatedGigeCamera::setUpRegisters()
{
    in_addr address{};
    inet_pton(AF_INET, m_settings.address.c_str(), &address);
    const std::string xml = genicamDescription({m_settings.timestampLatch, m_settings.automatics});
    std::array<char, 64> url{};
    std::snprintf(url.data(), url.size(), "Local:simulated.xml;%x;%zx", unsigned{reg::XmlText}, xml.size());
    GigeRegisters &r = m_registers;
    r.set(reg::Version, 0x00020000);
    r.set(reg::DeviceMode, 0x80000001); // big-endian, UTF-8
    r.set(reg::MacHigh, 0x0200);
    r.set(reg::MacLow, ntohl(address.s_addr)); // unlike that of any other address
    r.set(reg::IpConfiguration, 5);
    r.set(reg::Ip, ntohl(address.s_addr));
    r.setText(reg::Vendor, "Odograph");
    r.setText(reg::Model, m_settings.model);
    r.setText(reg::DeviceVersion, "1");
    r.setText(reg::Serial, m_settings.serial);
    r.setText(reg::XmlUrl, url.data());
    r.setText(reg::XmlText, xml);
    r.set(reg::Interfaces, 1);
    r.set(reg::StreamChannels, 1);
    r.set(reg::Capability, (m_settings.answersResends ? 4u : 0u) | 2u);
    r.set(reg::HeartbeatTimeout, static_cast<std::uint32_t>(m_settings.heartbeat.count()));
    r.set(reg::TickFrequencyHigh, static_cast<std::uint32_t>(m_settings.ticksPerSecond >> 32));
    r.set(reg::TickFrequencyLow, static_cast<std::uint32_t>(m_settings.ticksPerSecond));
    r.set(reg::PacketSize, 1400);
    r.set(reg::SensorWidth, static_cast<std::uint32_t>(m_settings.sensorWidth));
    r.set(reg::SensorHeight, static_cast<std::uint32_t>(m_settings.sensorHeight));
    r.set(reg::Width, static_cast<std::uint32_t>(m_settings.sensorWidth));
    r.set(reg::Height, static_cast<std::uint32_t>(m_settings.sensorHeight));
    r.set(reg::PixelFormat, m_settings.pixelFormat);
    r.setFloat(reg::FrameRate, static_cast<float>(m_settings.framesPerSecond));
    r.setFloat(reg::ExposureTime, static_cast<float>(m_settings.exposureS * 1e6));
    const std::uint32_t continuous = 2;
    r.set(reg::ExposureAuto, m_settings.automatics ? continuous : 0);
    r.set(reg::GainAuto, m_settings.automatics ? continuous : 0);
    updatePayload();
}

void SimulatedGigeCamera::updatePayload()
{
    const std::uint32_t bytesPerPixel = (m_registers.get(reg::PixelFormat) >> 16 & 0xff) / 8;
    m_registers.set(reg::Payload, m_registers.get(reg::Width) * m_registers.get(reg::Height) * bytesPerPixel);
}

void SimulatedGigeCamera::resetClock()
{
    const std::lock_guard lock(m_mutex);
    m_clock.reset(steadyNow());
}

bool SimulatedGigeCamera::isControlled() const
{
    const std::lock_guard lock(m_mutex);
    return m_controller.has_value();
}

std::uint32_t SimulatedGigeCamera::read(std::uint32_t address) const
{
    const std::lock_guard lock(m_mutex);
    return m_registers.get(address);
}

float SimulatedGigeCamera::readFloat(std::uint32_t address) const
{
    const std::lock_guard lock(m_mutex);
    return m_registers.getFloat(address);
}

void SimulatedGigeCamera::answerControl()
{
    for (;;) {
        std::array<pollfd, 2> waiting{{{m_control, POLLIN, 0}, {m_broadcast, POLLIN, 0}}};
        poll(waiting.data(), waiting.size(), 20);
        {
            const std::lock_guard lock(m_mutex);
            if (m_stopped)
                return;
            if (m_controller &&
                steadyNow() - m_lastHeard > std::chrono::milliseconds(m_registers.get(reg::HeartbeatTimeout)))
                releaseControl();
        }
        for (const pollfd &one : waiting) {
            if (one.revents & POLLIN)
                answer(one.fd);
        }
    }
}

void SimulatedGigeCamera::answer(int socket)
{
    std::array<std::uint8_t, 2048> bytes{};
    sockaddr_in from{};
    socklen_t length = sizeof from;
    const ssize_t size = recvfrom(socket, bytes.data(), bytes.size(), MSG_DONTWAIT,
                                  reinterpret_cast<sockaddr *>(&from), &length);
    if (size < static_cast<ssize_t>(headerSize) || bytes[0] != key || muteControl)
        return;
    const std::lock_guard lock(m_mutex);
    handle({bytes.data(), static_cast<std::size_t>(size)}, from);
}

void SimulatedGigeCamera::acknowledge(const sockaddr_in &to, std::uint16_t status, std::uint16_t command,
                                      std::uint16_t id, std::span<const std::uint8_t> content)
{
    std::vector<std::uint8_t> bytes(headerSize);
    writeBig16(&bytes[0], status);
    writeBig16(&bytes[2], static_cast<std::uint16_t>(command + 1));
    writeBig16(&bytes[4], static_cast<std::uint16_t>(content.size()));
    writeBig16(&bytes[6], id);
    bytes.insert(bytes.end(), content.begin(), content.end());
    sendto(m_control, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr *>(&to), sizeof to);
}

bool SimulatedGigeCamera::mayWrite(const sockaddr_in &from) const
{
    return !m_controller || isSame(*m_controller, from);
}

void SimulatedGigeCamera::handle(std::span<const std::uint8_t> message, const sockaddr_in &from)
{
    const std::uint16_t command = readBig16(&message[2]), id = readBig16(&message[6]);
    const std::span<const std::uint8_t> content = message.subspan(headerSize);
    if (m_controller && isSame(*m_controller, from))
        m_lastHeard = steadyNow();
    const auto reply = [&](std::uint16_t status, std::span<const std::uint8_t> bytes = {}) {
        acknowledge(from, status, command, id, bytes);
    };
    const std::uint32_t address = content.size() >= 4 ? readBig32(content.data()) : 0;
    switch (command) {
    case Discovery:
        return reply(Success, m_registers.bytes(0, discoverySize));
    case ReadRegister:
        if (!m_registers.holds(address, 4))
            return reply(InvalidAddress);
        return reply(Success, m_registers.bytes(address, 4));
    case ReadMemory: {
        const std::size_t size = content.size() >= 8 ? readBig16(&content[6]) : 0;
        if (!m_registers.holds(address, size))
            return reply(InvalidAddress);
        std::vector<std::uint8_t> bytes(content.begin(), content.begin() + 4);
        const auto memory = m_registers.bytes(address, size);
        bytes.insert(bytes.end(), memory.begin(), memory.end());
        return reply(Success, bytes);
    }
    case WriteRegister:
    case WriteMemory: {
        std::array<std::uint8_t, 4> written{};
        if (content.size() != 8 || !m_registers.holds(address, 4))
            return reply(InvalidAddress, written);
        const std::uint16_t status = write(address, readBig32(&content[4]), from);
        writeBig32(written.data(), status == Success ? (command == WriteMemory ? 4 : 1) : 0);
        return reply(status, written);
    }
    case PacketResend:
        if (m_settings.answersResends && content.size() >= 12)
            resend(static_cast<std::uint16_t>(address), readBig32(&content[4]) & 0xffffff,
                   readBig32(&content[8]) & 0xffffff);
        return;
    default:
        return reply(NotImplemented);
    }
}

std::uint16_t SimulatedGigeCamera::write(std::uint32_t address, std::uint32_t value, const sockaddr_in &from)
{
    if (!mayWrite(from)) {
        ++refused;
        return AccessDenied;
    }
    const bool held = (address == reg::ExposureTime && m_registers.get(reg::ExposureAuto) != 0) ||
                      (address == reg::Gain && m_registers.get(reg::GainAuto) != 0);
    if (held)
        return WriteProtected;
    switch (address) {
    case reg::TimestampControl:
        if (value & resetBit)
            m_clock.reset(steadyNow());
        if (value & latchBit) {
            const std::uint64_t ticks = m_clock.ticks(steadyNow());
            m_registers.set(reg::TimestampHigh, static_cast<std::uint32_t>(ticks >> 32));
            m_registers.set(reg::TimestampLow, static_cast<std::uint32_t>(ticks));
        }
        return Success;
    case reg::ControlPrivilege:
        if ((value & privilegeBits) == 0) {
            releaseControl();
        } else {
            m_controller = from;
            m_lastHeard = steadyNow();
            m_registers.set(address, value);
        }
        return Success;
    case reg::Acquisition:
        m_acquiring = value != 0;
        ++m_acquisition;
        m_trigger.reset();
        break;
    case reg::TriggerSoftware:
        ++triggered;
        m_trigger = steadyNow();
        break;
    case reg::PacketSize:
        if (value & fireTestBit) {
            const Packet test(std::max<std::size_t>(m_registers.get(reg::PacketSize) & 0xffff, 64) - 28);
            const sockaddr_in to = destination();
            sendto(m_data, test.data(), test.size(), 0, reinterpret_cast<const sockaddr *>(&to), sizeof to);
            return Success;
        }
        break;
    default:
        break;
    }
    m_registers.set(address, value);
    updatePayload();
    m_wake.notify_all();
    return Success;
}

void SimulatedGigeCamera::releaseControl()
{
    m_controller.reset();
    m_registers.set(reg::ControlPrivilege, 0);
    m_acquiring = false;
    ++m_acquisition;
    m_wake.notify_all();
}

sockaddr_in SimulatedGigeCamera::destination() const
{
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(m_registers.get(reg::StreamAddress));
    to.sin_port = htons(static_cast<std::uint16_t>(m_registers.get(reg::StreamPort)));
    return to;
}

void SimulatedGigeCamera::resend(std::uint16_t imageId, std::uint32_t first, std::uint32_t last)
{
    const sockaddr_in to = destination();
    const auto sendOne = [&](const Packet &packet) {
        sendto(m_data, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr *>(&to), sizeof to);
    };
    for (const auto &[id, packets] : m_sent) {
        if (id != imageId)
            continue;
        for (std::uint32_t i = first; i <= last && i < packets.size(); ++i) {
            sendOne(packets[i]);
            ++resent;
        }
        return;
    }
    sendOne(unavailablePacket(imageId, first));
}

} // namespace odo::test
