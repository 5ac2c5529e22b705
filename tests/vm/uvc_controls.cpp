// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/vm/uvc_controls.h"

#include <algorithm>

namespace odo::test {

namespace {

constexpr std::uint8_t setCurrent = 0x01, getCurrent = 0x81, getLeast = 0x82, getMost = 0x83,
                       getResolution = 0x84, getLength = 0x85, getInfo = 0x86, getStandard = 0x87;
constexpr std::uint8_t exposureMode = 2, byHand = 1;
constexpr std::uint8_t canGetAndSet = 3, movesByItself = 8;

UsbBytes bytesOf(std::int32_t value, std::uint8_t size)
{
    UsbBytes bytes;
    put32(bytes, static_cast<std::uint32_t>(value));
    bytes.resize(size);
    return bytes;
}

} // namespace

const UvcControls::Control *UvcControls::find(std::uint8_t entity, std::uint8_t selector) const
{
    const auto found = std::ranges::find_if(
        m_controls, [&](const Control &one) { return one.entity == entity && one.selector == selector; });
    return found == m_controls.end() ? nullptr : &*found;
}

bool UvcControls::isAutomatic(const Control &control) const
{
    if (control.automaticSelector == 0)
        return false;
    const std::int32_t mode = find(control.entity, control.automaticSelector)->value;
    return control.automaticSelector == exposureMode ? mode != byHand : mode != 0;
}

bool UvcControls::isAnyAutomaticOn() const
{
    return std::ranges::any_of(m_controls, [this](const Control &one) { return isAutomatic(one); }) ||
           find(uvcTerminal, 3)->value != 0;
}

std::int32_t UvcControls::valueOf(std::uint8_t entity, std::uint8_t selector) const
{
    const Control *control = find(entity, selector);
    return isAutomatic(*control) ? control->automatic : control->value;
}

std::optional<UsbBytes> UvcControls::answer(std::uint8_t request, std::uint8_t entity, std::uint8_t selector,
                                            std::span<const std::uint8_t> data)
{
    const Control *control = find(entity, selector);
    if (!control)
        return std::nullopt;
    switch (request) {
    case setCurrent: {
        UsbBytes whole(data.begin(), data.end());
        whole.resize(4);
        m_controls[static_cast<std::size_t>(control - m_controls.data())].value =
            static_cast<std::int32_t>(get32(whole));
        return UsbBytes{};
    }
    case getCurrent:
        return bytesOf(valueOf(entity, selector), control->size);
    case getLeast:
        return bytesOf(control->least, control->size);
    case getMost:
        return bytesOf(control->most, control->size);
    case getResolution:
        return bytesOf(control->resolution, control->size);
    case getStandard:
        return bytesOf(control->standard, control->size);
    case getLength:
        return UsbBytes{control->size, 0};
    case getInfo:
        return UsbBytes{
            static_cast<std::uint8_t>(canGetAndSet | (control->automaticSelector != 0 ? movesByItself : 0))};
    default:
        return std::nullopt;
    }
}

} // namespace odo::test
