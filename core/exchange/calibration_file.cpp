// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/calibration_file.h"

#include "core/base/units.h"
#include "core/exchange/internal/calibration_entry.h"
#include "core/exchange/internal/calibration_tree.h"
#include "core/exchange/text_file.h"
#include "core/files/output_file.h"

#include <algorithm>
#include <iterator>

namespace odo {

namespace {

bool isCalled(const CalibrationEntry &entry, const std::string &name)
{
    return !name.empty() && (entry.name == name || entry.key == name);
}

std::string nameOf(const CalibrationEntry &entry)
{
    return entry.name.empty() ? entry.key : entry.name;
}

std::vector<std::string> namesOf(const std::vector<CalibrationEntry> &entries)
{
    std::vector<std::string> names;
    std::ranges::transform(entries, std::back_inserter(names), nameOf);
    return names;
}

} // namespace

Result<ImportedIntrinsics> parseCalibration(const std::filesystem::path &file, const std::string &text,
                                            const std::string &entry)
{
    const auto root = ODO_TRY(parseCalibrationTree(file, text, useCalibrationFile()));
    const std::vector<CalibrationEntry> entries = calibrationEntries(root);
    const auto wanted =
        entry.empty() && entries.size() == 1
            ? entries.begin()
            : std::ranges::find_if(entries, [&entry](const auto &one) { return isCalled(one, entry); });
    if (wanted != entries.end())
        return readCalibrationEntry(file, *wanted);
    const MessageArgument all = listed(namesOf(entries), MessageArgument::Kind::Camera);
    return fail(ErrorCode::InvalidInput, atLine(file, 1),
                entry.empty()
                    ? ODO_TEXT("exchange.several_cameras", "it holds several cameras: %1")(all)
                    : ODO_TEXT("exchange.no_such_entry", "it holds no camera '%1', but %2")(entry, all),
                ODO_TEXT("exchange.choose_entry", "choose one of them"));
}

Result<ImportedIntrinsics> readCalibrationFile(const std::filesystem::path &file, const std::string &entry)
{
    const auto text = ODO_TRY(readTextFile(file));
    return parseCalibration(file, text, entry);
}

Result<std::vector<std::string>> camerasInCalibration(const std::filesystem::path &file)
{
    const auto text = ODO_TRY(readTextFile(file));
    const auto root = ODO_TRY(parseCalibrationTree(file, text, useCalibrationFile()));
    return namesOf(calibrationEntries(root));
}

Result<Intrinsics> readIntrinsics(const std::filesystem::path &file, const std::string &entry)
{
    auto imported = ODO_TRY(readCalibrationFile(file, entry));
    return std::move(imported.intrinsics);
}

namespace {

/// With a point, so that every reader takes it as a floating-point number.
std::string realText(double value)
{
    const std::string text = numberText(value);
    return text.find('.') == std::string::npos ? text + ".0" : text;
}

std::string matrixText(const char *name, const char *tag, int rows, const std::vector<double> &values)
{
    const int cols = rows == 0 ? 0 : static_cast<int>(values.size()) / rows;
    std::string text = std::string(name) + ":" + tag + "\n  rows: " + std::to_string(rows) +
                       "\n  cols: " + std::to_string(cols) + "\n" + (*tag == '\0' ? "" : "  dt: d\n") +
                       "  data: [";
    for (std::size_t i = 0; i < values.size(); ++i)
        text += (i == 0 ? "" : ", ") + realText(values[i]);
    return text + "]\n";
}

std::vector<double> cameraMatrix(const Intrinsics &k)
{
    return {k.fxPx, 0, k.cxPx, 0, k.fyPx, k.cyPx, 0, 0, 1};
}

const char *rosModelName(LensModel model)
{
    switch (model) {
    case LensModel::Rational:
        return "rational_polynomial";
    case LensModel::Fisheye:
        return "equidistant";
    case LensModel::Standard:
        break;
    }
    return "plumb_bob";
}

/// A name as a YAML scalar: quoted, because it may hold anything that people type, on one line.
std::string quoted(const std::string &name)
{
    std::string text = "'";
    for (const char c : name)
        text += c == '\'' ? '"' : static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    return text + "'";
}

std::string imageSizePx(const Intrinsics &k)
{
    return "image_width: " + std::to_string(k.widthPx) + "\nimage_height: " + std::to_string(k.heightPx) +
           "\n";
}

} // namespace

std::string intrinsicsText(const std::string &cameraName, const Intrinsics &intrinsics,
                           IntrinsicsFormat format)
{
    std::vector<double> distortion = intrinsics.distortion;
    if (distortion.empty()) // neither program reads an empty matrix
        distortion.assign(intrinsics.model == LensModel::Rational  ? 8
                          : intrinsics.model == LensModel::Fisheye ? 4
                                                                   : 5,
                          0.0);
    if (format == IntrinsicsFormat::OpenCv) {
        const std::string fisheye = intrinsics.model == LensModel::Fisheye ? "fisheye_model: 1\n" : "";
        return "%YAML:1.0\n---\n" + imageSizePx(intrinsics) + "camera_name: " + quoted(cameraName) + "\n" +
               fisheye + matrixText("camera_matrix", " !!opencv-matrix", 3, cameraMatrix(intrinsics)) +
               matrixText("distortion_coefficients", " !!opencv-matrix", 1, distortion);
    }
    const Intrinsics &k = intrinsics;
    return imageSizePx(k) + "camera_name: " + quoted(cameraName) + "\n" +
           matrixText("camera_matrix", "", 3, cameraMatrix(k)) +
           "distortion_model: " + rosModelName(k.model) + "\n" +
           matrixText("distortion_coefficients", "", 1, distortion) +
           matrixText("rectification_matrix", "", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}) +
           matrixText("projection_matrix", "", 3, {k.fxPx, 0, k.cxPx, 0, 0, k.fyPx, k.cyPx, 0, 0, 0, 1, 0});
}

Result<void> writeIntrinsics(const OutputTarget &target, const std::string &cameraName,
                             const Intrinsics &intrinsics, IntrinsicsFormat format)
{
    return writeOutput(target, intrinsicsText(cameraName, intrinsics, format));
}

Result<void> writeIntrinsics(const OutputTarget &target, const std::string &cameraName,
                             const Intrinsics &intrinsics)
{
    return writeIntrinsics(target, cameraName, intrinsics,
                           target.file.extension() == ".yml" ? IntrinsicsFormat::OpenCv
                                                             : IntrinsicsFormat::Ros);
}

} // namespace odo
