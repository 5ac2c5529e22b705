// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/series_blobs.h"

#include "core/geometry/silhouette.h"
#include "core/project/internal/words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace odo {

namespace {

constexpr BlobLayout timesLayout{'T', 1, 8};
constexpr BlobLayout rawTimesLayout{'A', 1, 3 * 8};
constexpr BlobLayout clockReadingsLayout{'K', 1, 3 * 8};
constexpr BlobLayout observationsLayout{'O', 1, 8 + 8 + 1 + 10 * 8};
// with the support of each outline
constexpr BlobLayout supportedLayout{'O', 2,
                                     observationsLayout.bytesPerRow + 4 * std::uint32_t(supportDirections)};
// and with what the shadows leave ambiguous
constexpr BlobLayout ambiguousLayout{'O', 3, supportedLayout.bytesPerRow + 3 * 8};
constexpr BlobLayout samplesLayout{'S', 1, 8 + 8 + 1 + 8 * 8 + 4 + 8 + 4};
constexpr BlobLayout pointsLayout{'P', 1, 1 + 12 * 8};
// with the body's heading
constexpr BlobLayout headedSamplesLayout{'S', 2, samplesLayout.bytesPerRow + 3 * 8};
constexpr BlobLayout headedPointsLayout{'P', 2, pointsLayout.bytesPerRow + 4 * 8};
constexpr BlobLayout truthLayout{'R', 1, 8 + 6 * 8};
constexpr BlobLayout cornersLayout{'C', 1, 1 + 6 * 8};
constexpr BlobLayout numbersLayout{'D', 1, 8};
constexpr BlobLayout squareLayout{'M', 1, 8};

constexpr std::uint8_t foundBit = 1, duplicateBit = 2, borderBit = 4, handBit = 8;
constexpr std::uint8_t positionBit = 1, disagreementBit = 2, headingBit = 4;
constexpr std::uint8_t validBit = 1, bodyBit = 2;
constexpr std::array headingNumbers{&MeasuredHeading::radians, &MeasuredHeading::sigmaRad,
                                    &MeasuredHeading::commonSigmaRad};
constexpr std::array bodyNumbers{&BodyHeading::radians, &BodyHeading::sigmaRad, &BodyHeading::turnRateRadps,
                                 &BodyHeading::sigmaTurnRateRadps};
constexpr std::uint8_t outlierBit = 1, leftOutBit = 2;
constexpr std::size_t maxSquareSize = 64;

/// One column: each row's value, as `value(row)` gives it.
template <class Rows, class Column>
void putColumn(BlobWriter &writer, const Rows &rows, Column value)
{
    for (const auto &row : rows)
        writer.put(value(row));
}

/// One column: sets each row's value through `set(row, value)`.
template <class Value, class Rows, class Column>
void takeColumn(BlobReader &reader, Rows &&rows, Column set)
{
    for (auto &row : rows)
        set(row, reader.take<Value>());
}

/// So many fresh rows at the end.
template <class Row>
std::span<Row> appended(std::vector<Row> &rows, std::size_t count)
{
    rows.resize(rows.size() + count);
    return std::span(rows).last(count);
}

template <class Rows, class Matrix>
void putCovariance(BlobWriter &writer, const Rows &rows, Matrix matrix)
{
    for (const auto &[r, c] : {std::pair{0, 0}, std::pair{0, 1}, std::pair{1, 1}})
        putColumn(writer, rows,
                  [&, row = r, column = c](const auto &value) { return matrix(value)(row, column); });
}

template <class Rows, class Matrix>
void takeCovariance(BlobReader &reader, Rows &&rows, Matrix matrix)
{
    for (const auto &[r, c] : {std::pair{0, 0}, std::pair{0, 1}, std::pair{1, 1}}) {
        takeColumn<double>(reader, rows, [&, row = r, column = c](auto &value, double number) {
            matrix(value)(row, column) = number;
            matrix(value)(column, row) = number;
        });
    }
}

/// Columns of something that a row need not have: each number of it, 0 where it is missing.
template <class Rows, class Part, class Numbers>
void putOptional(BlobWriter &writer, const Rows &rows, Part part, const Numbers &numbers)
{
    for (const auto number : numbers)
        putColumn(writer, rows, [&](const auto &row) { return row.*part ? *(row.*part).*number : 0.0; });
}

template <class Rows, class Part, class Numbers>
void takeOptional(BlobReader &reader, Rows &&rows, Part part, const Numbers &numbers)
{
    for (const auto number : numbers)
        takeColumn<double>(reader, rows, [&](auto &row, double value) {
            if (row.*part)
                *(row.*part).*number = value;
        });
}

/// The layout that a blob is of by its version: the plain one, or the one with more columns.
const BlobLayout &layoutOf(const QByteArray &bytes, const BlobLayout &plain, const BlobLayout &longer)
{
    return bytes.size() > 1 && std::uint8_t(bytes[1]) == longer.version ? longer : plain;
}

template <class Rows, class Vector>
void putVector(BlobWriter &writer, const Rows &rows, Vector vector)
{
    for (int axis : {0, 1})
        putColumn(writer, rows, [&](const auto &value) { return vector(value)[axis]; });
}

template <class Rows, class Vector>
void takeVector(BlobReader &reader, Rows &&rows, Vector vector)
{
    for (int axis : {0, 1})
        takeColumn<double>(reader, rows, [&](auto &value, double number) { vector(value)[axis] = number; });
}

} // namespace

