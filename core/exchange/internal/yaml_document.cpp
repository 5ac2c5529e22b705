// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/internal/yaml_document.h"

#include "core/exchange/text_file.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>

namespace odo {

/// The place of the quote that closes the one at `start`, or npos.
std::size_t closingQuote(const std::string &text, std::size_t start);

/// A scalar without its quotes; its escapes (\n, \t, \", \\, \/, \uXXXX, as JSON has them; '' between single
/// quotes) become what they stand for, unknown ones stay as they are. Text without quotes stays as it is.
std::string unquoted(const std::string &text);

namespace {

void appendUtf8(std::string &text, std::uint32_t character)
{
    const auto put = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (character < 0x80) {
        put(character);
    } else if (character < 0x800) {
        put(0xc0 | character >> 6);
        put(0x80 | (character & 0x3f));
    } else if (character < 0x10000) {
        put(0xe0 | character >> 12);
        put(0x80 | (character >> 6 & 0x3f));
        put(0x80 | (character & 0x3f));
    } else {
        put(0xf0 | character >> 18);
        put(0x80 | (character >> 12 & 0x3f));
        put(0x80 | (character >> 6 & 0x3f));
        put(0x80 | (character & 0x3f));
    }
}

/// The four digits of "\uXXXX" at a place.
std::optional<std::uint32_t> codeAt(const std::string &text, std::size_t at)
{
    std::uint32_t code = 0;
    if (at + 6 > text.size() || text[at] != '\\' || text[at + 1] != 'u')
        return std::nullopt;
    const char *first = text.data() + at + 2;
    const auto [end, problem] = std::from_chars(first, first + 4, code, 16);
    return problem == std::errc() && end == first + 4 ? std::optional(code) : std::nullopt;
}

/// Takes one escape; gives how many characters it has, 0 for one that is not known.
std::size_t takeEscape(const std::string &text, std::size_t at, std::string &into)
{
    static constexpr std::string_view letters = "nt\"\\/rbf0", meant("\n\t\"\\/\r\b\f\0", 9);
    const std::size_t known = at + 1 < text.size() ? letters.find(text[at + 1]) : std::string_view::npos;
    if (known != std::string_view::npos) {
        into += meant[known];
        return 2;
    }
    const auto code = codeAt(text, at);
    if (!code)
        return 0;
    const bool isFirstHalf = *code >= 0xd800 && *code < 0xdc00;
    const auto second = isFirstHalf ? codeAt(text, at + 6) : std::nullopt;
    if (isFirstHalf && second && *second >= 0xdc00 && *second < 0xe000) {
        appendUtf8(into, 0x10000 + ((*code - 0xd800) << 10) + (*second - 0xdc00));
        return 12;
    }
    if (*code >= 0xd800 && *code < 0xe000) // half a character
        return 0;
    appendUtf8(into, *code);
    return 6;
}

} // namespace

std::size_t closingQuote(const std::string &text, std::size_t start)
{
    for (std::size_t i = start + 1; i < text.size(); ++i) {
        if (text[start] == '"' && text[i] == '\\')
            ++i;
        else if (text[i] == text[start])
            return i;
    }
    return std::string::npos;
}

std::string unquoted(const std::string &text)
{
    const bool isQuoted = text.size() >= 2 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0];
    if (!isQuoted)
        return text;
    const std::string inner = text.substr(1, text.size() - 2);
    std::string plain;
    for (std::size_t i = 0; i < inner.size();) {
        if (text[0] == '\'' && inner[i] == '\'' && i + 1 < inner.size() && inner[i + 1] == '\'')
            ++i;
        const std::size_t taken = text[0] == '"' && inner[i] == '\\' ? takeEscape(inner, i, plain) : 0;
        if (taken == 0)
            plain += inner[i];
        i += std::max<std::size_t>(taken, 1);
    }
    return plain;
}

