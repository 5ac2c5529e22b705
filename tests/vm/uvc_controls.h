// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/vm/uvc_descriptors.h"

#include <optional>

namespace odo::test {

/// The controls of a played webcam (USB Video Class 1.0 §4.2.2). While an automatic is on, what it moves
/// shows its value; once it is turned off, the camera falls back to what was set by hand before, as many do.
class UvcControls
{
public:
    /// The answer to a request; nullopt where there is no such control.
    std::optional<UsbBytes> answer(std::uint8_t request, std::uint8_t entity, std::uint8_t selector,
                                   std::span<const std::uint8_t> data);
    /// What the camera goes by now.
    std::int32_t exposure() const { return valueOf(uvcTerminal, 4); }
    std::int32_t whiteBalance() const { return valueOf(uvcProcessing, 10); }
    std::int32_t brightness() const { return valueOf(uvcProcessing, 2); }
    bool isAnyAutomaticOn() const;

private:
    struct Control
    {
        std::uint8_t entity = 0, selector = 0, size = 0;
        std::int32_t least = 0, most = 0, resolution = 0, standard = 0, value = 0;
        std::int32_t automatic = 0;         ///< its value while its automatic is on
        std::uint8_t automaticSelector = 0; ///< 0: it has none
    };
    const Control *find(std::uint8_t entity, std::uint8_t selector) const;
    std::int32_t valueOf(std::uint8_t entity, std::uint8_t selector) const;
    bool isAutomatic(const Control &control) const;

    std::array<Control, 9> m_controls{
        {{uvcTerminal, 2, 1, 1, 8, 9, 8, 8}, // exposure: by hand (1), or with priority of the aperture (8)
         {uvcTerminal, 3, 1, 0, 1, 1, 0, 1}, // the rate may fall for the exposure
         {uvcTerminal, 4, 4, 1, 5000, 1, 250, 250, 123, 2},            // exposure time
         {uvcTerminal, 6, 2, 0, 255, 5, 0, 0, 40, 8},                  // focus
         {uvcTerminal, 8, 1, 0, 1, 1, 1, 1},                           // its automatic
         {uvcProcessing, 2, 2, 0, 255, 1, 128, 128},                   // brightness
         {uvcProcessing, 4, 2, 0, 100, 1, 0, 10},                      // gain
         {uvcProcessing, 10, 2, 2800, 6500, 10, 4600, 4600, 5200, 11}, // white balance
         {uvcProcessing, 11, 1, 0, 1, 1, 1, 1}}};                      // its automatic
};

} // namespace odo::test