QByteArray packTimes(std::span<const Nanoseconds> times)
{
    BlobWriter writer(timesLayout, times.size());
    putColumn(writer, times, [](Nanoseconds t) { return static_cast<std::int64_t>(t.count()); });
    return writer.take();
}

Result<void> unpackTimes(const QByteArray &bytes, const Message &what, std::vector<Nanoseconds> &appendTo)
{
    auto reader = ODO_TRY(BlobReader::open(bytes, timesLayout, what));
    for (std::size_t i = 0; i < reader.rows(); ++i)
        appendTo.emplace_back(reader.take<std::int64_t>());
    return {};
}

QByteArray packRawTimes(std::span<const RawTime> frames)
{
    BlobWriter writer(rawTimesLayout, frames.size());
    putColumn(writer, frames, [](const RawTime &image) { return image.sequence; });
    putColumn(writer, frames, [](const RawTime &image) { return std::int64_t(image.device.count()); });
    putColumn(writer, frames, [](const RawTime &image) { return std::int64_t(image.arrival.count()); });
    return writer.take();
}

Result<void> unpackRawTimes(const QByteArray &bytes, const Message &what, std::vector<RawTime> &appendTo)
{
    auto reader = ODO_TRY(BlobReader::open(bytes, rawTimesLayout, what));
    const auto fresh = appended(appendTo, reader.rows());
    takeColumn<std::uint64_t>(reader, fresh,
                              [](RawTime &image, std::uint64_t value) { image.sequence = value; });
    takeColumn<std::int64_t>(reader, fresh,
                             [](RawTime &image, std::int64_t value) { image.device = Nanoseconds(value); });
    takeColumn<std::int64_t>(reader, fresh,
                             [](RawTime &image, std::int64_t value) { image.arrival = Nanoseconds(value); });
    return {};
}

QByteArray packClockReadings(std::span<const ClockReading> readings)
{
    BlobWriter writer(clockReadingsLayout, readings.size());
    for (const auto time : {&ClockReading::device, &ClockReading::before, &ClockReading::after})
        putColumn(writer, readings,
                  [time](const ClockReading &reading) { return std::int64_t((reading.*time).count()); });
    return writer.take();
}

Result<void> unpackClockReadings(const QByteArray &bytes, const Message &what,
                                 std::vector<ClockReading> &appendTo)
{
    auto reader = ODO_TRY(BlobReader::open(bytes, clockReadingsLayout, what));
    const auto fresh = appended(appendTo, reader.rows());
    for (const auto time : {&ClockReading::device, &ClockReading::before, &ClockReading::after})
        takeColumn<std::int64_t>(reader, fresh, [time](ClockReading &reading, std::int64_t value) {
            reading.*time = Nanoseconds(value);
        });
    return {};
}

