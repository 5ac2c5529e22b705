// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace odo {

/// SHA-256 (FIPS 180-4), by the processor's own instructions where it has them: files are then hashed as fast as a disk
/// gives them, which Qt's and libav's do not reach. One object on one thread at a time.
class Sha256
{
public:
    Sha256();
    void add(const void *bytes, std::size_t count);
    /// Of all that was added, in lower-case hexadecimal; nothing can be added afterwards.
    std::string hex();

    /// False: without the processor's instructions, also where it has them. Both ways give the same.
    static void useInstructions(bool use);

private:
    std::array<std::uint32_t, 8> m_state;
    std::array<unsigned char, 64> m_block{};
    std::uint64_t m_count = 0; ///< of all bytes
};

} // namespace odo
