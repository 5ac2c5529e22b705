// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/internal/yaml_document.h"

#include "core/exchange/text_file.h"
#include "core/files/file_words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <sstream>
#include <unordered_set>
#include <utility>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

namespace odo {

namespace {

constexpr std::size_t maxDepth = 16, maxNodes = 100'000;

/// Why a document is refused; caught in parseYaml.
struct Refused
{
    int line;
    Message why;
};

/// Builds the tree of one document from what the parser meets.
class YamlTree : public YAML::EventHandler
{
public:
    YamlNode takeRoot() { return std::move(m_root); }

    void OnDocumentStart(const YAML::Mark &) override {}
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark &mark, YAML::anchor_t anchor) override
    {
        place(newNode(YamlNode::Kind::Null, mark, anchor));
    }
    void OnAlias(const YAML::Mark &mark, YAML::anchor_t) override { refuseAnchors(mark); }
    void OnScalar(const YAML::Mark &mark, const std::string &, YAML::anchor_t anchor,
                  const std::string &value) override
    {
        YamlNode node = newNode(YamlNode::Kind::Scalar, mark, anchor);
        node.text = value;
        place(std::move(node));
    }
    void OnSequenceStart(const YAML::Mark &mark, const std::string &, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override
    {
        open(newNode(YamlNode::Kind::Sequence, mark, anchor));
    }
    void OnSequenceEnd() override { close(); }
    void OnMapStart(const YAML::Mark &mark, const std::string &, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override
    {
        open(newNode(YamlNode::Kind::Mapping, mark, anchor));
    }
    void OnMapEnd() override { close(); }

private:
    /// A sequence or mapping that is not yet at its end.
    struct Container
    {
        YamlNode node;
        std::unordered_set<std::string> keys; ///< a search among the entries would take minutes
        bool hasKey = false;                  ///< of a mapping: the last entry lacks its value
    };

    [[noreturn]] static void refuseAnchors(const YAML::Mark &mark)
    {
        throw Refused{mark.line + 1,
                      ODO_TEXT("exchange.no_anchors", "anchors and aliases are not supported")};
    }

    YamlNode newNode(YamlNode::Kind kind, const YAML::Mark &mark, YAML::anchor_t anchor)
    {
        if (anchor != YAML::NullAnchor)
            refuseAnchors(mark);
        if (m_open.size() >= maxDepth)
            throw Refused{mark.line + 1,
                          ODO_TEXT("exchange.nested_too_deep", "it is nested more than %1 deep")(maxDepth)};
        if (!awaitsKey() && ++m_nodes > maxNodes)
            throw Refused{mark.line + 1,
                          ODO_TEXT("exchange.too_many_values", "it holds more than %1 values")(maxNodes)};
        YamlNode node;
        node.kind = kind;
        node.line = mark.line + 1;
        return node;
    }

    void open(YamlNode node)
    {
        if (awaitsKey())
            throw Refused{node.line, ODO_TEXT("exchange.key_is_no_text",
                                              "a key is not text, or a bracket is not closed")};
        m_open.push_back({std::move(node), {}, false});
    }

    void close()
    {
        YamlNode node = std::move(m_open.back().node);
        m_open.pop_back();
        place(std::move(node));
    }

    bool awaitsKey() const
    {
        return !m_open.empty() && m_open.back().node.kind == YamlNode::Kind::Mapping && !m_open.back().hasKey;
    }

    /// Puts a value, or the key before it, where it belongs.
    void place(YamlNode node)
    {
        if (m_open.empty()) {
            m_root = std::move(node);
            return;
        }
        Container &into = m_open.back();
        if (into.node.kind == YamlNode::Kind::Sequence) {
            into.node.items.push_back(std::move(node));
        } else if (into.hasKey) {
            into.node.entries.back().value = std::move(node);
            into.hasKey = false;
        } else {
            if (!into.keys.insert(node.text).second)
                throw Refused{node.line, ODO_TEXT("exchange.key_is_there_twice",
                                                  "the key '%1' appears twice")(node.text.substr(0, 40))};
            into.node.entries.push_back({std::move(node.text), {}});
            into.hasKey = true;
        }
    }

    std::vector<Container> m_open;
    YamlNode m_root;
    std::size_t m_nodes = 0;
};

/// The number that "\\uXXXX" at a position stands for; 0 where there is none.
unsigned codeAt(const std::string &text, std::size_t at)
{
    unsigned code = 0;
    if (at + 6 <= text.size() && text.compare(at, 2, "\\u") == 0)
        std::from_chars(text.data() + at + 2, text.data() + at + 6, code, 16);
    return code;
}

/// JSON writes a character beyond the first 65,536 as two halves, which YAML does not know: makes one escape
/// of them.
std::string withWholeCharacters(const std::string &text)
{
    std::string whole;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const unsigned first = text[i] == '\\' ? codeAt(text, i) : 0;
        const unsigned second = first >= 0xd800 && first < 0xdc00 ? codeAt(text, i + 6) : 0;
        if (second >= 0xdc00 && second < 0xe000) {
            std::array<char, 11> escape{};
            std::snprintf(escape.data(), escape.size(), "\\U%08X",
                          0x10000 + ((first - 0xd800) << 10) + (second - 0xdc00));
            whole += escape.data();
            i += 11;
            continue;
        }
        whole += text[i];
        if (text[i] == '\\' && i + 1 < text.size()) // what it escapes begins no other escape
            whole += text[++i];
    }
    return whole;
}

} // namespace

const YamlNode *YamlNode::find(std::string_view key) const
{
    const auto found =
        std::find_if(entries.begin(), entries.end(), [key](const auto &entry) { return entry.key == key; });
    return found == entries.end() ? nullptr : &found->value;
}

Result<YamlNode> parseYaml(const std::filesystem::path &file, const std::string &text, const Message &advice)
{
    const auto failure = [&](int line, const Message &why) {
        return fail(ErrorCode::InvalidInput, atLine(file, line), why, advice);
    };
    try {
        std::istringstream stream(withWholeCharacters(text));
        YAML::Parser parser(stream);
        YamlTree tree;
        if (!parser.HandleNextDocument(tree))
            return failure(1, fileIsEmpty());
        if (parser)
            return failure(1, ODO_TEXT("exchange.several_documents", "it holds more than one document"));
        return tree.takeRoot();
    } catch (const Refused &refused) {
        return failure(refused.line, refused.why);
    } catch (const YAML::Exception &problem) {
        return failure(problem.mark.line + 1, ODO_TEXT("exchange.no_valid_yaml", "it is not valid YAML (%1)")(
                                                  foreignWords(problem.msg)));
    }
}

} // namespace odo