QByteArray packObservations(std::span<const Observation> observations)
{
    const bool hasSupport = std::ranges::any_of(
        observations, [](const Observation &o) { return o.supportPx.size() == supportDirections; });
    const bool isAmbiguous = hasSupport && std::ranges::any_of(observations, [](const Observation &o) {
                                 return !o.lastingCovariancePx2.isZero();
                             });
    BlobWriter writer(isAmbiguous  ? ambiguousLayout
                      : hasSupport ? supportedLayout
                                   : observationsLayout,
                      observations.size());
    const auto column = [&](auto value) { putColumn(writer, observations, value); };
    column([](const Observation &o) { return o.frame; });
    column([](const Observation &o) { return static_cast<std::int64_t>(o.time.count()); });
    column([](const Observation &o) {
        return static_cast<std::uint8_t>((o.found ? foundBit : 0) | (o.duplicateFrame ? duplicateBit : 0) |
                                         (o.touchesBorder ? borderBit : 0) | (o.isByHand ? handBit : 0));
    });
    putVector(writer, observations, [](const Observation &o) { return o.ellipse.centrePx; });
    column([](const Observation &o) { return o.ellipse.semiMajorPx; });
    column([](const Observation &o) { return o.ellipse.semiMinorPx; });
    column([](const Observation &o) { return o.ellipse.angleRad; });
    putCovariance(writer, observations, [](const Observation &o) { return o.centreCovariancePx2; });
    column([](const Observation &o) { return o.areaPx; });
    column([](const Observation &o) { return o.score; });
    for (std::size_t k = 0; k < supportDirections && hasSupport; ++k)
        column([k](const Observation &o) {
            return o.supportPx.size() == supportDirections ? o.supportPx[k] : 0.0F;
        });
    if (isAmbiguous)
        putCovariance(writer, observations, [](const Observation &o) { return o.lastingCovariancePx2; });
    return writer.take();
}

Result<void> unpackObservations(const QByteArray &bytes, const Message &what,
                                std::vector<Observation> &appendTo)
{
    const BlobLayout &layout =
        layoutOf(bytes, layoutOf(bytes, observationsLayout, supportedLayout), ambiguousLayout);
    const bool hasSupport = layout.version != observationsLayout.version;
    auto reader = ODO_TRY(BlobReader::open(bytes, layout, what));
    const auto rows = appended(appendTo, reader.rows());
    takeColumn<std::int64_t>(reader, rows, [](Observation &o, std::int64_t value) { o.frame = value; });
    takeColumn<std::int64_t>(reader, rows,
                             [](Observation &o, std::int64_t value) { o.time = Nanoseconds(value); });
    takeColumn<std::uint8_t>(reader, rows, [](Observation &o, std::uint8_t bits) {
        o.found = (bits & foundBit) != 0;
        o.duplicateFrame = (bits & duplicateBit) != 0;
        o.touchesBorder = (bits & borderBit) != 0;
        o.isByHand = (bits & handBit) != 0;
    });
    takeVector(reader, rows, [](Observation &o) -> Eigen::Vector2d & { return o.ellipse.centrePx; });
    takeColumn<double>(reader, rows, [](Observation &o, double value) { o.ellipse.semiMajorPx = value; });
    takeColumn<double>(reader, rows, [](Observation &o, double value) { o.ellipse.semiMinorPx = value; });
    takeColumn<double>(reader, rows, [](Observation &o, double value) { o.ellipse.angleRad = value; });
    takeCovariance(reader, rows, [](Observation &o) -> Eigen::Matrix2d & { return o.centreCovariancePx2; });
    takeColumn<double>(reader, rows, [](Observation &o, double value) { o.areaPx = value; });
    takeColumn<double>(reader, rows, [](Observation &o, double value) { o.score = value; });
    if (!hasSupport)
        return {};
    for (Observation &o : rows)
        o.supportPx.resize(o.found ? supportDirections : 0);
    for (std::size_t k = 0; k < supportDirections; ++k) {
        takeColumn<float>(reader, rows, [k](Observation &o, float value) {
            if (o.found)
                o.supportPx[k] = value;
        });
    }
    if (layout.version == ambiguousLayout.version)
        takeCovariance(reader, rows,
                       [](Observation &o) -> Eigen::Matrix2d & { return o.lastingCovariancePx2; });
    return {};
}

