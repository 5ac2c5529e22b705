// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace odo {

/// Memory for the planes of frames, used again once the last share in it is gone: memory fresh from the
/// system costs a page fault every 4096 bytes, a tenth of what decoding a JPEG picture does. Any thread; what
/// was taken may outlive the pool.
class PlanePool
{
public:
    explicit PlanePool(std::size_t bytes);
    /// So many bytes as told to the constructor; what is in them is of no meaning.
    std::shared_ptr<std::uint8_t[]> take();

private:
    struct Shelf;
    std::shared_ptr<Shelf> m_shelf;
};

} // namespace odo
