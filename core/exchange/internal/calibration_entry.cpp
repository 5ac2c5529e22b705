// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/internal/calibration_entry.h"

#include "core/base/plain_text.h"
#include "core/base/units.h"
#include "core/exchange/text_file.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace odo {

namespace {

using Names = std::vector<std::string_view>;

constexpr int maxImagePx = 100'000;

// The first of each is what errors call it.
const Names matrixNames{"camera_matrix",
                        "cameraMatrix",
                        "cameraIntrinsics",
                        "intrinsic_matrix",
                        "matrix",
                        "intrinsics",
                        "mtx",
                        "k"};
const Names distortionNames{"distortion_coefficients",
                            "distCoeffs",
                            "distortion_coeffs",
                            "distortions",
                            "dist_coeffs",
                            "dist_coeff",
                            "dist",
                            "d"};
const Names widthNames{"image_width", "width"};
const Names heightNames{"image_height", "height"};
const Names sizeNames{"resolution", "size", "image_size", "img_size"};

const YamlNode *findAny(const YamlNode &parent, const Names &names)
{
    for (const std::string_view name : names)
        for (const YamlEntry &entry : parent.entries)
            if (lowerCaseAscii(entry.key) == lowerCaseAscii(name))
                return &entry.value;
    return nullptr;
}

std::string textOf(const YamlNode &parent, const Names &names)
{
    const YamlNode *found = findAny(parent, names);
    return found ? found->text : std::string();
}

/// Takes a calibration out of a parsed file; errors name the line of the entry.
class CalibrationReader
{
public:
    CalibrationReader(const std::filesystem::path &file, const YamlNode &root) : m_file(file), m_root(root) {}

