// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/column_blob.h"

namespace odo {

BlobWriter::BlobWriter(const BlobLayout &layout, std::size_t rows)
    : m_bytes(static_cast<qsizetype>(blobHeaderBytes + rows * layout.bytesPerRow), Qt::Uninitialized), m_start(m_bytes.data())
{
    assert(rows <= maxBlobRows);
    put(layout.kind);
    put(layout.version);
    put(std::uint16_t(0));
    put(static_cast<std::uint32_t>(rows));
}

QByteArray BlobWriter::take()
{
    assert(m_at == static_cast<std::size_t>(m_bytes.size()));
    return std::move(m_bytes);
}

Result<BlobReader> BlobReader::open(const QByteArray &bytes, const BlobLayout &layout,
                                    const std::string &what)
{
    const auto damaged = [&what](const std::string &why) {
        return fail(ErrorCode::InvalidInput, what, why,
                    "the project file is damaged: restore it from a backup copy");
    };
    const auto size = static_cast<std::size_t>(bytes.size());
    if (size < blobHeaderBytes || bytes[0] != layout.kind)
        return damaged("its stored series is not of the expected kind");
    const auto version = static_cast<std::uint8_t>(bytes[1]);
    if (version != layout.version)
        return fail(ErrorCode::NewerFormat, what,
                    "its stored series has the unknown layout " + std::to_string(version),
                    "open the project with a newer Odograph");
    BlobReader reader(bytes, 0);
    reader.m_position = 4;
    const std::size_t rows = reader.take<std::uint32_t>();
    if (rows > maxBlobRows || size != blobHeaderBytes + rows * layout.bytesPerRow)
        return damaged("its stored series announces " + std::to_string(rows) + " rows but holds " +
                       std::to_string(size) + " bytes");
    reader.m_rows = rows;
    return reader;
}

void BlobReader::takeLittleEndian(unsigned char *bytes, std::size_t count)
{
    assert(m_position + count <= static_cast<std::size_t>(m_bytes.size()));
    const char *from = m_bytes.constData() + m_position;
    std::copy(from, from + count, bytes);
    if constexpr (std::endian::native == std::endian::big)
        std::reverse(bytes, bytes + count);
    m_position += count;
}

} // namespace odo
