// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/internal/spreadsheet_coding.h"

#include <QString>
#include <array>
#include <cstddef>

namespace odo {

namespace {

/// Latin-1, but for 32 characters.
QByteArray fromWindows1252(const QByteArray &block)
{
    constexpr char16_t first = 0x80, last = 0x9f;
    constexpr std::array<char16_t, 32> own{0x20ac, 0xfffd, 0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021,
                                           0x02c6, 0x2030, 0x0160, 0x2039, 0x0152, 0xfffd, 0x017d, 0xfffd,
                                           0xfffd, 0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014,
                                           0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0xfffd, 0x017e, 0x0178};
    QString text = QString::fromLatin1(block);
    for (QChar &c : text) {
        if (c.unicode() >= first && c.unicode() <= last)
            c = QChar(own[std::size_t(c.unicode() - first)]);
    }
    return text.toUtf8();
}

} // namespace

void SpreadsheetCoding::makeUtf8(QByteArray &block)
{
    if (m_isFirst && block.startsWith("\xff\xfe"))
        m_utf16.emplace(QStringDecoder::Utf16LE);
    else if (m_isFirst && block.startsWith("\xfe\xff"))
        m_utf16.emplace(QStringDecoder::Utf16BE);
    if (m_utf16) {
        block = QString((*m_utf16)(block)).toUtf8();
    } else if (!m_isOneByte) {
        static_cast<void>(QString(m_utf8(block)));
        m_isOneByte = m_utf8.hasError();
    }
    if (m_isOneByte)
        block = fromWindows1252(block);
    if (m_isFirst)
        m_hasOnlyCr = block.contains('\r') && !block.contains('\n');
    if (m_hasOnlyCr)
        block.replace('\r', '\n');
    m_isFirst = false;
}

} // namespace odo