    Result<ImportedIntrinsics> read()
    {
        ImportedIntrinsics imported;
        for (auto step : {&CalibrationReader::checkProjection, &CalibrationReader::readSize,
                          &CalibrationReader::readMatrix, &CalibrationReader::readLens,
                          &CalibrationReader::checkPossible}) {
            ODO_TRY((this->*step)(imported.intrinsics));
        }
        imported.cameraName = textOf(m_root, {"camera_name", "name"});
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

    Result<const YamlNode *> entry(const YamlNode &parent, const Names &names) const
    {
        if (const YamlNode *found = findAny(parent, names))
            return found;
        return failure(parent.line, entryIsMissing(std::string(names.front())));
    }

    Result<double> number(const YamlNode &node, const std::string &name) const
    {
        std::string text = node.text;
        const auto value = parseNumber(text.ends_with('.') ? text + "0" : text); // OpenCV writes "0."
        if (node.kind != YamlNode::Kind::Scalar || !value)
            return failure(node.line, notAFiniteNumber(name));
        return *value;
    }

    Result<int> wholeNumber(const YamlNode &node, const std::string &name, int from, int to) const
    {
        const auto value = ODO_TRY(number(node, name));
        if (value < from || value > to || value != static_cast<int>(value))
            return failure(node.line, ODO_TEXT("exchange.not_a_whole_number",
                                               "'%1' is not a whole number from %2 to %3")(name, from, to));
        return static_cast<int>(value);
    }

    Result<int> wholeEntry(const YamlNode &parent, const Names &names, int from, int to) const
    {
        const auto node = ODO_TRY(entry(parent, names));
        return wholeNumber(*node, std::string(names.front()), from, to);
    }

    /// Those of a list, or of a list of rows.
    Result<void> addNumbers(const YamlNode &list, const std::string &name, std::vector<double> &values) const
    {
        for (const YamlNode &item : list.items) {
            if (item.kind == YamlNode::Kind::Sequence)
                ODO_TRY(addNumbers(item, name, values));
            else
                values.push_back(ODO_TRY(number(item, name)));
        }
        return {};
    }

    struct Matrix
    {
        int line = 0;
        std::optional<int> rows, cols; ///< where the file tells them
        std::vector<double> values;
    };

    /// rows, cols and data, or the numbers alone.
    Result<Matrix> matrix(const YamlNode &node, const std::string &name) const
    {
        Matrix read{node.line, {}, {}, {}};
        const YamlNode *data = &node;
        if (node.kind == YamlNode::Kind::Mapping) {
            read.rows = ODO_TRY(wholeEntry(node, {"rows"}, 0, 100));
            read.cols = ODO_TRY(wholeEntry(node, {"cols"}, 0, 100));
            data = ODO_TRY(entry(node, {"data"}));
            read.line = data->line;
        }
        if (data->kind == YamlNode::Kind::Scalar) // array('d', [...]), as Python prints it
            return failure(data->line,
                           ODO_TEXT("exchange.no_list_of_numbers", "'%1' is not a list of numbers")(name));
        ODO_TRY(addNumbers(*data, name, read.values));
        return read;
    }

    /// Kalibr's other models have other numbers, too.
    Result<void> checkProjection(Intrinsics &)
    {
        const YamlNode *projection = m_root.find("camera_model");
        return projection && projection->text != "pinhole" ? unknownLens(*projection) : Result<void>();
    }

    tl::unexpected<Error> unknownLens(const YamlNode &given) const
    {
        return failure(
            given.line,
            ODO_TEXT(
                "exchange.lens_model_not_known",
                "the lens model '%1' is unknown (known models: plumb_bob, rational_polynomial, equidistant)")(
                given.text.substr(0, 40)));
    }

    Result<void> readSize(Intrinsics &into)
    {
        const YamlNode *size = findAny(m_root, sizeNames);
        m_isSizeList = size && size->items.size() == 2;
        if (m_isSizeList) {
            into.widthPx = ODO_TRY(wholeNumber(size->items[0], "image_width", 1, maxImagePx));
            into.heightPx = ODO_TRY(wholeNumber(size->items[1], "image_height", 1, maxImagePx));
            return {};
        }
        const YamlNode &parent = size && size->kind == YamlNode::Kind::Mapping ? *size : m_root;
        into.widthPx = ODO_TRY(wholeEntry(parent, widthNames, 1, maxImagePx));
        into.heightPx = ODO_TRY(wholeEntry(parent, heightNames, 1, maxImagePx));
        return {};
    }

    Result<void> readMatrix(Intrinsics &into)
    {
        const auto node = ODO_TRY(entry(m_root, matrixNames));
        const auto read = ODO_TRY(matrix(*node, "camera_matrix"));
        const std::vector<double> &k = read.values;
        if (node->kind == YamlNode::Kind::Sequence && k.size() == 4) { // as Kalibr writes them
            into.fxPx = k[0];
            into.fyPx = k[1];
            into.cxPx = k[2];
            into.cyPx = k[3];
            return {};
        }
        const int rows = read.rows.value_or(3), cols = read.cols.value_or(3);
        if (k.size() != std::size_t(rows) * std::size_t(cols))
            return failure(read.line, ODO_TEXT("exchange.wrong_number_of_numbers",
                                               "'%1' has %2 numbers instead of %3 × %4")(
                                          std::string("camera_matrix"), k.size(), rows, cols));
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

    Result<void> readLens(Intrinsics &into)
    {
        if (textOf(m_root, {"distortion_model"}) == "none")
            return {};
        const auto node = ODO_TRY(entry(m_root, distortionNames));
        auto read = ODO_TRY(matrix(*node, "distortion_coefficients"));
        // Of eight coefficients some programs say that they are five columns: the numbers themselves count.
        if (read.rows.value_or(1) > 1 && read.cols.value_or(1) > 1)
            return failure(node->line, ODO_TEXT("exchange.coefficients_no_row",
                                                "'distortion_coefficients' is neither a row nor a column"));
        std::vector<double> &coefficients = read.values;
        const auto model = ODO_TRY(lensModel(coefficients.size()));
        // Further coefficients of OpenCV (thin prism, tilt) may be there as long as they do nothing.
        const std::size_t known = model == LensModel::Standard ? 5 : model == LensModel::Rational ? 8 : 4;
        while (coefficients.size() > known && coefficients.back() == 0)
            coefficients.pop_back();
        into.model = model;
        into.distortion = std::move(coefficients);
        return {};
    }

    Result<LensModel> lensModel(std::size_t count) const
    {
        const YamlNode *given = m_root.find("distortion_model");
        if (given == nullptr) { // OpenCV: given by the number of coefficients
            const std::string fisheye = textOf(m_root, {"fisheye_model", "fisheye"});
            if (!fisheye.empty() && fisheye != "0" && fisheye != "false")
                return LensModel::Fisheye;
            return count > 5 ? LensModel::Rational : LensModel::Standard;
        }
        const auto is = [given](const Names &names) {
            return std::ranges::find(names, given->text) != names.end();
        };
        if (is({"plumb_bob", "radtan", "radial-tangential", "rectilinear"}) ||
            (given->text.empty() && count == 0))
            return LensModel::Standard;
        if (is({"rational_polynomial"}))
            return LensModel::Rational;
        if (is({"equidistant", "fisheye", "kannala_brandt"}))
            return LensModel::Fisheye;
        return unknownLens(*given);
    }

    /// Where the image centre is far off, but in the middle of an image with exchanged sides.
    static bool isTurned(const Intrinsics &read)
    {
        constexpr double farOff = 0.12, near = 0.08; // of the side
        const auto off = [&](double width, double height) {
            return std::max(std::abs(read.cxPx / width - 0.5), std::abs(read.cyPx / height - 0.5));
        };
        return off(read.widthPx, read.heightPx) > farOff && off(read.heightPx, read.widthPx) < near;
    }

    /// What no camera has: a lens that sees nothing, or all but nothing, of what is before it.
    Result<void> checkPossible(Intrinsics &read)
    {
        constexpr double shortest = 0.05, longest = 1000; // times the larger side
        const double side = std::max(read.widthPx, read.heightPx);
        for (const double focal : {read.fxPx, read.fyPx})
            if (focal > 0 && (focal < shortest * side || focal > longest * side))
                return failure(m_root.line, ODO_TEXT("exchange.focal_impossible",
                                                     "no lens has a focal length of %1 at %2 × %3 pixels")(
                                                quantity(focal, 3, "px"), read.widthPx, read.heightPx));
        if (m_isSizeList && isTurned(read)) // of an array, programs write the height first
            return failure(
                m_root.line,
                ODO_TEXT("exchange.sides_exchanged",
                         "its width and height are exchanged: the image centre (%1, %2) is that of %4 × %3 "
                         "pixels, not %3 × %4")(quantity(read.cxPx, 1), quantity(read.cyPx, 1), read.widthPx,
                                                read.heightPx));
        constexpr double farthest = 10; // times the side, of a strongly cropped image
        if (std::abs(read.cxPx) > farthest * side || std::abs(read.cyPx) > farthest * side)
            return failure(m_root.line,
                           ODO_TEXT("exchange.centre_impossible",
                                    "the image centre (%1, %2) is far outside the image of %3 × %4 pixels")(
                               quantity(read.cxPx, 1), quantity(read.cyPx, 1), read.widthPx, read.heightPx));
        return {};
    }

    const std::filesystem::path &m_file;
    const YamlNode &m_root;
    bool m_isSizeList = false; ///< two numbers without names
};

} // namespace

Message useCalibrationFile()
{
    return ODO_TEXT("exchange.use_calibration_file",
                    "use a calibration file as ROS, OpenCV, Kalibr, COLMAP, Metashape, anipose or "
                    "PhotonVision writes it");
}

std::vector<CalibrationEntry> calibrationEntries(const YamlNode &root)
{
    std::vector<CalibrationEntry> found;
    const auto addBelow = [&found](const YamlNode &parent) {
        for (const YamlEntry &entry : parent.entries)
            if (findAny(entry.value, matrixNames))
                found.push_back({entry.key, textOf(entry.value, {"camera_name", "name"}), &entry.value});
    };
    if (!findAny(root, matrixNames)) {
        addBelow(root);
        if (found.empty())
            for (const YamlEntry &entry : root.entries)
                addBelow(entry.value);
    }
    if (found.empty())
        found.push_back({"", "", &root});
    return found;
}

Result<ImportedIntrinsics> readCalibrationEntry(const std::filesystem::path &file,
                                                const CalibrationEntry &entry)
{
    auto read = ODO_TRY(CalibrationReader(file, *entry.node).read());
    if (read.cameraName.empty())
        read.cameraName = entry.key;
    return read;
}

} // namespace odo
