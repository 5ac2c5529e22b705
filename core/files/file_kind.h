// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/platform/file_handle.h"

#include <cstddef>
#include <string_view>

namespace odo {

/// What a file holds, by its content. Its name doesn't count.
enum class FileKind {
    Empty,
    Pdf,
    Png,
    Jpeg,
    Svg,
    Html,
    Mp4,
    Matroska,
    Xlsx, ///< a workbook of a spreadsheet
    Zip,
    Project,  ///< of Odograph
    Database, ///< SQLite's, of another program
    Json,
    Yaml, ///< intrinsics
    Csv,
    Tum,
    Tracker,
    Text,  ///< any other
    Other, ///< any other bytes
};

/// Whether one may replace the other without asking: a table of a track does so in any of its forms.
bool isSameKind(FileKind a, FileKind b);

/// How many bytes from the start identify a file's kind.
inline constexpr std::size_t kindBytes = 8192;

/// Of a file that is open; the system's reason where it cannot be read.
SystemResult<FileKind> kindOfFile(const FileHandle &file);

/// The kind of a file that begins so; `start` may hold more than kindBytes.
FileKind kindOf(std::string_view start);

} // namespace odo