namespace {

constexpr int maxDepth = 16;
constexpr int maxNodes = 100'000;

struct Line
{
    int number = 0;
    std::size_t indent = 0;
    std::string content; ///< without indentation, comment and blanks at its end; never empty
    bool tabbed = false; ///< indented with a tab, which is allowed between brackets only
};

std::string trimmed(const std::string &text)
{
    const std::size_t start = text.find_first_not_of(" \t\r");
    return start == std::string::npos ? std::string()
                                      : text.substr(start, text.find_last_not_of(" \t\r") + 1 - start);
}

/// Where a comment begins, or the end: a # after a blank and outside quotes.
std::size_t commentStart(const std::string &text)
{
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != 0) {
            if (c == '\\' && quote == '"')
                ++i;
            else if (c == quote)
                quote = 0;
        } else if ((c == '"' || c == '\'') &&
                   (i == 0 || std::string_view(" \t[{,:").find(text[i - 1]) != std::string_view::npos)) {
            quote = c;
        } else if (c == '#' && (i == 0 || text[i - 1] == ' ' || text[i - 1] == '\t')) {
            return i;
        }
    }
    return text.size();
}

class YamlParser
{
public:
    YamlParser(const std::filesystem::path &file, std::string advice)
        : m_file(file), m_advice(std::move(advice))
    {
    }

    Result<YamlNode> parse(const std::string &text)
    {
        if (auto split = splitLines(text); !split)
            return tl::unexpected(split.error());
        if (m_lines.empty())
            return failure(1, "the file is empty");
        auto root = parseBlock(m_lines.front().indent, 1);
        if (root && m_index < m_lines.size())
            return m_lines[m_index].tabbed ? tabFailure(m_lines[m_index])
                                           : failure(m_lines[m_index].number, "the indentation does not fit");
        return root;
    }

private:
    tl::unexpected<Error> failure(int line, const std::string &why) const
    {
        return fail(ErrorCode::InvalidInput, atLine(m_file, line), why, m_advice);
    }
    tl::unexpected<Error> tabFailure(const Line &line) const
    {
        return failure(line.number, "the line is indented with a tab");
    }

    Result<void> splitLines(const std::string &text)
    {
        int number = 0;
        for (std::size_t start = 0; start < text.size();) {
            const std::size_t end = std::min(text.find('\n', start), text.size());
            const std::string raw = text.substr(start, end - start);
            start = end + 1;
            ++number;
            const std::string content = trimmed(raw.substr(0, commentStart(raw)));
            const bool marker = content == "---" || content.starts_with("%") || content.starts_with("--- ");
            if (content == "...")
                break;
            if (marker && !m_lines.empty())
                return failure(number, "it holds more than one document");
            if (content.empty() || marker)
                continue;
            const std::size_t indent = raw.find_first_not_of(' ');
            m_lines.push_back({number, indent, content, raw[indent] == '\t'});
        }
        return {};
    }

    Result<YamlNode> newNode(YamlNode::Kind kind, int line, int depth)
    {
        if (depth > maxDepth)
            return failure(line, "it is nested more than " + std::to_string(maxDepth) + " deep");
        if (++m_nodes > maxNodes)
            return failure(line, "it holds more than " + std::to_string(maxNodes) + " values");
        YamlNode node;
        node.kind = kind;
        node.line = line;
        return node;
    }

    static bool isItem(const Line &line) { return line.content == "-" || line.content.starts_with("- "); }

    Result<YamlNode> parseBlock(std::size_t indent, int depth)
    {
        const Line &first = m_lines[m_index];
        if (first.tabbed)
            return tabFailure(first);
        if (isItem(first))
            return parseSequence(indent, depth);
        if (keyEnd(first.content) != std::string::npos)
            return parseMapping(indent, depth);
        Line line = first;
        return parseValue(line, 0, depth);
    }

    Result<YamlNode> parseSequence(std::size_t indent, int depth)
    {
        auto node = newNode(YamlNode::Kind::Sequence, m_lines[m_index].number, depth);
        while (node && m_index < m_lines.size() && m_lines[m_index].indent == indent &&
               isItem(m_lines[m_index])) {
            Line &line = m_lines[m_index];
            const std::size_t start = line.content.find_first_not_of(" \t", 1);
            Result<YamlNode> item = newNode(YamlNode::Kind::Null, line.number, depth + 1);
            if (start == std::string::npos) {
                item = parseNested(indent, depth);
            } else {
                // "- key: value" opens a block that is indented by the dash.
                line.content.erase(0, start);
                line.indent += start;
                item = parseBlock(line.indent, depth + 1);
            }
            if (!item)
                return item;
            node->items.push_back(std::move(*item));
        }
        return node;
    }

