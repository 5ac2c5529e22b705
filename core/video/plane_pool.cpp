// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/plane_pool.h"

#include <mutex>
#include <vector>

namespace odo {

struct PlanePool::Shelf
{
    explicit Shelf(std::size_t size) : bytes(size) {}
    const std::size_t bytes;
    std::mutex mutex;
    std::vector<std::unique_ptr<std::uint8_t[]>> free; ///< never more than were in use at once
};

PlanePool::PlanePool(std::size_t bytes) : m_shelf(std::make_shared<Shelf>(bytes)) {}

std::shared_ptr<std::uint8_t[]> PlanePool::take()
{
    std::unique_ptr<std::uint8_t[]> memory;
    {
        const std::lock_guard lock(m_shelf->mutex);
        if (!m_shelf->free.empty()) {
            memory = std::move(m_shelf->free.back());
            m_shelf->free.pop_back();
        }
    }
    if (!memory)
        memory = std::make_unique<std::uint8_t[]>(m_shelf->bytes);
    return {memory.release(), [shelf = m_shelf](std::uint8_t *back) {
                std::unique_ptr<std::uint8_t[]> returned(back);
                const std::lock_guard lock(shelf->mutex);
                shelf->free.push_back(std::move(returned));
            }};
}

} // namespace odo
