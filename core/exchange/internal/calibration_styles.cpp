// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/internal/calibration_styles.h"

#include "core/base/units.h"
#include "core/exchange/text_file.h"

#include <QXmlStreamReader>
#include <algorithm>
#include <array>

namespace odo {

namespace {

constexpr double cornerToCentrePx = 0.5; // COLMAP and Metashape count from the corner of the first pixel

YamlNode mappingNode(int line)
{
    YamlNode node;
    node.kind = YamlNode::Kind::Mapping;
    node.line = line;
    return node;
}

YamlNode listOf(const std::vector<std::string> &texts, int line)
{
    YamlNode node;
    node.kind = YamlNode::Kind::Sequence;
    node.line = line;
    for (const std::string &text : texts)
        node.items.push_back(scalarNode(text, line));
    return node;
}

std::vector<std::string_view> partsOf(std::string_view line)
{
    std::vector<std::string_view> words;
    splitCells(line, line.find(',') == std::string_view::npos ? ' ' : ',', words);
    return words;
}

/// How COLMAP orders a model's numbers: one focal length or two, the centre, coefficients.
struct ColmapModel
{
    std::string_view name;
    std::size_t focals, coefficients;
    std::string_view lens; ///< as ROS calls it
};
constexpr std::array<ColmapModel, 9> colmapModels{{{"SIMPLE_PINHOLE", 1, 0, "none"},
                                                   {"PINHOLE", 2, 0, "none"},
                                                   {"SIMPLE_RADIAL", 1, 1, "plumb_bob"},
                                                   {"RADIAL", 1, 2, "plumb_bob"},
                                                   {"OPENCV", 2, 4, "plumb_bob"},
                                                   {"FULL_OPENCV", 2, 8, "rational_polynomial"},
                                                   {"SIMPLE_RADIAL_FISHEYE", 1, 1, "equidistant"},
                                                   {"RADIAL_FISHEYE", 1, 2, "equidistant"},
                                                   {"OPENCV_FISHEYE", 2, 4, "equidistant"}}};
constexpr std::size_t wordsBefore = 4, fewestCoefficients = 4; // number, model, width, height

bool isColmapLine(const std::vector<std::string_view> &words)
{
    const auto consistsOf = [](std::string_view word, std::string_view letters) {
        return !word.empty() && word.find_first_not_of(letters) == std::string_view::npos;
    };
    return words.size() > wordsBefore + 2 && consistsOf(words[0], "0123456789") &&
           consistsOf(words[1], "ABCDEFGHIJKLMNOPQRSTUVWXYZ_") && consistsOf(words[2], "0123456789") &&
           consistsOf(words[3], "0123456789");
}

/// A coordinate of the image centre, from the centre of the first pixel; what is no number stays as it is.
std::string fromPixelCentre(std::string_view text, double from = 0)
{
    const auto value = parseNumber(std::string(text));
    return value ? numberText(from + *value - cornerToCentrePx) : std::string(text);
}

YamlNode colmapCamera(const std::vector<std::string_view> &words, int line)
{
    YamlNode camera = mappingNode(line);
    const auto add = [&](const char *name, YamlNode value) {
        camera.entries.push_back({name, std::move(value)});
    };
    add("image_width", scalarNode(std::string(words[2]), line));
    add("image_height", scalarNode(std::string(words[3]), line));
    const auto model = std::ranges::find(colmapModels, words[1], &ColmapModel::name);
    const bool isKnown =
        model != colmapModels.end() && words.size() == wordsBefore + model->focals + 2 + model->coefficients;
    const std::size_t focals = isKnown ? model->focals : 1;
    const std::string fx(words[wordsBefore]), fy(words[wordsBefore + focals - 1]);
    add("camera_matrix",
        listOf({fx, fy, fromPixelCentre(words[wordsBefore + focals]),
                fromPixelCentre(words[std::min(words.size() - 1, wordsBefore + focals + 1)])},
               line));
    add("distortion_model", scalarNode(std::string(isKnown ? model->lens : words[1]), line));
    std::vector<std::string> coefficients;
    for (std::size_t i = wordsBefore + focals + 2; isKnown && i < words.size(); ++i)
        coefficients.emplace_back(words[i]);
    coefficients.resize(std::max(coefficients.size(), fewestCoefficients), "0");
    add("distortion_coefficients", listOf(coefficients, line));
    return camera;
}

/// Walks through XML; gives up where a file is nested deeper, or holds more, than any calibration.
class XmlTree
{
public:
    explicit XmlTree(const std::string &text) : m_reader(QByteArray::fromStdString(text)) {}