QByteArray packSamples(std::span<const Sample> samples)
{
    const bool hasHeading =
        std::ranges::any_of(samples, [](const Sample &s) { return s.heading.has_value(); });
    BlobWriter writer(hasHeading ? headedSamplesLayout : samplesLayout, samples.size());
    const auto column = [&](auto value) { putColumn(writer, samples, value); };
    column([](const Sample &s) { return static_cast<std::int64_t>(s.time.count()); });
    column([](const Sample &s) { return s.frame; });
    column([](const Sample &s) {
        return static_cast<std::uint8_t>((s.position ? positionBit : 0) |
                                         (s.viewDisagreementM ? disagreementBit : 0) |
                                         (s.heading ? headingBit : 0));
    });
    putVector(writer, samples, [](const Sample &s) -> Eigen::Vector2d {
        return s.position ? *s.position : Eigen::Vector2d(0, 0);
    });
    putCovariance(writer, samples, [](const Sample &s) { return s.covariance; });
    putCovariance(writer, samples, [](const Sample &s) { return s.commonCovariance; });
    column([](const Sample &s) { return s.views; });
    column([](const Sample &s) { return s.viewDisagreementM.value_or(0.0); });
    column([](const Sample &s) { return s.flags; });
    if (hasHeading)
        putOptional(writer, samples, &Sample::heading, headingNumbers);
    return writer.take();
}

Result<void> unpackSamples(const QByteArray &bytes, const Message &what, std::vector<Sample> &appendTo)
{
    const BlobLayout &layout = layoutOf(bytes, samplesLayout, headedSamplesLayout);
    const bool hasHeading = layout.version == headedSamplesLayout.version;
    auto reader = ODO_TRY(BlobReader::open(bytes, layout, what));
    const auto rows = appended(appendTo, reader.rows());
    takeColumn<std::int64_t>(reader, rows,
                             [](Sample &s, std::int64_t value) { s.time = Nanoseconds(value); });
    takeColumn<std::int64_t>(reader, rows, [](Sample &s, std::int64_t value) { s.frame = value; });
    takeColumn<std::uint8_t>(reader, rows, [hasHeading](Sample &s, std::uint8_t bits) {
        if ((bits & positionBit) != 0)
            s.position = Eigen::Vector2d(0, 0);
        if ((bits & disagreementBit) != 0)
            s.viewDisagreementM = 0;
        if (hasHeading && (bits & headingBit) != 0)
            s.heading.emplace();
    });
    for (int axis : {0, 1}) {
        takeColumn<double>(reader, rows, [axis](Sample &s, double value) {
            if (s.position)
                (*s.position)[axis] = value;
        });
    }
    takeCovariance(reader, rows, [](Sample &s) -> Eigen::Matrix2d & { return s.covariance; });
    takeCovariance(reader, rows, [](Sample &s) -> Eigen::Matrix2d & { return s.commonCovariance; });
    takeColumn<std::uint32_t>(reader, rows, [](Sample &s, std::uint32_t value) { s.views = value; });
    takeColumn<double>(reader, rows, [](Sample &s, double value) {
        if (s.viewDisagreementM)
            s.viewDisagreementM = value;
    });
    takeColumn<std::uint32_t>(reader, rows, [](Sample &s, std::uint32_t value) { s.flags = value; });
    if (hasHeading)
        takeOptional(reader, rows, &Sample::heading, headingNumbers);
    return {};
}

