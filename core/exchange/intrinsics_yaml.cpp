// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/intrinsics_yaml.h"

#include "core/base/units.h"
#include "core/exchange/internal/yaml_document.h"
#include "core/exchange/text_file.h"
#include "core/files/output_file.h"

#include <array>

namespace odo {

namespace {

constexpr int maxImagePx = 100'000;

Message useCalibrationFile()
{
    return ODO_TEXT("exchange.use_calibration_file", "use a calibration file as ROS or OpenCV writes it");
}

/// Takes a calibration out of a parsed file; errors name the line of the entry.
class CalibrationReader
{
public:
    CalibrationReader(const std::filesystem::path &file, const YamlNode &root) : m_file(file), m_root(root) {}

    Result<ImportedIntrinsics> read()
    {
        ImportedIntrinsics imported;
        for (auto step : {&CalibrationReader::readSize, &CalibrationReader::readMatrix,
                          &CalibrationReader::parseIntrinsics}) {
            ODO_TRY((this->*step)(imported.intrinsics));
        }
        if (const YamlNode *name = m_root.find("camera_name"))
            imported.cameraName = name->text;
        if (const YamlNode *error = m_root.find("avg_reprojection_error")) {
            imported.reprojectionPx = ODO_TRY(number(*error, "avg_reprojection_error"));
        }
        if (const auto usable = CameraModel::create(imported.intrinsics); !usable)
            return failure(m_root.line, usable.error().why);
        return imported;
    }

private:
    tl::unexpected<Error> failure(int line, Message why) const
    {
        return fail(ErrorCode::InvalidInput, atLine(m_file, line), std::move(why), useCalibrationFile());
    }

    Result<const YamlNode *> entry(const YamlNode &parent, const std::string &key) const
    {
        if (const YamlNode *found = parent.find(key))
            return found;
        return failure(parent.line, entryIsMissing(key));
    }

    Result<double> number(const YamlNode &node, const std::string &name) const
    {
        std::string text = node.text;
        const auto value = parseNumber(text.ends_with('.') ? text + "0" : text); // OpenCV writes "0."
        if (node.kind != YamlNode::Kind::Scalar || !value)
            return failure(node.line, notAFiniteNumber(name));
        return *value;
    }

    Result<int> wholeNumber(const YamlNode &parent, const std::string &key, int from, int to) const
    {
        const auto node = ODO_TRY(entry(parent, key));
        const auto value = ODO_TRY(number(*node, key));
        if (value < from || value > to || value != static_cast<int>(value))
            return failure(node->line, ODO_TEXT("exchange.not_a_whole_number",
                                                "'%1' is not a whole number from %2 to %3")(key, from, to));
        return static_cast<int>(value);
    }

    /// rows, cols and data, which must agree.
    Result<std::vector<double>> matrix(const YamlNode &node, const std::string &name, int &rows,
                                       int &cols) const
    {
        const auto givenRows = wholeNumber(node, "rows", 0, 100);
        const auto givenCols = ODO_TRY(givenRows ? wholeNumber(node, "cols", 0, 100) : givenRows);
        rows = *givenRows;
        cols = givenCols;
        const auto data = ODO_TRY(entry(node, "data"));
        const auto count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols);
        if (data->items.size() != count)
            return failure(data->line, ODO_TEXT("exchange.wrong_number_of_numbers",
                                                "'%1' has %2 numbers instead of %3 × %4")(
                                           name, data->items.size(), rows, cols));
        std::vector<double> values;
        for (const YamlNode &item : data->items) {
            values.push_back(ODO_TRY(number(item, name)));
        }
        return values;
    }

    Result<void> readSize(Intrinsics &into)
    {
        const auto width = wholeNumber(m_root, "image_width", 1, maxImagePx);
        const auto height = ODO_TRY(width ? wholeNumber(m_root, "image_height", 1, maxImagePx) : width);
        into.widthPx = *width;
        into.heightPx = height;
        return {};
    }

