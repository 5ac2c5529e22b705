// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo::test {

/// A message of Protocol Buffers taken apart without its schema
/// (developers.google.com/protocol-buffers/docs/encoding), to look at what was encoded with other eyes.
struct DecodedMessage
{
    struct Value
    {
        unsigned wireType = 0;
        std::uint64_t bits = 0; ///< of a varint or a fixed number
        std::string bytes;      ///< of what has a length

        double real() const { return read<double>(); }
        float shortReal() const { return read<float>(); }

    private:
        template <class Number>
        Number read() const
        {
            Number number = 0;
            std::memcpy(&number, &bits, sizeof number); // the tests run on little-endian machines only
            return number;
        }
    };
    std::multimap<unsigned, Value> fields; ///< by number

    const Value *first(unsigned field) const
    {
        const auto found = fields.find(field);
        return found == fields.end() ? nullptr : &found->second;
    }
};

/// nullopt where the bytes are no message.
inline std::optional<DecodedMessage> decodeMessage(std::string_view bytes)
{
    DecodedMessage message;
    std::size_t at = 0;
    const auto varint = [&]() -> std::optional<std::uint64_t> {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 64 && at < bytes.size(); shift += 7) {
            const auto byte = static_cast<unsigned char>(bytes[at++]);
            value |= std::uint64_t(byte & 0x7f) << shift;
            if (byte < 0x80)
                return value;
        }
        return std::nullopt;
    };
    while (at < bytes.size()) {
        const auto tag = varint();
        if (!tag)
            return std::nullopt;
        DecodedMessage::Value value;
        value.wireType = unsigned(*tag & 7);
        std::optional<std::uint64_t> length;
        switch (value.wireType) {
        case 0:
            if (const auto whole = varint())
                value.bits = *whole;
            else
                return std::nullopt;
            break;
        case 1:
        case 5:
            length = value.wireType == 1 ? 8 : 4;
            if (bytes.size() - at < *length)
                return std::nullopt;
            std::memcpy(&value.bits, bytes.data() + at, *length);
            at += *length;
            break;
        case 2:
            length = varint();
            if (!length || bytes.size() - at < *length)
                return std::nullopt;
            value.bytes = bytes.substr(at, *length);
            at += *length;
            break;
        default:
            return std::nullopt;
        }
        message.fields.emplace(unsigned(*tag >> 3), value);
    }
    return message;
}

} // namespace odo::test
