// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/step_words.h"

#include <cmath>

namespace odo {

namespace {

QString milliseconds(double seconds)
{
    return QStringLiteral("%1 ms").arg(1e3 * seconds, 0, 'f', 1);
}

QString begunText(double offsetS)
{
    return offsetS < 0 ? QStringLiteral("begun %1 earlier").arg(milliseconds(-offsetS))
                       : QStringLiteral("begun %1 later").arg(milliseconds(offsetS));
}

QString stepText(const RecordingRecord &view)
{
    if (view.syncMethod == "told")
        return QStringLiteral("%1, as told").arg(begunText(view.startOffsetS));
    if (!isStepMeasured(view))
        return QStringLiteral("not synchronised, taken as begun together");
    QString text = QStringLiteral("in step to %1, found from %2; %3")
                       .arg(milliseconds(view.startOffsetSigmaS),
                            view.syncMethod == "clock"   ? QStringLiteral("the cameras' time stamps")
                            : view.syncMethod == "flash" ? QStringLiteral("a flash of light")
                                                         : QStringLiteral("the motion"),
                            begunText(view.startOffsetS));
    if (view.clockRate != 0)
        text += QStringLiteral(", its clock %1 ppm %2")
                    .arg(1e6 * std::abs(view.clockRate), 0, 'f', 0)
                    .arg(view.clockRate > 0 ? QStringLiteral("fast") : QStringLiteral("slow"));
    return text;
}

} // namespace

QStringList stepSentences(const std::vector<RecordingRecord> &views)
{
    QStringList lines;
    for (std::size_t i = 1; i < views.size(); ++i)
        lines << QStringLiteral("View %1: %2").arg(QString::fromStdString(views[i].cameraName), stepText(views[i]));
    return lines;
}

} // namespace odo
