// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/names.h"
#include "core/project/records.h"
#include "core/video/frame_times.h"

#include <Eigen/Core>
#include <QByteArray>
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace odo {

/// The long series of a project as packed column arrays, in the layout of docs/project_file.md, and back, bit
/// for bit. Of a covariance of pixels or metres the upper triangle is kept (it is symmetric). Reading checks
/// kind, version and length and gives InvalidInput, naming `what`, for anything else. Pure functions, any
/// thread.

/// The most rows a chunk holds: long series are stored in such pieces, of less than a megabyte each.
constexpr std::size_t rowsPerChunk = 8192;

QByteArray packTimes(std::span<const Nanoseconds> times);
Result<void> unpackTimes(const QByteArray &bytes, const Message &what, std::vector<Nanoseconds> &appendTo);

QByteArray packRawTimes(std::span<const RawTime> frames);
Result<void> unpackRawTimes(const QByteArray &bytes, const Message &what, std::vector<RawTime> &appendTo);

QByteArray packClockReadings(std::span<const ClockReading> readings);
Result<void> unpackClockReadings(const QByteArray &bytes, const Message &what,
                                 std::vector<ClockReading> &appendTo);

QByteArray packObservations(std::span<const Observation> observations);
Result<void> unpackObservations(const QByteArray &bytes, const Message &what,
                                std::vector<Observation> &appendTo);

QByteArray packSamples(std::span<const Sample> samples);
Result<void> unpackSamples(const QByteArray &bytes, const Message &what, std::vector<Sample> &appendTo);

QByteArray packPoints(std::span<const ProfilePoint> points);
Result<void> unpackPoints(const QByteArray &bytes, const Message &what, std::vector<ProfilePoint> &appendTo);

/// Of a truth the four vectors must have equal length.
QByteArray packTruth(const TruthSeries &truth);
/// Fills the vectors of `into`.
Result<void> unpackTruth(const QByteArray &bytes, const Message &what, TruthSeries &into);

/// The corners of a board image with their residuals, and which of them are outliers or do not count.
QByteArray packCorners(const CalibrationImage &image);
/// Fills in the image's corners; the rest stays as it is.
Result<void> unpackCorners(const QByteArray &bytes, const Message &what, CalibrationImage &into);

QByteArray packNumbers(std::span<const double> numbers);
Result<std::vector<double>> unpackNumbers(const QByteArray &bytes, const Message &what);

/// A square matrix, or an empty one, column by column.
QByteArray packSquare(const Eigen::MatrixXd &matrix);
Result<Eigen::MatrixXd> unpackSquare(const QByteArray &bytes, const Message &what);

/// A packed column array (docs/project_file.md): kind (one letter), version, two zero bytes, the number of
/// rows as u32, then one column after the other, little-endian, without gaps.
struct BlobLayout
{
    char kind;
    std::uint8_t version;
    std::uint32_t bytesPerRow;
};

constexpr std::uint32_t blobHeaderBytes = 8;
constexpr std::uint32_t maxBlobRows = 4'000'000;

/// Fills a blob column by column.
class BlobWriter
{
public:
    BlobWriter(const BlobLayout &layout, std::size_t rows);

    template <class Value>
    void put(Value value)
    {
        static_assert(std::is_arithmetic_v<Value>);
        assert(m_at + sizeof value <= static_cast<std::size_t>(m_bytes.size()));
        auto *to = reinterpret_cast<unsigned char *>(m_start) + m_at;
        std::memcpy(to, &value, sizeof value);
        if constexpr (std::endian::native == std::endian::big)
            std::reverse(to, to + sizeof value);
        m_at += sizeof value;
    }
    /// The finished blob; asserts that exactly the announced columns were put.
    QByteArray take();

private:
    QByteArray m_bytes;
    char *m_start; ///< of the bytes
    std::size_t m_at = 0;
};

/// Reads a blob whose kind, version and length were checked against its layout, so that no read can leave it.
class BlobReader
{
public:
    /// Error InvalidInput when the bytes are not such a blob; `what` names it.
    static Result<BlobReader> open(const QByteArray &bytes, const BlobLayout &layout, const Message &what);

    std::size_t rows() const { return m_rows; }

    /// Real numbers as bounded() gives them; an infinite uncertainty stays one.
    template <class Value>
    Value take()
    {
        static_assert(std::is_arithmetic_v<Value>);
        unsigned char bytes[sizeof(Value)];
        takeLittleEndian(bytes, sizeof(Value));
        Value value;
        std::memcpy(&value, bytes, sizeof value);
        if constexpr (std::is_floating_point_v<Value>)
            return std::isinf(value) ? value : bounded(value);
        else
            return value;
    }

private:
    BlobReader(QByteArray bytes, std::size_t rows) : m_bytes(std::move(bytes)), m_rows(rows) {}
    void takeLittleEndian(unsigned char *bytes, std::size_t count);

    QByteArray m_bytes;
    std::size_t m_rows;
    std::size_t m_position = blobHeaderBytes;
};

} // namespace odo
