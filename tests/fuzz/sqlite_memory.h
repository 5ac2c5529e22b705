// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdlib>
#include <sqlite3.h>

extern "C" {
void *__libc_malloc(std::size_t bytes);
void *__libc_realloc(void *block, std::size_t bytes);
void __libc_free(void *block);
}

namespace odo::fuzz {

/// Has SQLite, which is not looked into anyway, take its memory past the address sanitizer: keeping account
/// of its many small blocks was half of a run. To be called before the first database is opened.
inline void givePlainMemoryToSqlite()
{
    // SQLite wants to know how large a block is: that stands before it.
    static constexpr int before = 16;
    static const auto sizeOf = [](void *block) {
        return *reinterpret_cast<int *>(static_cast<char *>(block) - before);
    };
    static const auto keep = [](void *whole, int bytes) -> void * {
        if (whole == nullptr)
            return nullptr;
        *static_cast<int *>(whole) = bytes;
        return static_cast<char *>(whole) + before;
    };
    sqlite3_mem_methods methods = {};
    methods.xMalloc = [](int bytes) {
        return keep(__libc_malloc(static_cast<std::size_t>(bytes + before)), bytes);
    };
    methods.xFree = [](void *block) { __libc_free(static_cast<char *>(block) - before); };
    methods.xRealloc = [](void *block, int bytes) {
        return keep(
            __libc_realloc(static_cast<char *>(block) - before, static_cast<std::size_t>(bytes + before)),
            bytes);
    };
    methods.xSize = [](void *block) { return sizeOf(block); };
    methods.xRoundup = [](int bytes) { return (bytes + 7) & ~7; };
    methods.xInit = [](void *) { return SQLITE_OK; };
    methods.xShutdown = [](void *) {};
    // Nor does it count what it has taken, for which it takes a lock each time; nothing here asks.
    if (sqlite3_config(SQLITE_CONFIG_MALLOC, &methods) != SQLITE_OK ||
        sqlite3_config(SQLITE_CONFIG_MEMSTATUS, 0) != SQLITE_OK)
        std::abort();
}

} // namespace odo::fuzz
