// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/intrinsics_yaml.h"
#include "core/exchange/text_file.h"
#include "core/files/output_file.h"

namespace odo {

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

/// A name as a YAML scalar: quoted, because it may hold anything that people type.
std::string quoted(const std::string &name)
{
    std::string text = "'";
    for (const char c : name)
        text += c == '\'' ? '"' : c;
    return text + "'";
}

std::string pictureSize(const Intrinsics &k)
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
        return "%YAML:1.0\n---\n" + pictureSize(intrinsics) + "camera_name: " + quoted(cameraName) + "\n" +
               fisheye + matrixText("camera_matrix", " !!opencv-matrix", 3, cameraMatrix(intrinsics)) +
               matrixText("distortion_coefficients", " !!opencv-matrix", 1, distortion);
    }
    const Intrinsics &k = intrinsics;
    return pictureSize(k) + "camera_name: " + quoted(cameraName) + "\n" +
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
                           target.file.extension() == ".yml" ? IntrinsicsFormat::OpenCv : IntrinsicsFormat::Ros);
}

} // namespace odo
