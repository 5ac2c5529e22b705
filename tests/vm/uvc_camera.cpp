// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/vm/uvc_camera.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <endian.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

namespace odo::test {

/// A control request (USB 2.0 §9.3).
struct UvcCamera::Setup
{
    std::uint8_t type, request;
    std::uint16_t value, index;

    std::uint8_t valueHigh() const { return static_cast<std::uint8_t>(value >> 8); }
    std::uint8_t indexHigh() const { return static_cast<std::uint8_t>(index >> 8); }
    bool isIn() const { return (type & 0x80) != 0; }
    bool isClass() const { return (type & 0x60) == 0x20; }
};

namespace {

using Clock = std::chrono::steady_clock;
using Header = std::array<std::uint8_t, 48>;

// USB/IP, the kernel's Documentation/usb/usbip_protocol.rst.
constexpr std::uint32_t submit = 1, unlinkRequest = 2, submitted = 3, unlinked = 4;
constexpr const char *attachFile = "/sys/devices/platform/vhci_hcd.0/attach";
constexpr int highSpeed = 3;
constexpr std::uint32_t payloadSize = 16384; // what the driver asks for at a time, at most
constexpr std::size_t probeSize = 26, probeFormat = 2, probeFrame = 3, probePeriod = 4, probeFrameSize = 18,
                      probePayloadSize = 22;
constexpr std::uint8_t mjpegFormat = 2, streamInterface = 1;
constexpr auto tooLate = std::chrono::milliseconds(500);

std::uint32_t wordAt(const Header &header, std::size_t index)
{
    std::uint32_t word = 0;
    std::memcpy(&word, &header[4 * index], 4);
    return be32toh(word);
}

void set32(UsbBytes &bytes, std::size_t at, std::uint32_t value)
{
    UsbBytes four;
    put32(four, value);
    std::ranges::copy(four, bytes.begin() + static_cast<std::ptrdiff_t>(at));
}

bool readAll(int socket, std::span<std::uint8_t> bytes)
{
    return bytes.empty() ||
           recv(socket, bytes.data(), bytes.size(), MSG_WAITALL) == static_cast<ssize_t>(bytes.size());
}

} // namespace

UvcCamera::UvcCamera(unsigned port, Identity identity, std::vector<UsbBytes> frames)
    : m_port(port), m_identity(std::move(identity)), m_frames(std::move(frames)),
      m_wake(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), m_probe(probeSize, 0)
{
    settle();
}

UvcCamera::~UvcCamera()
{
    unplug();
    close(m_wake);
}

bool UvcCamera::plug()
{
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return false;
    const std::string line = std::to_string(m_port) + ' ' + std::to_string(ends[1]) + ' ' +
                             std::to_string(m_port + 1) + ' ' + std::to_string(highSpeed);
    const int attach = open(attachFile, O_WRONLY | O_CLOEXEC);
    const bool taken = attach >= 0 && write(attach, line.data(), line.size()) > 0;
    close(attach);
    close(ends[1]); // the kernel has its own share
    if (!taken) {
        close(ends[0]);
        return false;
    }
    m_socket = ends[0];
    m_ending = false;
    m_thread = std::thread([this] { run(); });
    return true;
}

void UvcCamera::unplug()
{
    {
        const std::lock_guard lock(m_mutex);
        m_ending = true;
        m_streaming = m_stalled = false;
        m_pending.clear();
    }
    wake();
    if (m_thread.joinable())
        m_thread.join();
    if (m_socket >= 0)
        close(m_socket);
    m_socket = -1;
}

void UvcCamera::wake()
{
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = write(m_wake, &one, sizeof one);
}

void UvcCamera::setStalled(bool stalled)
{
    {
        const std::lock_guard lock(m_mutex);
        m_stalled = stalled;
    }
    wake();
}

void UvcCamera::breakOne()
{
    const std::lock_guard lock(m_mutex);
    m_break = true;
}

void UvcCamera::shortenOne()
{
    const std::lock_guard lock(m_mutex);
    m_shorten = true;
}

UvcControls UvcCamera::controls() const
{
    const std::lock_guard lock(m_mutex);
    return m_controls;
}

int UvcCamera::waitMs() const
{
    if (!m_streaming || m_stalled || m_pending.empty())
        return -1;
    return static_cast<int>(std::max<std::int64_t>(
        std::chrono::ceil<std::chrono::milliseconds>(m_due - Clock::now()).count(), 0));
}

void UvcCamera::run()
{
    for (;;) {
        int wait = 0;
        {
            const std::lock_guard lock(m_mutex);
            if (m_ending)
                return;
            sendWhatIsDue();
            wait = waitMs();
        }
        std::array<pollfd, 2> waiting{{{m_socket, POLLIN, 0}, {m_wake, POLLIN, 0}}};
        poll(waiting.data(), waiting.size(), wait);
        std::uint64_t count = 0;
        [[maybe_unused]] const auto woken = read(m_wake, &count, sizeof count);
        if ((waiting[0].revents & (POLLIN | POLLHUP)) != 0 && !readable())
            return;
    }
}

/// False when the kernel has hung up.
bool UvcCamera::readable()
{
    Header header{};
    if (!readAll(m_socket, header))
        return false;
    const std::uint32_t command = wordAt(header, 0), sequence = wordAt(header, 1), length = wordAt(header, 6);
    const bool isIn = wordAt(header, 3) != 0, isControl = wordAt(header, 4) == 0;
    UsbBytes data(command == submit && !isIn ? length : 0);
    if (!readAll(m_socket, data))
        return false;
    const std::lock_guard lock(m_mutex);
    if (command == unlinkRequest) {
        unlink(sequence, wordAt(header, 5));
    } else if (isControl) {
        const std::uint8_t *bytes = &header[40];
        const auto word = [&](int at) { return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8); };
        control(sequence, {bytes[0], bytes[1], word(2), word(4)}, length, data);
    } else {
        m_pending.push_back({sequence, length});
    }
    return true;
}