QByteArray packPoints(std::span<const ProfilePoint> points)
{
    const bool hasBody =
        std::ranges::any_of(points, [](const ProfilePoint &p) { return p.body.has_value(); });
    BlobWriter writer(hasBody ? headedPointsLayout : pointsLayout, points.size());
    putColumn(writer, points, [](const ProfilePoint &p) {
        return static_cast<std::uint8_t>((p.valid ? validBit : 0) | (p.body ? bodyBit : 0));
    });
    putVector(writer, points, [](const ProfilePoint &p) { return p.position; });
    putVector(writer, points, [](const ProfilePoint &p) { return p.velocity; });
    putVector(writer, points, [](const ProfilePoint &p) { return p.acceleration; });
    for (double ProfilePoint::*member :
         {&ProfilePoint::sigmaXM, &ProfilePoint::sigmaYM, &ProfilePoint::speedMps,
          &ProfilePoint::sigmaSpeedMps, &ProfilePoint::accelMps2, &ProfilePoint::sigmaAccelMps2})
        putColumn(writer, points, [member](const ProfilePoint &p) { return p.*member; });
    if (hasBody)
        putOptional(writer, points, &ProfilePoint::body, bodyNumbers);
    return writer.take();
}

Result<void> unpackPoints(const QByteArray &bytes, const Message &what, std::vector<ProfilePoint> &appendTo)
{
    const BlobLayout &layout = layoutOf(bytes, pointsLayout, headedPointsLayout);
    const bool hasBody = layout.version == headedPointsLayout.version;
    auto reader = ODO_TRY(BlobReader::open(bytes, layout, what));
    const auto rows = appended(appendTo, reader.rows());
    takeColumn<std::uint8_t>(reader, rows, [hasBody](ProfilePoint &p, std::uint8_t bits) {
        p.valid = hasBody ? (bits & validBit) != 0 : bits != 0;
        if (hasBody && (bits & bodyBit) != 0)
            p.body.emplace();
    });
    takeVector(reader, rows, [](ProfilePoint &p) -> Eigen::Vector2d & { return p.position; });
    takeVector(reader, rows, [](ProfilePoint &p) -> Eigen::Vector2d & { return p.velocity; });
    takeVector(reader, rows, [](ProfilePoint &p) -> Eigen::Vector2d & { return p.acceleration; });
    for (double ProfilePoint::*member :
         {&ProfilePoint::sigmaXM, &ProfilePoint::sigmaYM, &ProfilePoint::speedMps,
          &ProfilePoint::sigmaSpeedMps, &ProfilePoint::accelMps2, &ProfilePoint::sigmaAccelMps2})
        takeColumn<double>(reader, rows, [member](ProfilePoint &p, double value) { p.*member = value; });
    if (hasBody)
        takeOptional(reader, rows, &ProfilePoint::body, bodyNumbers);
    return {};
}

QByteArray packTruth(const TruthSeries &truth)
{
    BlobWriter writer(truthLayout, truth.times.size());
    putColumn(writer, truth.times, [](Nanoseconds t) { return static_cast<std::int64_t>(t.count()); });
    for (const auto *series : {&truth.positions, &truth.velocities, &truth.accelerations})
        putVector(writer, *series, [](const Eigen::Vector2d &v) { return v; });
    return writer.take();
}

Result<void> unpackTruth(const QByteArray &bytes, const Message &what, TruthSeries &into)
{
    auto reader = ODO_TRY(BlobReader::open(bytes, truthLayout, what));
    into.times.resize(reader.rows());
    takeColumn<std::int64_t>(reader, into.times,
                             [](Nanoseconds &t, std::int64_t value) { t = Nanoseconds(value); });
    for (auto *series : {&into.positions, &into.velocities, &into.accelerations}) {
        series->resize(reader.rows());
        takeVector(reader, *series, [](Eigen::Vector2d &v) -> Eigen::Vector2d & { return v; });
    }
    return {};
}

QByteArray packCorners(const CalibrationImage &image)
{
    const std::size_t corners = image.view.pixels.size();
    std::vector<std::uint8_t> bits(corners, 0);
    for (std::size_t corner : image.outliers)
        bits.at(corner) |= outlierBit;
    for (std::size_t corner : image.leftOut)
        bits.at(corner) |= leftOutBit;
    std::vector<Eigen::Vector2d> residuals = image.residualsPx;
    residuals.resize(corners, Eigen::Vector2d::Zero());
    BlobWriter writer(cornersLayout, corners);
    putColumn(writer, bits, [](std::uint8_t bit) { return bit; });
    for (const auto *vectors : {&image.view.pixels, &image.view.pointsOnBoard, &std::as_const(residuals)})
        putVector(writer, *vectors, [](const Eigen::Vector2d &vector) { return vector; });
    return writer.take();
}

