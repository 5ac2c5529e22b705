// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/snap_words.h"

#include <QCoreApplication>

namespace odo {
namespace {

class SnappedMarkerWords
{
    Q_DECLARE_TR_FUNCTIONS(SnappedMarker)
};

} // namespace

QString snappedWords(SnappedMarker::Kind kind)
{
    switch (kind) {
    case SnappedMarker::Kind::Tag:
        return SnappedMarkerWords::tr("tag");
    case SnappedMarker::Kind::Ring:
        return SnappedMarkerWords::tr("ring");
    case SnappedMarker::Kind::Dot:
        return SnappedMarkerWords::tr("dot");
    case SnappedMarker::Kind::TapeCrossing:
        return SnappedMarkerWords::tr("tape crossing");
    case SnappedMarker::Kind::TapeCorner:
        return SnappedMarkerWords::tr("corner");
    case SnappedMarker::Kind::Saddle:
        return SnappedMarkerWords::tr("crossing fields");
    case SnappedMarker::Kind::None:
        break;
    }
    return SnappedMarkerWords::tr("by hand");
}

} // namespace odo