    /// Of the outermost element; nothing where that fails.
    std::optional<YamlNode> read()
    {
        if (!m_reader.readNextStartElement())
            return std::nullopt;
        const std::string name = m_reader.name().toString().toStdString();
        YamlNode root = mappingNode(1);
        YamlNode content = element(0);
        while (!m_reader.atEnd() && !m_reader.hasError())
            m_reader.readNext();
        if (m_reader.hasError() || m_left == 0)
            return std::nullopt;
        root.entries.push_back({name, std::move(content)});
        return root;
    }
    std::string whatFailed() const { return m_reader.errorString().toStdString(); }
    int line() const { return int(m_reader.lineNumber()); }

private:
    YamlNode element(int depth)
    {
        constexpr int deepest = 16;
        YamlNode node = mappingNode(line());
        if (m_left > 0)
            --m_left;
        if (depth > deepest)
            m_left = 0;
        if (m_left == 0) {
            m_reader.raiseError(QStringLiteral("too large"));
            return node;
        }
        for (const QXmlStreamAttribute &attribute : m_reader.attributes())
            node.entries.push_back({attribute.name().toString().toStdString(),
                                    scalarNode(attribute.value().toString().toStdString(), node.line)});
        std::string text;
        bool hasElements = false;
        while (!m_reader.atEnd() && m_reader.readNext() != QXmlStreamReader::EndElement) {
            if (m_reader.isStartElement()) {
                hasElements = true;
                const std::string name = m_reader.name().toString().toStdString();
                node.entries.push_back({name, element(depth + 1)});
            } else if (m_reader.isCharacters()) {
                text += m_reader.text().toString().toStdString();
            }
        }
        return hasElements ? node : leaf(std::move(text), std::move(node));
    }

