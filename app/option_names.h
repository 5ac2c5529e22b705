// SPDX-License-Identifier: GPL-3.0-or-later
// What the options of the subcommands are called, without their dashes.
#pragma once

#include <QString>

namespace odo::option {

inline const QString adopt = QStringLiteral("adopt");
inline const QString again = QStringLiteral("again");
inline const QString align = QStringLiteral("align");
inline const QString at = QStringLiteral("at");
inline const QString board = QStringLiteral("board");
inline const QString box = QStringLiteral("box");
inline const QString camera = QStringLiteral("camera");
inline const QString clear = QStringLiteral("clear");
inline const QString colour = QStringLiteral("colour");
inline const QString csvStyle = QStringLiteral("csv-style");
inline const QString device = QStringLiteral("device");
inline const QString figure = QStringLiteral("figure");
inline const QString find = QStringLiteral("find");
inline const QString force = QStringLiteral("force");
inline const QString format = QStringLiteral("format");
inline const QString frame = QStringLiteral("frame");
inline const QString height = QStringLiteral("height");
inline const QString hint = QStringLiteral("hint");
inline const QString image = QStringLiteral("image");
inline const QString joint = QStringLiteral("joint");
inline const QString keep = QStringLiteral("keep");
inline const QString labels = QStringLiteral("labels");
inline const QString language = QStringLiteral("language");
inline const QString layout = QStringLiteral("layout");
inline const QString logo = QStringLiteral("logo");
inline const QString method = QStringLiteral("method");
inline const QString mode = QStringLiteral("mode");
inline const QString model = QStringLiteral("model");
inline const QString ofClass = QStringLiteral("class");
inline const QString open = QStringLiteral("open");
inline const QString origin = QStringLiteral("origin");
inline const QString originAt = QStringLiteral("origin-at");
inline const QString output = QStringLiteral("output");
inline const QString paper = QStringLiteral("paper");
inline const QString pattern = QStringLiteral("pattern");
inline const QString pick = QStringLiteral("pick");
inline const QString pixels = QStringLiteral("pixels");
inline const QString preRoll = QStringLiteral("pre-roll");
inline const QString rate = QStringLiteral("rate");
inline const QString recover = QStringLiteral("recover");
inline const QString reference = QStringLiteral("reference");
inline const QString remark = QStringLiteral("remark");
inline const QString removeStrays = QStringLiteral("remove-strays");
inline const QString reverse = QStringLiteral("reverse");
inline const QString robot = QStringLiteral("robot");
inline const QString school = QStringLiteral("school");
inline const QString seconds = QStringLiteral("seconds");
inline const QString size = QStringLiteral("size");
inline const QString smoother = QStringLiteral("smoother");
inline const QString speed = QStringLiteral("speed");
inline const QString spike = QStringLiteral("spike");
inline const QString square = QStringLiteral("square");
inline const QString sslVision = QStringLiteral("ssl-vision");
inline const QString sync = QStringLiteral("sync");
inline const QString tape = QStringLiteral("tape");
inline const QString task = QStringLiteral("task");
inline const QString team = QStringLiteral("team");
inline const QString teams = QStringLiteral("teams");
inline const QString theme = QStringLiteral("theme");
inline const QString through = QStringLiteral("through");
inline const QString time = QStringLiteral("time");
inline const QString track = QStringLiteral("track");
inline const QString trial = QStringLiteral("trial");
inline const QString turn = QStringLiteral("turn");
inline const QString unit = QStringLiteral("unit");
inline const QString use = QStringLiteral("use");
inline const QString valid = QStringLiteral("valid");
inline const QString video = QStringLiteral("video");
inline const QString xAxis = QStringLiteral("x-axis");

} // namespace odo::option
