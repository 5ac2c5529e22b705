// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/analysis_words.h"

#include "core/video/frame_spacing.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

namespace odo {

namespace {

class AnalysisWords
{
    Q_DECLARE_TR_FUNCTIONS(AnalysisWords)
};

QString millisecondText(double seconds)
{
    return AnalysisWords::tr("%1 ms").arg(QLocale().toString(seconds * 1e3, 'f', 1));
}

QString begunText(double offsetS)
{
    return offsetS < 0 ? AnalysisWords::tr("begun %1 earlier").arg(millisecondText(-offsetS))
                       : AnalysisWords::tr("begun %1 later").arg(millisecondText(offsetS));
}

} // namespace

QString smootherText(Smoother smoother)
{
    switch (smoother) {
    case Smoother::Rts:
        return AnalysisWords::tr("Kalman/RTS, noise from the data");
    case Smoother::SavGol:
        return AnalysisWords::tr("Savitzky–Golay, cubic, 11 points");
    case Smoother::Tracker:
        return AnalysisWords::tr("differences as in Tracker");
    case Smoother::None:
        break;
    }
    return AnalysisWords::tr("none: raw differences");
}

QString stepText(const RecordingRecord &view)
{
    const QString sigma = millisecondText(view.startOffsetSigmaS), begun = begunText(view.startOffsetS);
    if (view.syncMethod == "told")
        return AnalysisWords::tr("%1, as told by hand").arg(begun);
    QString text;
    if (view.syncMethod == "auto")
        text = AnalysisWords::tr("in step to %1, found from the motion; %2").arg(sigma, begun);
    else if (view.syncMethod == "flash")
        text = AnalysisWords::tr("in step to %1, found from a flash of light; %2").arg(sigma, begun);
    else if (view.syncMethod == "clock")
        text = AnalysisWords::tr("in step to %1, by the cameras' time stamps; %2").arg(sigma, begun);
    else
        return AnalysisWords::tr("taken as begun together");
    if (view.clockRate != 0)
        text += view.clockRate > 0
                    ? AnalysisWords::tr(", its clock %1 ppm fast").arg(std::lround(view.clockRate * 1e6))
                    : AnalysisWords::tr(", its clock %1 ppm slow").arg(std::lround(-view.clockRate * 1e6));
    return text;
}

QString unevenText(const RecordingRecord &view)
{
    const auto uneven = unevenRate(view.frameTimes);
    const auto ms = [](Nanoseconds interval) { return QLocale().toString(toSeconds(interval) * 1e3, 'f', 0); };
    return uneven ? AnalysisWords::tr("%1 to %2 ms apart").arg(ms(uneven->shortest), ms(uneven->longest))
                  : QString();
}

} // namespace odo