    /// What stands below a key or a dash without a value: an indented block, or nothing.
    Result<YamlNode> parseNested(std::size_t indent, int depth)
    {
        const int number = m_lines[m_index].number;
        ++m_index;
        const bool below =
            m_index < m_lines.size() && (m_lines[m_index].indent > indent ||
                                         (m_lines[m_index].indent == indent && isItem(m_lines[m_index])));
        if (!below)
            return newNode(YamlNode::Kind::Null, number, depth + 1);
        return parseBlock(m_lines[m_index].indent, depth + 1);
    }

    /// The position of the colon that ends a key, or npos.
    static std::size_t keyEnd(const std::string &content)
    {
        if (content.empty() || std::string_view("[{!&*|>").find(content[0]) != std::string_view::npos)
            return std::string::npos;
        std::size_t start = 0;
        if (content[0] == '"' || content[0] == '\'') {
            start = closingQuote(content, 0);
            if (start == std::string::npos)
                return start;
        }
        for (std::size_t i = start; i < content.size(); ++i) {
            if (content[i] == ':' &&
                (i + 1 == content.size() || content[i + 1] == ' ' || content[i + 1] == '\t'))
                return i;
        }
        return std::string::npos;
    }

    Result<YamlNode> parseMapping(std::size_t indent, int depth)
    {
        auto node = newNode(YamlNode::Kind::Mapping, m_lines[m_index].number, depth);
        std::unordered_set<std::string>
            keys; // a search among the entries would take minutes for a large file
        while (node && m_index < m_lines.size() && m_lines[m_index].indent == indent) {
            Line &line = m_lines[m_index];
            const std::size_t colon = keyEnd(line.content);
            if (line.tabbed)
                return tabFailure(line);
            if (isItem(line))
                break;
            if (colon == std::string::npos)
                return failure(line.number, "the line has no \"key: value\"");
            const std::string key = unquoted(trimmed(line.content.substr(0, colon)));
            if (!keys.insert(key).second)
                return failure(line.number, "the key '" + key.substr(0, 40) + "' is there twice");
            auto value = parseAfterKey(line, colon + 1, indent, depth);
            if (!value)
                return value;
            node->entries.push_back({key, std::move(*value)});
        }
        return node;
    }

    Result<YamlNode> parseAfterKey(const Line &line, std::size_t position, std::size_t indent, int depth)
    {
        std::string rest = trimmed(line.content.substr(position));
        if (rest.starts_with("!"))
            rest = trimmed(rest.substr(std::min(rest.find(' '), rest.size())));
        if (rest.empty())
            return parseNested(indent, depth);
        return parseValue({line.number, indent, rest, false}, 0, depth + 1);
    }

    /// A value that begins in this line; a flow value may go on in the next ones.
    Result<YamlNode> parseValue(Line line, std::size_t start, int depth)
    {
        m_flow = std::move(line);
        m_column = start;
        ++m_index;
        if (m_flow.content[m_column] == '[' || m_flow.content[m_column] == '{') {
            auto node = parseFlow(depth);
            if (node && m_column < m_flow.content.size())
                return failure(m_flow.number, "something follows the closing bracket");
            return node;
        }
        return scalar(m_flow.content, m_flow.number, depth);
    }

    Result<YamlNode> scalar(const std::string &text, int line, int depth)
    {
        auto node = newNode(YamlNode::Kind::Scalar, line, depth);
        if (!node)
            return node;
        if (std::string_view("&*|>@`").find(text[0]) != std::string_view::npos)
            return failure(line, "anchors, aliases and blocks of text are not understood");
        if ((text[0] == '"' || text[0] == '\'') && (text.size() < 2 || text.back() != text.front()))
            return failure(line, "a quoted text does not end in its line");
        node->text = unquoted(text);
        return node;
    }

