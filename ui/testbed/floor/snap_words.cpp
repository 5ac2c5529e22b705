// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/snap_words.h"

#include <QCoreApplication>

namespace odo {
namespace {

class Words
{
    Q_DECLARE_TR_FUNCTIONS(SnappedMarker)
};

} // namespace

QString snappedWords(SnappedMarker::Kind kind)
{
    switch (kind) {
    case SnappedMarker::Kind::Tag:
        return Words::tr("tag");
    case SnappedMarker::Kind::Ring:
        return Words::tr("ring");
    case SnappedMarker::Kind::Dot:
        return Words::tr("dot");
    case SnappedMarker::Kind::TapeCrossing:
        return Words::tr("tape crossing");
    case SnappedMarker::Kind::TapeCorner:
        return Words::tr("corner");
    case SnappedMarker::Kind::Saddle:
        return Words::tr("crossing fields");
    case SnappedMarker::Kind::None:
        break;
    }
    return Words::tr("by hand");
}

} // namespace odo
