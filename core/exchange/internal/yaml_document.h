// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// A node of YAML, in which calibrations and tasks are written; JSON is of it. A scalar stays text: nothing
/// is guessed.
struct YamlEntry;
struct YamlNode
{
    enum class Kind { Null, Scalar, Sequence, Mapping };
    Kind kind = Kind::Null;
    int line = 0;
    std::string text;               ///< of a scalar, without quotes
    std::vector<YamlNode> items;    ///< of a sequence
    std::vector<YamlEntry> entries; ///< of a mapping, in the file's order

    /// nullptr when this is no mapping, or has no such key.
    const YamlNode *find(std::string_view key) const;
};

struct YamlEntry
{
    std::string key;
    YamlNode value;
};

/// Reads one YAML document (yaml-cpp) without anchors and aliases; tags are skipped. Made for files from
/// anywhere: nesting is at most 16 deep, a document has at most 100 000 values, keys are texts and not
/// doubled. Errors name file and line and end with `advice`.
Result<YamlNode> parseYaml(const std::filesystem::path &file, const std::string &text, const Message &advice);

} // namespace odo
