// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/option_names.h"
#include "app/output_option.h"
#include "ui/testbed/targets/target_painter.h"

#include <QMap>

namespace odo {

namespace {

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
    const QString paper = QString::fromStdString(call.value(option::paper)).toLower();
    if (!papers.contains(paper))
        return call.wrongCall(QStringLiteral("--paper is a4, letter or a3"));
    spec.paper = papers.value(paper);
    const auto board = call.sizePair(option::board);
    const auto square = call.lengthM(option::square), size = call.lengthM(option::size);
    if (!board)
        return tl::unexpected(board.error());
    if (!square || !size)
        return tl::unexpected(square ? size.error() : square.error());
    spec.columns = int(board->first);
    spec.rows = int(board->second);
    spec.squareM = *square;
    spec.markerM = *size;
    spec.labels.clear();
    for (const QString &label : QString::fromStdString(call.value(option::labels)).split(QLatin1Char(','), Qt::SkipEmptyParts))
        spec.labels << label.trimmed();
    return spec;
}

} // namespace

Result<void> runTarget(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("target"),
         QStringLiteral("checkerboard|charuco|tags|rings -o FILE.pdf [--force] [--paper a4|letter|a3] [--board 9x6] [--square 25mm] "
                        "[--size 150mm] [--labels O,U,V,D]"),
         1, 1,
         outputOptions(QStringLiteral("The PDF to write.")) + QList<QCommandLineOption>{
          {option::paper, QStringLiteral("What it is printed on."), QStringLiteral("PAPER"), QStringLiteral("a4")},
          {option::board, QStringLiteral("Inner corners of a board."), QStringLiteral("CxR"), QStringLiteral("9x6")},
          {option::square, QStringLiteral("Side of a square of a board."), QStringLiteral("LENGTH"), QStringLiteral("25mm")},
          {option::size, QStringLiteral("Side of a tag's black square, diameter of a ring."), QStringLiteral("LENGTH"), QStringLiteral("150mm")},
          {option::labels, QStringLiteral("Of the floor markers, in the order of the layout."), QStringLiteral("LABELS"),
           QStringLiteral("O,U,V,D")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(option::output))
        return call.wrongCall(QStringLiteral("-o is missing"));
    const auto spec = targetFrom(call);
    if (!spec)
        return tl::unexpected(spec.error());
    const QString file = QString::fromStdString(call.value(option::output));
    const auto target = outputOf(call, call.value(option::output), FileKind::Pdf, nullptr);
    if (!target)
        return tl::unexpected(target.error());
    if (auto written = writeTargetPdf(*spec, *target); !written)
        return written;
    call.answer({{QStringLiteral("file"), file}, {QStringLiteral("sheets"), isBoard(spec->kind) ? 1 : int(spec->labels.size())}},
                QStringLiteral("Wrote %1. Print it at 100 % and check its ruler.").arg(file));
    return {};
}

} // namespace odo