void UvcCamera::reply(std::uint32_t command, std::uint32_t sequence, int status, std::size_t actual,
                      const UsbBytes &data)
{
    const std::array<std::uint32_t, 12> words{htobe32(command),
                                              htobe32(sequence),
                                              0,
                                              0,
                                              0,
                                              htobe32(static_cast<std::uint32_t>(status)),
                                              htobe32(static_cast<std::uint32_t>(actual))};
    UsbBytes packet(sizeof words);
    std::memcpy(packet.data(), words.data(), sizeof words);
    packet.insert(packet.end(), data.begin(), data.end());
    for (std::size_t sent = 0; sent < packet.size();) {
        const ssize_t count = send(m_socket, packet.data() + sent, packet.size() - sent, MSG_NOSIGNAL);
        if (count <= 0)
            return; // unplugged; the next read says so
        sent += static_cast<std::size_t>(count);
    }
}

void UvcCamera::unlink(std::uint32_t sequence, std::uint32_t victim)
{
    const bool found =
        std::erase_if(m_pending, [&](const Request &request) { return request.sequence == victim; }) > 0;
    reply(unlinked, sequence, found ? -ECONNRESET : 0, 0, {});
}

void UvcCamera::control(std::uint32_t sequence, const Setup &setup, std::uint32_t length,
                        std::span<const std::uint8_t> data)
{
    std::optional<UsbBytes> answer;
    if (!setup.isClass())
        answer = standardAnswer(setup);
    else if ((setup.index & 0xff) == streamInterface)
        answer = streamAnswer(setup, data);
    else
        answer = m_controls.answer(setup.request, setup.indexHigh(), setup.valueHigh(), data);
    if (!answer)
        return reply(submitted, sequence, -EPIPE, 0, {});
    if (!setup.isIn())
        return reply(submitted, sequence, 0, data.size(), {});
    answer->resize(std::min<std::size_t>(answer->size(), length));
    reply(submitted, sequence, 0, answer->size(), *answer);
}

std::optional<UsbBytes> UvcCamera::standardAnswer(const Setup &setup)
{
    constexpr std::uint8_t getStatus = 0, clearFeature = 1, getDescriptor = 6, device = 1, configuration = 2,
                           string = 3, ofEndpoint = 2;
    if (!setup.isIn()) {
        if (setup.type == ofEndpoint && setup.request == clearFeature)
            m_streaming = false;
        return UsbBytes{};
    }
    if (setup.request == getStatus)
        return UsbBytes{0, 0};
    if (setup.request != getDescriptor)
        return std::nullopt;
    switch (setup.valueHigh()) {
    case device:
        return deviceDescriptor();
    case configuration:
        return configurationDescriptor();
    case string: {
        const std::array<std::string, 3> texts{"Odograph", m_identity.name, m_identity.serial};
        const std::size_t which = setup.value & 0xff;
        if (which == 0)
            return UsbBytes{4, 3, 9, 4}; // in English
        return which <= texts.size() ? std::optional(stringDescriptor(texts[which - 1])) : std::nullopt;
    }
    default:
        return std::nullopt;
    }
}