    /// Goes to the next character of a flow value that is not blank. False at the end of the file.
    bool skipBlanks()
    {
        for (;;) {
            m_column = std::min(m_flow.content.find_first_not_of(" \t", m_column), m_flow.content.size());
            if (m_column < m_flow.content.size())
                return true;
            if (m_index >= m_lines.size())
                return false;
            m_flow = m_lines[m_index++];
            m_column = 0;
        }
    }

    Result<YamlNode> parseFlow(int depth)
    {
        if (!skipBlanks())
            return failure(m_flow.number, "a bracket is not closed");
        const char open = m_flow.content[m_column];
        if (open != '[' && open != '{')
            return parseFlowScalar(depth);
        const char close = open == '[' ? ']' : '}';
        auto node =
            newNode(open == '[' ? YamlNode::Kind::Sequence : YamlNode::Kind::Mapping, m_flow.number, depth);
        ++m_column;
        std::unordered_set<std::string> keys;
        while (node) {
            if (!skipBlanks())
                return failure(node->line, "a bracket is not closed");
            if (m_flow.content[m_column] == close)
                break;
            if (auto added = open == '[' ? parseFlowItem(*node, depth) : parseFlowEntry(*node, keys, depth);
                !added)
                return tl::unexpected(added.error());
            if (!skipBlanks())
                return failure(node->line, "a bracket is not closed");
            if (m_flow.content[m_column] == ',')
                ++m_column;
            else if (m_flow.content[m_column] != close)
                return failure(m_flow.number, "a comma or a closing bracket is missing");
        }
        ++m_column;
        return node;
    }

    Result<void> parseFlowItem(YamlNode &into, int depth)
    {
        auto item = parseFlow(depth + 1);
        if (!item)
            return tl::unexpected(item.error());
        into.items.push_back(std::move(*item));
        return {};
    }

    Result<void> parseFlowEntry(YamlNode &into, std::unordered_set<std::string> &keys, int depth)
    {
        const auto key = parseFlowScalar(depth + 1);
        if (!key)
            return tl::unexpected(key.error());
        if (!skipBlanks() || m_flow.content[m_column] != ':')
            return failure(m_flow.number, "a colon is missing after '" + key->text.substr(0, 40) + "'");
        if (!keys.insert(key->text).second)
            return failure(key->line, "the key '" + key->text.substr(0, 40) + "' is there twice");
        ++m_column;
        auto value = parseFlow(depth + 1);
        if (!value)
            return tl::unexpected(value.error());
        into.entries.push_back({key->text, std::move(*value)});
        return {};
    }

    Result<YamlNode> parseFlowScalar(int depth)
    {
        const std::string &content = m_flow.content;
        const std::size_t start = m_column;
        if (content[start] == '"' || content[start] == '\'') {
            const std::size_t end = closingQuote(content, start);
            m_column = end == std::string::npos ? content.size() : end + 1;
        } else {
            m_column = std::min(content.find_first_of(",[]{}:", start), content.size());
        }
        const std::string text = trimmed(content.substr(start, m_column - start));
        if (text.empty())
            return failure(m_flow.number, "a value is missing");
        return scalar(text, m_flow.number, depth);
    }

    const std::filesystem::path &m_file;
    const std::string m_advice;
    std::vector<Line> m_lines;
    std::size_t m_index = 0; ///< of the next line
    Line m_flow;             ///< the line that a flow value is in
    std::size_t m_column = 0;
    int m_nodes = 0;
};

} // namespace

const YamlNode *YamlNode::find(std::string_view key) const
{
    const auto found =
        std::find_if(entries.begin(), entries.end(), [key](const auto &entry) { return entry.key == key; });
    return found == entries.end() ? nullptr : &found->value;
}

Result<YamlNode> parseYaml(const std::filesystem::path &file, const std::string &text,
                           const std::string &advice)
{
    return YamlParser(file, advice).parse(text);
}

} // namespace odo