Result<void> unpackCorners(const QByteArray &bytes, const Message &what, CalibrationImage &into)
{
    auto reader = ODO_TRY(BlobReader::open(bytes, cornersLayout, what));
    const std::size_t corners = reader.rows();
    for (std::size_t i = 0; i < corners; ++i) {
        const auto bits = reader.take<std::uint8_t>();
        if (bits & outlierBit)
            into.outliers.push_back(i);
        if (bits & leftOutBit)
            into.leftOut.push_back(i);
    }
    for (auto *vectors : {&into.view.pixels, &into.view.pointsOnBoard, &into.residualsPx}) {
        vectors->assign(corners, Eigen::Vector2d::Zero());
        takeVector(reader, *vectors, [](Eigen::Vector2d &vector) -> Eigen::Vector2d & { return vector; });
    }
    return {};
}

QByteArray packNumbers(std::span<const double> numbers)
{
    BlobWriter writer(numbersLayout, numbers.size());
    putColumn(writer, numbers, [](double value) { return value; });
    return writer.take();
}

Result<std::vector<double>> unpackNumbers(const QByteArray &bytes, const Message &what)
{
    auto reader = ODO_TRY(BlobReader::open(bytes, numbersLayout, what));
    std::vector<double> numbers(reader.rows());
    takeColumn<double>(reader, numbers, [](double &number, double value) { number = value; });
    return numbers;
}

QByteArray packSquare(const Eigen::MatrixXd &matrix)
{
    BlobWriter writer(squareLayout, static_cast<std::size_t>(matrix.size()));
    for (Eigen::Index i = 0; i < matrix.size(); ++i)
        writer.put(matrix.data()[i]);
    return writer.take();
}

Result<Eigen::MatrixXd> unpackSquare(const QByteArray &bytes, const Message &what)
{
    auto reader = ODO_TRY(BlobReader::open(bytes, squareLayout, what));
    std::size_t size = 0;
    while (size < maxSquareSize && size * size < reader.rows())
        ++size;
    if (size * size != reader.rows())
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("project.matrix_not_square",
                             "its stored matrix of %1 numbers is not square")(reader.rows()),
                    isDamagedRestoreFile());
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
    for (Eigen::Index i = 0; i < matrix.size(); ++i)
        matrix.data()[i] = reader.take<double>();
    return matrix;
}

BlobWriter::BlobWriter(const BlobLayout &layout, std::size_t rows)
    : m_bytes(static_cast<qsizetype>(blobHeaderBytes + rows * layout.bytesPerRow), Qt::Uninitialized),
      m_start(m_bytes.data())
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

Result<BlobReader> BlobReader::open(const QByteArray &bytes, const BlobLayout &layout, const Message &what)
{
    const auto damaged = [&what](Message why) {
        return fail(ErrorCode::InvalidInput, what, std::move(why), isDamagedRestoreFile());
    };
    const auto size = static_cast<std::size_t>(bytes.size());
    if (size < blobHeaderBytes || bytes[0] != layout.kind)
        return damaged(
            ODO_TEXT("project.series_of_other_kind", "its stored series is not of the expected kind"));
    const auto version = static_cast<std::uint8_t>(bytes[1]);
    if (version != layout.version)
        return fail(
            ErrorCode::NewerFormat, what,
            ODO_TEXT("project.unknown_series_layout", "its stored series has the unknown layout %1")(version),
            openWithNewerOdograph());
    BlobReader reader(bytes, 0);
    reader.m_position = 4;
    const std::size_t rows = reader.take<std::uint32_t>();
    if (rows > maxBlobRows || size != blobHeaderBytes + rows * layout.bytesPerRow)
        return damaged(ODO_TEXT("project.series_of_other_length",
                                "its stored series announces %1 rows but holds %2 bytes")(rows, size));
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