std::optional<UsbBytes> UvcCamera::streamAnswer(const Setup &setup, std::span<const std::uint8_t> data)
{
    constexpr std::uint8_t setCurrent = 0x01, getLength = 0x85, getInfo = 0x86, probe = 1, commit = 2;
    if (setup.valueHigh() != probe && setup.valueHigh() != commit)
        return std::nullopt;
    if (setup.request == getLength)
        return UsbBytes{probeSize, 0};
    if (setup.request == getInfo)
        return UsbBytes{3};
    if (setup.request != setCurrent)
        return m_probe;
    std::copy_n(data.begin(), std::min(data.size(), probeSize), m_probe.begin());
    settle();
    if (setup.valueHigh() == commit)
        startStream();
    return UsbBytes{};
}

/// Makes of what was asked for something that this camera has.
void UvcCamera::settle()
{
    m_probe[probeFormat] = std::clamp<std::uint8_t>(m_probe[probeFormat], 1, mjpegFormat);
    m_probe[probeFrame] = std::clamp<std::uint8_t>(m_probe[probeFrame], 1, uvcSizes.size());
    const std::uint32_t asked = get32(std::span(m_probe).subspan(probePeriod));
    const auto off = [&](std::uint32_t period) {
        return std::abs(static_cast<std::int64_t>(period) - asked);
    };
    set32(m_probe, probePeriod, asked == 0 ? uvcPeriods[0] : *std::ranges::min_element(uvcPeriods, {}, off));
    const UvcSize size = uvcSizes[m_probe[probeFrame] - 1U];
    set32(m_probe, probeFrameSize, size.widthPx * size.heightPx * 2U);
    set32(m_probe, probePayloadSize, payloadSize);
}

void UvcCamera::startStream()
{
    m_streaming = true;
    m_toggle = false;
    m_frame.clear();
    m_sent = 0;
    m_due = Clock::now();
}

UsbBytes UvcCamera::nextFrame()
{
    ++m_count;
    UsbBytes image;
    if (m_probe[probeFormat] == mjpegFormat) {
        image = m_frames[m_count % m_frames.size()];
    } else {
        const UvcSize size = uvcSizes[m_probe[probeFrame] - 1U];
        UsbBytes row(size.widthPx * 2U, 128);
        for (unsigned x = 0; x < size.widthPx; ++x)
            row[2 * x] =
                static_cast<std::uint8_t>(x + 4 * m_count + static_cast<unsigned>(m_controls.brightness()));
        for (unsigned y = 0; y < size.heightPx; ++y)
            image.insert(image.end(), row.begin(), row.end());
    }
    if (m_shorten)
        image.resize(image.size() / 2);
    m_shorten = false;
    return image;
}

/// The next piece of the picture, behind its header (USB Video Class 1.0 §2.4.3.3).
UsbBytes UvcCamera::payload()
{
    constexpr std::uint8_t endOfHeader = 0x80, error = 0x40, endOfFrame = 0x02;
    const std::size_t size = std::min(std::min(m_pending.front().length, payloadSize) - 2,
                                      static_cast<std::uint32_t>(m_frame.size() - m_sent));
    const bool isLast = m_sent + size == m_frame.size();
    UsbBytes bytes(2 + size);
    bytes[0] = 2;
    bytes[1] = static_cast<std::uint8_t>(endOfHeader | (m_toggle ? 1 : 0) | (isLast ? endOfFrame : 0) |
                                         (m_break ? error : 0));
    m_break = false;
    std::copy_n(m_frame.begin() + static_cast<std::ptrdiff_t>(m_sent), size, bytes.begin() + 2);
    m_sent += size;
    return bytes;
}

void UvcCamera::sendWhatIsDue()
{
    const std::chrono::nanoseconds period(100LL * get32(std::span(m_probe).subspan(probePeriod)));
    while (waitMs() == 0) {
        if (m_frame.empty())
            m_frame = nextFrame();
        const UsbBytes piece = payload();
        const Request request = m_pending.front();
        m_pending.pop_front();
        if (m_sent == m_frame.size()) {
            m_frame.clear();
            m_sent = 0;
            m_toggle = !m_toggle;
            for (m_due += period; m_due + tooLate < Clock::now(); m_due += period)
                ++m_count; // what nobody has fetched is lost
        }
        reply(submitted, request.sequence, 0, piece.size(), piece);
    }
}

} // namespace odo::test