    YamlNode leaf(std::string text, YamlNode element)
    {
        std::ranges::replace_if(
            text, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
        const std::string_view content = withoutBlanks(text);
        if (content.empty() && !element.entries.empty())
            return element; // attributes alone
        const std::vector<std::string_view> words = partsOf(content);
        const auto isNumber = [](std::string_view word) {
            return word.find_first_not_of("0123456789+-.eE") == std::string_view::npos;
        };
        if (words.size() < 2 || !std::ranges::all_of(words, isNumber))
            return scalarNode(std::string(content), element.line);
        m_left -= std::min(m_left, words.size());
        return listOf({words.begin(), words.end()}, element.line);
    }

    QXmlStreamReader m_reader;
    std::size_t m_left = 100'000;
};

std::string textAt(const YamlNode &node, std::string_view key)
{
    const YamlNode *found = node.find(key);
    return found ? found->text : std::string();
}

/// Agisoft's formulas (Metashape manual, camera models): the centre counts from the middle of the image, the
/// first tangential coefficient is OpenCV's second. What OpenCV does not have must be zero.
YamlNode metashapeCamera(const YamlNode &calibration, const std::string &name)
{
    const int line = calibration.line;
    const YamlNode *resolution = calibration.find("resolution");
    const YamlNode &sized = resolution ? *resolution : calibration;
    const auto valueOf = [&](std::string_view key) {
        return parseNumber(textAt(calibration, key)).value_or(0);
    };
    const auto shown = [&](std::string_view key) {
        const std::string text = textAt(calibration, key);
        return text.empty() ? std::string("0") : text;
    };
    YamlNode camera = mappingNode(line);
    const auto add = [&](const char *entry, YamlNode value) {
        camera.entries.push_back({entry, std::move(value)});
    };
    const std::string width = textAt(sized, "width"), height = textAt(sized, "height"), f = shown("f");
    add("image_width", scalarNode(width, line));
    add("image_height", scalarNode(height, line));
    const std::string fx = valueOf("b1") != 0 ? numberText(valueOf("f") + valueOf("b1")) : f;
    const auto centre = [&](std::string_view key, const std::string &side) {
        return fromPixelCentre(shown(key), parseNumber(side).value_or(0) / 2);
    };
    add("camera_matrix",
        listOf({fx, shown("b2"), centre("cx", width), "0", f, centre("cy", height), "0", "0", "1"}, line));
    std::string type = textAt(calibration, "projection");
    if (type.empty())
        type = textAt(calibration, "type");
    const bool isFisheye = type == "fisheye";
    const std::vector<std::string_view> absent = isFisheye
                                                     ? std::vector<std::string_view>{"p1", "p2", "p3", "p4"}
                                                     : std::vector<std::string_view>{"k4", "p3", "p4"};
    for (const std::string_view key : absent)
        if (valueOf(key) != 0)
            type.append(" + ").append(key);
    add("distortion_model", scalarNode(type == "frame" || type.empty() ? "plumb_bob" : type, line));
    add("distortion_coefficients",
        listOf(isFisheye ? std::vector{shown("k1"), shown("k2"), shown("k3"), shown("k4")}
                         : std::vector{shown("k1"), shown("k2"), shown("p2"), shown("p1"), shown("k3")},
               line));
    if (!name.empty())
        add("camera_name", scalarNode(name, line));
    return camera;
}

/// The calibrations below a node, the adjusted one of each sensor.
void addMetashape(const YamlNode &node, YamlNode &cameras)
{
    const YamlNode *chosen = nullptr;
    for (const YamlEntry &entry : node.entries) {
        if (entry.key == "calibration" && entry.value.find("f"))
            chosen = chosen && textAt(*chosen, "class") == "adjusted" ? chosen : &entry.value;
        else
            addMetashape(entry.value, cameras);
    }
    if (!chosen)
        return;
    const std::string label = textAt(node, "label"), id = textAt(node, "id");
    cameras.entries.push_back({id, metashapeCamera(*chosen, label)});
}

} // namespace

YamlNode scalarNode(std::string text, int line)
{
    YamlNode node;
    node.kind = YamlNode::Kind::Scalar;
    node.text = std::move(text);
    node.line = line;
    return node;
}

std::optional<YamlNode> treeOfColmap(const std::vector<std::string_view> &lines)
{
    YamlNode root = mappingNode(1);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].empty() || lines[i].front() == '#')
            continue;
        const std::vector<std::string_view> words = partsOf(lines[i]);
        if (!isColmapLine(words))
            return std::nullopt;
        root.entries.push_back({std::string(words[0]), colmapCamera(words, int(i) + 1)});
    }
    return root.entries.empty() ? std::nullopt : std::optional(std::move(root));
}

Result<YamlNode> treeOfXml(const std::filesystem::path &file, const std::string &text, const Message &advice)
{
    XmlTree xml(text);
    auto tree = xml.read();
    if (!tree)
        return fail(
            ErrorCode::InvalidInput, atLine(file, std::max(1, xml.line())),
            ODO_TEXT("exchange.no_valid_xml", "it is not valid XML (%1)")(foreignWords(xml.whatFailed())),
            advice);
    YamlNode cameras = mappingNode(1);
    addMetashape(*tree, cameras);
    if (!cameras.entries.empty())
        return cameras;
    return std::move(tree->entries.front().value);
}

} // namespace odo
