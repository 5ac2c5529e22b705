// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "ui/testbed/targets/target_painter.h"

#include <QMap>

namespace odo {

namespace {

const QString outputOption = QStringLiteral("output"), paperOption = QStringLiteral("paper"), boardOption = QStringLiteral("board"),
              squareOption = QStringLiteral("square"), sizeOption = QStringLiteral("size"), labelsOption = QStringLiteral("labels");

Result<TargetSpec> targetFrom(const CommandCall &call)
{
    static const QMap<QString, TargetKind> kinds{{QStringLiteral("checkerboard"), TargetKind::Checkerboard},
                                                 {QStringLiteral("charuco"), TargetKind::Charuco},
                                                 {QStringLiteral("tags"), TargetKind::Tags},
                                                 {QStringLiteral("rings"), TargetKind::Rings}};
    static const QMap<QString, QPageSize::PageSizeId> papers{
        {QStringLiteral("a4"), QPageSize::A4}, {QStringLiteral("letter"), QPageSize::Letter}, {QStringLiteral("a3"), QPageSize::A3}};
    TargetSpec spec;
    if (!kinds.contains(call.positional(0)))
        return call.wrongCall(QStringLiteral("'%1' is not checkerboard, charuco, tags or rings").arg(call.positional(0)));
    spec.kind = kinds.value(call.positional(0));
    const QString paper = QString::fromStdString(call.value(paperOption)).toLower();
    if (!papers.contains(paper))
        return call.wrongCall(QStringLiteral("--paper is a4, letter or a3"));
    spec.paper = papers.value(paper);
    const auto board = call.sizePair(boardOption);
    const auto square = call.lengthM(squareOption), size = call.lengthM(sizeOption);
    if (!board)
        return tl::unexpected(board.error());
    if (!square || !size)
        return tl::unexpected(square ? size.error() : square.error());
    spec.columns = int(board->first);
    spec.rows = int(board->second);
    spec.squareM = *square;
    spec.markerM = *size;
    spec.labels.clear();
    for (const QString &label : QString::fromStdString(call.value(labelsOption)).split(QLatin1Char(','), Qt::SkipEmptyParts))
        spec.labels << label.trimmed();
    return spec;
}

} // namespace

Result<void> runTarget(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("target"),
         QStringLiteral("checkerboard|charuco|tags|rings -o FILE.pdf [--paper a4|letter|a3] [--board 9x6] [--square 25mm] "
                        "[--size 150mm] [--labels O,U,V,D]"),
         1, 1,
         {{{QStringLiteral("o"), outputOption}, QStringLiteral("The PDF to write."), QStringLiteral("FILE")},
          {paperOption, QStringLiteral("What it is printed on."), QStringLiteral("PAPER"), QStringLiteral("a4")},
          {boardOption, QStringLiteral("Inner corners of a board."), QStringLiteral("CxR"), QStringLiteral("9x6")},
          {squareOption, QStringLiteral("Side of a square of a board."), QStringLiteral("LENGTH"), QStringLiteral("25mm")},
          {sizeOption, QStringLiteral("Side of a tag's black square, diameter of a ring."), QStringLiteral("LENGTH"), QStringLiteral("150mm")},
          {labelsOption, QStringLiteral("Of the floor markers, in the order of the layout."), QStringLiteral("LABELS"),
           QStringLiteral("O,U,V,D")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(outputOption))
        return call.wrongCall(QStringLiteral("-o is missing"));
    const auto spec = targetFrom(call);
    if (!spec)
        return tl::unexpected(spec.error());
    const QString file = QString::fromStdString(call.value(outputOption));
    if (const auto written = writeTargetPdf(*spec, file); !written)
        return written;
    call.answer({{QStringLiteral("file"), file}, {QStringLiteral("sheets"), isBoard(spec->kind) ? 1 : int(spec->labels.size())}},
                QStringLiteral("Wrote %1. Print it at 100 % and check its ruler.").arg(file));
    return {};
}

} // namespace odo
