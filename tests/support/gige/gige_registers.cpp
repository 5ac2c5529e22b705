// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/gige/gige_registers.h"

#include <algorithm>
#include <bit>

namespace odo::test {

std::uint32_t readBig32(const std::uint8_t *bytes)
{
    return std::uint32_t{readBig16(bytes)} << 16 | readBig16(bytes + 2);
}

std::uint16_t readBig16(const std::uint8_t *bytes)
{
    return static_cast<std::uint16_t>(bytes[0] << 8 | bytes[1]);
}

void writeBig32(std::uint8_t *bytes, std::uint32_t value)
{
    writeBig16(bytes, static_cast<std::uint16_t>(value >> 16));
    writeBig16(bytes + 2, static_cast<std::uint16_t>(value));
}

void writeBig16(std::uint8_t *bytes, std::uint16_t value)
{
    bytes[0] = static_cast<std::uint8_t>(value >> 8);
    bytes[1] = static_cast<std::uint8_t>(value);
}

float GigeRegisters::getFloat(std::uint32_t address) const
{
    return std::bit_cast<float>(get(address));
}

void GigeRegisters::setFloat(std::uint32_t address, float value)
{
    set(address, std::bit_cast<std::uint32_t>(value));
}

void GigeRegisters::setText(std::uint32_t address, const std::string &text)
{
    std::ranges::copy(text, m_bytes.begin() + address);
}

} // namespace odo::test
