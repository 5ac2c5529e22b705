// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/core_words/subjects.h"

namespace odo::core_words {

std::span<const CorePattern> setup()
{
    static constexpr CorePattern patterns[] = {
        {QT_TRANSLATE_NOOP("CoreWords", "USB buses")},
        {QT_TRANSLATE_NOOP("CoreWords", "each USB camera has a bus of its own")},
        {QT_TRANSLATE_NOOP("CoreWords", "no USB camera is used")},
        {QT_TRANSLATE_NOOP("CoreWords", "cameras %1 share the bus %2, of %3 Mbit/s"), "", "1"},
        {QT_TRANSLATE_NOOP("CoreWords", "cameras %1 share the bus %2"), "", "1"},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "plug one into a port on the other side of the computer, or a card of its own")},
        {QT_TRANSLATE_NOOP("CoreWords", "or let both send MJPEG, or smaller pictures")},
        {QT_TRANSLATE_NOOP("CoreWords", "Access to cameras")},
        {QT_TRANSLATE_NOOP("CoreWords", "you may not use %1"), "", "1"},
        {QT_TRANSLATE_NOOP(
            "CoreWords",
            "add yourself to the group video (sudo usermod -aG video $USER), then log out and in again")},
        {QT_TRANSLATE_NOOP("CoreWords", "this machine shows no USB or built-in camera (/dev/video*)")},
        {QT_TRANSLATE_NOOP("CoreWords", "if one is connected, try another cable and port, without a hub")},
        {QT_TRANSLATE_NOOP("CoreWords", "you may use all %1 video devices")},
        {QT_TRANSLATE_NOOP("CoreWords", "Receive buffer")},
        {QT_TRANSLATE_NOOP("CoreWords", "the system does not say how large it may be (net.core.rmem_max)")},
        {QT_TRANSLATE_NOOP("CoreWords", "up to %1 MiB, enough for network cameras")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 MiB, which only network cameras would find too small")},
        {QT_TRANSLATE_NOOP("CoreWords", "only %1 MiB")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 will lose pictures"), "", "1"},
        {QT_TRANSLATE_NOOP(
            "CoreWords",
            "sudo sysctl -w net.core.rmem_max=%1, and put the same into /etc/sysctl.d/ to keep it")},
        {QT_TRANSLATE_NOOP("CoreWords", "Packet size")},
        {QT_TRANSLATE_NOOP("CoreWords", "no network camera is used")},
        {QT_TRANSLATE_NOOP("CoreWords", "large packets are allowed")},
        {QT_TRANSLATE_NOOP("CoreWords", "small packets on %1"), "", "1"},
        {QT_TRANSLATE_NOOP("CoreWords", "give the port that the camera is on an MTU of 9000 (sudo ip link "
                                        "set dev NAME mtu 9000), if camera and switch can take it")},
        {QT_TRANSLATE_NOOP("CoreWords", "Lamps' flicker, camera %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "filtered by the camera (%1)")},
        {QT_TRANSLATE_NOOP("CoreWords", "its filter is off")},
        {QT_TRANSLATE_NOOP("CoreWords", "pictures may pulse under lamps")},
        {QT_TRANSLATE_NOOP("CoreWords", "set '%1' to your mains")},
        {QT_TRANSLATE_NOOP("CoreWords", "50 Hz in most countries, 60 Hz in the Americas")},
        {QT_TRANSLATE_NOOP("CoreWords", "it does not tell its exposure")},
        {QT_TRANSLATE_NOOP("CoreWords", "exposed for %1 ms, which suits lamps")},
        {QT_TRANSLATE_NOOP("CoreWords", "exposed for %1 ms")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "expose for 10 or 20 ms with mains of 50 Hz, 8.3 or 16.7 ms with 60 Hz")},
        {QT_TRANSLATE_NOOP("CoreWords", "or use daylight")},
        {QT_TRANSLATE_NOOP("CoreWords", "Automatics, camera %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 go on changing by themselves"), "", "1"},
        {QT_TRANSLATE_NOOP("CoreWords", "%1 goes on changing by itself")},
        {QT_TRANSLATE_NOOP(
            "CoreWords",
            "turn it off in the camera's own program, or keep the light steady while robots run")},
        {QT_TRANSLATE_NOOP("CoreWords", "exposure, gain, white balance and focus are held")},
        {QT_TRANSLATE_NOOP("CoreWords", "it has none")},
        {QT_TRANSLATE_NOOP("CoreWords", "they are held while recording")},
        {QT_TRANSLATE_NOOP("CoreWords", "Step")},
        {QT_TRANSLATE_NOOP("CoreWords", "one camera is always in step")},
        {QT_TRANSLATE_NOOP("CoreWords", "a camera does not deliver")},
        {QT_TRANSLATE_NOOP("CoreWords", "see its own line")},
        {QT_TRANSLATE_NOOP("CoreWords", "the cameras run at %1 and %2 frames/s")},
        {QT_TRANSLATE_NOOP("CoreWords", "set both to one rate")},
        {QT_TRANSLATE_NOOP(
            "CoreWords",
            "in dim light a camera halves its rate by itself, unless its automatic exposure is off")},
        {QT_TRANSLATE_NOOP("CoreWords", "no two pictures have been taken together yet")},
        {QT_TRANSLATE_NOOP("CoreWords", "wait a few seconds, and look again")},
        {QT_TRANSLATE_NOOP("CoreWords", "set both to one rate, or trigger them together")},
        {QT_TRANSLATE_NOOP("CoreWords", "Picture size, camera %1")},
        {QT_TRANSLATE_NOOP("CoreWords", "it is not registered to the floor")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "register it in Testbed, or its pictures cannot tell where a robot is")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1, as it was registered")},
        {QT_TRANSLATE_NOOP("CoreWords", "%1, but registered at %2")},
        {QT_TRANSLATE_NOOP("CoreWords",
                           "let it send the size it was registered at, or calibrate and register it anew")},
    };
    return patterns;
}

} // namespace odo::core_words
