// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

namespace odo {

/// Whether every slice of an FFV1 packet carries a CRC and it holds. libav's decoder hides a slice whose CRC
/// fails behind the picture before and says nothing, so it has to be asked beforehand. A packet coded without
/// CRCs gives false too. Source: RFC 9043 §4.5 and §4.9 (slice footer: 24 bits of size, error status, CRC
/// parity).
bool ffv1ChecksumsHold(std::span<const std::uint8_t> packet);

} // namespace odo