    Result<void> readMatrix(Intrinsics &into)
    {
        const auto node = ODO_TRY(entry(m_root, "camera_matrix"));
        int rows = 0, cols = 0;
        const auto k = ODO_TRY(matrix(*node, "camera_matrix", rows, cols));
        if (rows != 3 || cols != 3)
            return failure(node->line,
                           ODO_TEXT("exchange.matrix_not_3_by_3", "'camera_matrix' is not a 3 × 3 matrix"));
        const std::array<std::size_t, 4> zeros = {1, 3, 6, 7};
        if (std::any_of(zeros.begin(), zeros.end(), [&k](std::size_t i) { return k[i] != 0; }) || k[8] != 1)
            return failure(node->line,
                           ODO_TEXT("exchange.matrix_of_other_form",
                                    "'camera_matrix' is not of the form fx 0 cx, 0 fy cy, 0 0 1"));
        into.fxPx = k[0];
        into.cxPx = k[2];
        into.fyPx = k[4];
        into.cyPx = k[5];
        return {};
    }

    Result<void> parseIntrinsics(Intrinsics &into)
    {
        const auto node = ODO_TRY(entry(m_root, "distortion_coefficients"));
        int rows = 0, cols = 0;
        auto coefficients = ODO_TRY(matrix(*node, "distortion_coefficients", rows, cols));
        if (rows > 1 && cols > 1)
            return failure(node->line, ODO_TEXT("exchange.coefficients_no_row",
                                                "'distortion_coefficients' is neither a row nor a column"));
        const auto model = ODO_TRY(lensModel(node->line, coefficients.size()));
        // Further coefficients of OpenCV (thin prism, tilt) may be there as long as they do nothing.
        const std::size_t known = model == LensModel::Standard ? 5 : model == LensModel::Rational ? 8 : 4;
        while (coefficients.size() > known && coefficients.back() == 0)
            coefficients.pop_back();
        into.model = model;
        into.distortion = std::move(coefficients);
        return {};
    }

    Result<LensModel> lensModel(int line, std::size_t count) const
    {
        const YamlNode *given = m_root.find("distortion_model");
        if (given == nullptr) { // OpenCV: given by the number of coefficients
            const YamlNode *fisheye = m_root.find("fisheye_model");
            if (fisheye != nullptr && fisheye->text != "0")
                return LensModel::Fisheye;
            return count > 5 ? LensModel::Rational : LensModel::Standard;
        }
        if (given->text == "plumb_bob" || (given->text.empty() && count == 0))
            return LensModel::Standard;
        if (given->text == "rational_polynomial")
            return LensModel::Rational;
        if (given->text == "equidistant" || given->text == "fisheye")
            return LensModel::Fisheye;
        return failure(
            given->line == 0 ? line : given->line,
            ODO_TEXT(
                "exchange.lens_model_not_known",
                "the lens model '%1' is unknown (known models: plumb_bob, rational_polynomial, equidistant)")(
                given->text.substr(0, 40)));
    }

    const std::filesystem::path &m_file;
    const YamlNode &m_root;
};

} // namespace

Result<ImportedIntrinsics> parseCalibration(const std::filesystem::path &file, const std::string &text)
{
    const auto root = ODO_TRY(parseYaml(file, text, useCalibrationFile()));
    return CalibrationReader(file, root).read();
}

Result<ImportedIntrinsics> readCalibrationFile(const std::filesystem::path &file)
{
    const auto text = ODO_TRY(readTextFile(file));
    return parseCalibration(file, text);
}

Result<Intrinsics> readIntrinsics(const std::filesystem::path &file)
{
    auto imported = ODO_TRY(readCalibrationFile(file));
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

/// A name as a YAML scalar: quoted, because it may hold anything that people type.
std::string quoted(const std::string &name)
{
    std::string text = "'";
    for (const char c : name)
        text += c == '\'' ? '"' : c;
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
