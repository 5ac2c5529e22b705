// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/database_bytes.h"

#include <sqlite3.h>
#include <string>

namespace odo {

namespace {

std::size_t unitsFor(std::size_t bytes)
{
    return (bytes + sizeof(std::max_align_t) - 1) / sizeof(std::max_align_t);
}

/// Without links on its way, through which SQLite opens nothing; empty where it is too long.
std::string wholeName(sqlite3_vfs &system, const std::filesystem::path &file)
{
    std::string name(static_cast<std::size_t>(system.mxPathname) + 1, '\0');
    const int code = system.xFullPathname(&system, file.c_str(), static_cast<int>(name.size()), name.data());
    return (code & 0xff) == SQLITE_OK ? name.c_str() : std::string();
}

} // namespace

DatabaseBytes::DatabaseBytes(const std::filesystem::path &file)
{
    sqlite3_vfs *system = sqlite3_vfs_find(nullptr);
    m_name = sqlite3_create_filename(wholeName(*system, file).c_str(), "", "", 0, nullptr);
    m_memory.resize(unitsFor(static_cast<std::size_t>(system->szOsFile)));
    m_file = reinterpret_cast<sqlite3_file *>(m_memory.data());
    const int flags = SQLITE_OPEN_READONLY | SQLITE_OPEN_MAIN_DB;
    if (m_name == nullptr || system->xOpen(system, m_name, m_file, flags, nullptr) != SQLITE_OK)
        m_file->pMethods = nullptr;
}

DatabaseBytes::~DatabaseBytes()
{
    if (isOpen())
        m_file->pMethods->xClose(m_file);
    sqlite3_free_filename(const_cast<char *>(m_name)); // NOLINT(cppcoreguidelines-pro-type-const-cast): SQLite's type
}

bool DatabaseBytes::isOpen() const
{
    return m_file->pMethods != nullptr;
}

std::uintmax_t DatabaseBytes::size() const
{
    sqlite3_int64 size = 0;
    return isOpen() && m_file->pMethods->xFileSize(m_file, &size) == SQLITE_OK ? static_cast<std::uintmax_t>(size) : 0;
}

bool DatabaseBytes::read(std::span<std::byte> into, std::uintmax_t offset) const
{
    if (!isOpen())
        return false;
    const int code = m_file->pMethods->xRead(m_file, into.data(), static_cast<int>(into.size()), static_cast<sqlite3_int64>(offset));
    return code == SQLITE_OK || code == SQLITE_IOERR_SHORT_READ;
}

std::uint32_t bigEndian(std::span<const std::byte> bytes, std::size_t offset)
{
    std::uint32_t number = 0;
    for (const std::byte byte : bytes.subspan(offset, 4))
        number = number << 8U | std::to_integer<std::uint32_t>(byte);
    return number;
}

} // namespace odo
