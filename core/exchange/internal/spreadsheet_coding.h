// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringDecoder>
#include <optional>

namespace odo {

/// What spreadsheets save as text, block by block: UTF-8, UTF-16 with a byte order mark, and what is no UTF-8
/// as Windows-1252; lines that end in CR alone get LF. One thread.
class SpreadsheetCoding
{
public:
    /// The next block of the file as UTF-8. Of a character of two blocks only the second shows that it was
    /// none; what stays of the first is in no header.
    void makeUtf8(QByteArray &block);

private:
    QStringDecoder m_utf8{QStringDecoder::Utf8};
    std::optional<QStringDecoder> m_utf16;
    bool m_isFirst = true, m_isOneByte = false, m_hasOnlyCr = false;
};

} // namespace odo
