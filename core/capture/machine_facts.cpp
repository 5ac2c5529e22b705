// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/setup_checks.h"

#include "core/base/file_system.h"

#include <algorithm>
#include <fstream>
#include <unistd.h>

namespace odo {

namespace {

template <class Value>
std::optional<Value> valueIn(const std::filesystem::path &file)
{
    std::ifstream stream(file);
    Value value{};
    return stream >> value ? std::optional(value) : std::nullopt;
}

std::vector<std::string> sortedNamesIn(const std::filesystem::path &folder)
{
    std::error_code unread; // what cannot be looked at is not there
    std::vector<std::string> names = files::namesIn(folder, unread);
    std::ranges::sort(names);
    return names;
}

/// From a device's place in /sys ("…/usb1/1-2/1-2:1.0"): the bus, and how fast the nearest device above it is
/// connected.
void findUsb(VideoNode &node, const std::filesystem::path &device)
{
    std::error_code problem;
    std::filesystem::path place = files::realPath(device, problem);
    if (problem)
        return;
    for (const std::filesystem::path &part : place) {
        if (part.string().starts_with("usb") && part.string().size() > 3)
            node.usbBus = part.string();
    }
    for (; node.usbBus.size() > 0 && place != place.parent_path(); place = place.parent_path()) {
        if (const auto speed = valueIn<double>(place / "speed")) {
            node.usbMbps = *speed;
            return;
        }
    }
}

} // namespace

MachineFacts readMachine(const std::filesystem::path &root)
{
    MachineFacts facts;
    for (const std::string &name : sortedNamesIn(root / "dev")) {
        if (!name.starts_with("video"))
            continue;
        VideoNode node;
        node.path = "/dev/" + name;
        node.usable = access((root / "dev" / name).c_str(), R_OK | W_OK) == 0;
        findUsb(node, root / "sys/class/video4linux" / name / "device");
        facts.nodes.push_back(std::move(node));
    }
    for (const std::string &name : sortedNamesIn(root / "sys/class/net")) {
        const std::filesystem::path port = root / "sys/class/net" / name;
        const auto mtu = valueIn<int>(port / "mtu");
        if (name != "lo" && mtu && valueIn<std::string>(port / "operstate") == "up")
            facts.ports.push_back({name, *mtu});
    }
    facts.receiveBufferBytes = valueIn<std::int64_t>(root / "proc/sys/net/core/rmem_max");
    return facts;
}

} // namespace odo
