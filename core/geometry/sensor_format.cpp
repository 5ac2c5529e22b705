// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/sensor_format.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace odo {

namespace {

struct Size
{
    int width = 0, height = 0;

    bool isPositive() const { return width > 0 && height > 0; }
};

/// Of a lens: focal lengths, centre and distortion in the order of its covariance.
Eigen::VectorXd valuesOf(const Intrinsics &lens)
{
    Eigen::VectorXd values(4 + static_cast<Eigen::Index>(lens.distortion.size()));
    values.head<4>() << lens.fxPx, lens.fyPx, lens.cxPx, lens.cyPx;
    for (std::size_t i = 0; i < lens.distortion.size(); ++i)
        values[4 + static_cast<Eigen::Index>(i)] = lens.distortion[i];
    return values;
}

void setValues(Intrinsics &lens, const Eigen::VectorXd &values)
{
    lens.fxPx = values[0];
    lens.fyPx = values[1];
    lens.cxPx = values[2];
    lens.cyPx = values[3];
    for (std::size_t i = 0; i < lens.distortion.size(); ++i)
        lens.distortion[i] = values[4 + static_cast<Eigen::Index>(i)];
}

/// Values and covariance under a linear map of the values.
void mapValues(Intrinsics &lens, const Eigen::MatrixXd &map, const Eigen::VectorXd &shift)
{
    setValues(lens, map * valuesOf(lens) + shift);
    if (lens.covariance.size() != 0)
        lens.covariance = map * lens.covariance * map.transpose();
}

/// The rows that a camera reads, of those that a codec stores in blocks of sixteen.
int rowsRead(int rows)
{
    constexpr std::pair<int, int> padded[] = {{1088, 1080}, {544, 540}, {368, 360}};
    for (const auto &[stored, read] : padded) {
        if (rows == stored)
            return read;
    }
    return rows;
}

/// Whether it is the same shape, but for the rounding of one side.
bool isSameShape(const Size &from, const Size &to)
{
    constexpr double rounding = 1.01;
    return std::abs(double(to.width) * from.height / from.width - to.height) < rounding ||
           std::abs(double(to.height) * from.width / from.height - to.width) < rounding;
}

SensorFormat whole(const Size &from, const Size &to)
{
    SensorFormat format;
    format.scaleX = double(to.width) / from.width;
    format.scaleY = double(to.height) / from.height;
    return format;
}

/// As much of the sensor as this shape can show.
SensorFormat cropped(const Size &from, const Size &to)
{
    SensorFormat format;
    const bool isWider = double(to.width) * from.height > double(to.height) * from.width;
    format.kind = isWider ? SensorFormat::Kind::WholeWidth : SensorFormat::Kind::WholeHeight;
    format.scaleX = format.scaleY = isWider ? double(to.width) / from.width : double(to.height) / from.height;
    format.cropLeftPx = isWider ? 0 : (from.width - to.width / format.scaleX) / 2;
    format.cropTopPx = isWider ? (from.height - to.height / format.scaleY) / 2 : 0;
    return format;
}

/// All of it, with padding in either or in none.
std::optional<SensorFormat> wholeWithPadding(const Size &from, const Size &to)
{
    const Size fromRead{from.width, rowsRead(from.height)}, toRead{to.width, rowsRead(to.height)};
    for (const auto &[one, other] : {std::pair{from, to}, std::pair{fromRead, toRead},
                                     std::pair{fromRead, to}, std::pair{from, toRead}}) {
        if (isSameShape(one, other))
            return whole(one, other);
    }
    return std::nullopt;
}

} // namespace

std::vector<SensorFormat> sensorFormats(int fromWidthPx, int fromHeightPx, int toWidthPx, int toHeightPx)
{
    const Size from{fromWidthPx, fromHeightPx}, to{toWidthPx, toHeightPx};
    if (!from.isPositive() || !to.isPositive())
        return {};
    const bool isTurned = (from.width > from.height && to.width < to.height) ||
                          (from.width < from.height && to.width > to.height);
    const Size upright = isTurned ? Size{from.height, from.width} : from;
    SensorFormat format = wholeWithPadding(upright, to).value_or(cropped(upright, to));
    format.widthPx = to.width;
    format.heightPx = to.height;
    if (!isTurned)
        return {format};
    std::vector<SensorFormat> formats{format, format};
    formats[0].clockwiseDeg = 90;
    formats[1].clockwiseDeg = 270;
    return formats;
}

