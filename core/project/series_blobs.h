// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/video/recorded_times.h"

#include <Eigen/Core>
#include <QByteArray>
#include <span>
#include <string>
#include <vector>

namespace odo {

/// The long series of a project as packed column arrays, laid out as docs/project_file.md says, and back, bit
/// for bit. Of a covariance of pixels or metres the upper triangle is kept (it is symmetric). Reading checks
/// kind, version and length and gives InvalidInput, naming `what`, for anything else. Pure functions, any
/// thread.

/// The most rows a chunk holds: long series are stored in such pieces, of less than a megabyte each.
constexpr std::size_t rowsPerChunk = 8192;

QByteArray packTimes(std::span<const Nanoseconds> times);
Result<void> unpackTimes(const QByteArray &bytes, const std::string &what,
                         std::vector<Nanoseconds> &appendTo);

QByteArray packRawTimes(std::span<const RawTime> pictures);
Result<void> unpackRawTimes(const QByteArray &bytes, const std::string &what, std::vector<RawTime> &appendTo);

QByteArray packClockReadings(std::span<const ClockReading> readings);
Result<void> unpackClockReadings(const QByteArray &bytes, const std::string &what, std::vector<ClockReading> &appendTo);

QByteArray packObservations(std::span<const Observation> observations);
Result<void> unpackObservations(const QByteArray &bytes, const std::string &what,
                                std::vector<Observation> &appendTo);

QByteArray packSamples(std::span<const Sample> samples);
Result<void> unpackSamples(const QByteArray &bytes, const std::string &what, std::vector<Sample> &appendTo);

QByteArray packPoints(std::span<const ProfilePoint> points);
Result<void> unpackPoints(const QByteArray &bytes, const std::string &what, std::vector<ProfilePoint> &appendTo);

/// Of a truth the four vectors must have equal length.
QByteArray packTruth(const TruthSeries &truth);
/// Fills the vectors of `into`.
Result<void> unpackTruth(const QByteArray &bytes, const std::string &what, TruthSeries &into);

/// The corners of a picture of a board with their residuals, and which of them stand out or do not count.
QByteArray packCorners(const CalibrationPicture &picture);
/// Fills in the picture's corners; the rest of it stays.
Result<void> unpackCorners(const QByteArray &bytes, const std::string &what, CalibrationPicture &into);

QByteArray packNumbers(std::span<const double> numbers);
Result<std::vector<double>> unpackNumbers(const QByteArray &bytes, const std::string &what);

/// A square matrix, or an empty one, column by column.
QByteArray packSquare(const Eigen::MatrixXd &matrix);
Result<Eigen::MatrixXd> unpackSquare(const QByteArray &bytes, const std::string &what);

} // namespace odo
