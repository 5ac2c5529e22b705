// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/internal/yaml_document.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// A value on a line of a file.
YamlNode scalarNode(std::string text, int line);

/// The cameras of COLMAP's cameras.txt, each under its number and with the entries that ROS has: its lens
/// models as those of OpenCV, its pixels from the centre of the first one. A model that OpenCV does not have
/// is kept by its name. nullopt: it is no such file.
std::optional<YamlNode> treeOfColmap(const std::vector<std::string_view> &lines);

/// The tree of an XML file: elements and attributes are entries, numbers with blanks between them a list. The
/// sensors of Metashape (Agisoft) get the entries that ROS has. Limits and errors are those of parseYaml.
Result<YamlNode> treeOfXml(const std::filesystem::path &file, const std::string &text, const Message &advice);

} // namespace odo
