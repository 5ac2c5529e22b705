// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/internal/v4l2_sysfs.h"

#include "core/base/file_system.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <system_error>

namespace odo::v4l2Sysfs {

namespace {

const std::filesystem::path classFolder = "/sys/class/video4linux";
constexpr const char *nodePrefix = "video";

std::string firstLineOf(const std::filesystem::path &node, const std::filesystem::path &file)
{
    std::ifstream stream(classFolder / node.filename() / file);
    std::string line;
    std::getline(stream, line);
    return line;
}

} // namespace

std::vector<int> nodeNumbers()
{
    std::vector<int> numbers;
    std::error_code ignored; // without cameras there is no such folder
    for (const std::string &name : files::namesIn(classFolder, ignored)) {
        int number = 0;
        const char *digits = name.data() + std::string(nodePrefix).size(), *end = name.data() + name.size();
        if (name.starts_with(nodePrefix) && std::from_chars(digits, end, number).ptr == end)
            numbers.push_back(number);
    }
    std::ranges::sort(numbers);
    return numbers;
}

std::filesystem::path nodeOf(int number)
{
    return "/dev/" + (nodePrefix + std::to_string(number));
}

std::string nameOf(const std::filesystem::path &node)
{
    return firstLineOf(node, "name");
}

std::string indexOf(const std::filesystem::path &node)
{
    return firstLineOf(node, "index");
}

std::string serialOf(const std::filesystem::path &node)
{
    // The USB device is the parent of the interface that the node belongs to.
    return firstLineOf(node, "device/../serial");
}

} // namespace odo::v4l2Sysfs