std::optional<SensorFormat> determinedFormat(int fromWidthPx, int fromHeightPx, int toWidthPx, int toHeightPx)
{
    const auto formats = sensorFormats(fromWidthPx, fromHeightPx, toWidthPx, toHeightPx);
    return formats.size() == 1 && formats.front().isDetermined() ? std::optional(formats.front())
                                                                 : std::nullopt;
}

Eigen::Vector2d inFormat(const Eigen::Vector2d &pixel, int fromWidthPx, int fromHeightPx,
                         const SensorFormat &format)
{
    Eigen::Vector2d upright = pixel;
    if (format.clockwiseDeg == 90)
        upright = {fromHeightPx - 1 - pixel.y(), pixel.x()};
    else if (format.clockwiseDeg == 270)
        upright = {pixel.y(), fromWidthPx - 1 - pixel.x()};
    return {format.scaleX * (upright.x() + 0.5 - format.cropLeftPx) - 0.5,
            format.scaleY * (upright.y() + 0.5 - format.cropTopPx) - 0.5};
}

Intrinsics inFormat(const Intrinsics &given, const SensorFormat &format)
{
    Intrinsics lens = given;
    lens.widthPx = format.widthPx;
    lens.heightPx = format.heightPx;
    const auto count = static_cast<Eigen::Index>(4 + given.distortion.size());
    Eigen::MatrixXd turn = Eigen::MatrixXd::Identity(count, count);
    if (format.clockwiseDeg != 0) {
        turn.topLeftCorner<4, 4>().setZero();
        turn(0, 1) = turn(1, 0) = 1;
        // a clockwise quarter turn takes (x, y) to (−y, x), the other one to (y, −x)
        const double way = format.clockwiseDeg == 90 ? 1 : -1;
        turn(2, 3) = -way;
        turn(3, 2) = way;
        if (given.model != LensModel::Fisheye && count >= 8) { // (p2, p1) turns as a vector
            turn.block<2, 2>(6, 6).setZero();
            turn(7, 6) = -way;
            turn(6, 7) = way;
        }
    }
    Eigen::MatrixXd scale = Eigen::MatrixXd::Identity(count, count);
    scale(0, 0) = scale(2, 2) = format.scaleX;
    scale(1, 1) = scale(3, 3) = format.scaleY;
    const Eigen::MatrixXd map = scale * turn;
    Eigen::VectorXd shift = Eigen::VectorXd::Zero(count);
    const Eigen::Vector2d centre =
        inFormat(Eigen::Vector2d(given.cxPx, given.cyPx), given.widthPx, given.heightPx, format);
    shift.segment<2>(2) = centre - (map * valuesOf(given)).segment<2>(2);
    mapValues(lens, map, shift);
    return lens;
}

Intrinsics enlarged(const Intrinsics &given, double factor)
{
    Intrinsics lens = given;
    const auto count = static_cast<Eigen::Index>(4 + given.distortion.size());
    Eigen::MatrixXd map = Eigen::MatrixXd::Identity(count, count);
    map.topLeftCorner<4, 4>() *= factor;
    Eigen::VectorXd shift = Eigen::VectorXd::Zero(count);
    shift[2] = (1 - factor) * (given.widthPx - 1) / 2;
    shift[3] = (1 - factor) * (given.heightPx - 1) / 2;
    mapValues(lens, map, shift);
    return lens;
}

Intrinsics withEnlargementSigma(Intrinsics lens, double sigma)
{
    const auto count = static_cast<Eigen::Index>(4 + lens.distortion.size());
    if (lens.covariance.size() == 0)
        lens.covariance = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(count);
    direction.head<4>() << lens.fxPx, lens.fyPx, lens.cxPx - (lens.widthPx - 1) / 2.0,
        lens.cyPx - (lens.heightPx - 1) / 2.0;
    lens.covariance += sigma * sigma * direction * direction.transpose();
    return lens;
}

Intrinsics meanOf(const Intrinsics &one, const Intrinsics &other)
{
    Intrinsics lens = one;
    const Eigen::VectorXd half = (valuesOf(other) - valuesOf(one)) / 2;
    setValues(lens, valuesOf(one) + half);
    if (one.covariance.size() == 0)
        lens.covariance = Eigen::MatrixXd::Zero(half.size(), half.size());
    else if (one.covariance.size() == other.covariance.size())
        lens.covariance = (one.covariance + other.covariance) / 2;
    lens.covariance += half * half.transpose();
    return lens;
}

} // namespace odo
