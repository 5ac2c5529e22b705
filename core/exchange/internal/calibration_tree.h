// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/internal/yaml_document.h"

namespace odo {

/// Reads the text of a calibration file into one tree, whatever it is written in, told apart by content:
/// YAML (of the messages that ROS prints, one after the other, the first), JSON, TOML (toml++), XML, COLMAP's
/// cameras.txt and the INI of ROS's Videre style, of which the entries get the names that ROS's YAML has.
/// Limits and errors: those of parseYaml. Any thread.
Result<YamlNode> parseCalibrationTree(const std::filesystem::path &file, const std::string &text,
                                      const Message &advice);

} // namespace odo
