// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/printed_text.h"

#include "ui/report/report_output.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QXmlStreamReader>

namespace odo::test {

namespace {

QByteArray outputOf(const QString &program, const QStringList &arguments)
{
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished(60000) || process.exitCode() != 0)
        qFatal("%s (package poppler-utils): %s", qPrintable(program),
               process.readAllStandardError().constData());
    return process.readAllStandardOutput();
}

} // namespace

QString printed(const ReportPages &pages, const QTemporaryDir &folder)
{
    static int count = 0;
    QString file = folder.filePath(QStringLiteral("%1.pdf").arg(++count));
    PdfFile pdf(file.toStdString(), QStringLiteral("Test"));
    for (const ReportPage &page : pages)
        if (const auto added = pdf.add(page); !added)
            qFatal("%s", added.error().message().c_str());
    if (const auto finished = pdf.finish(); !finished)
        qFatal("%s", finished.error().message().c_str());
    return file;
}

QString printedText(const QString &file, int page)
{
    QStringList arguments{QStringLiteral("-layout"), QStringLiteral("-enc"), QStringLiteral("UTF-8")};
    if (page > 0)
        arguments << QStringLiteral("-f") << QString::number(page) << QStringLiteral("-l")
                  << QString::number(page);
    return QString::fromUtf8(outputOf(QStringLiteral("pdftotext"), arguments << file << QStringLiteral("-")));
}

QStringList fontsNotEmbedded(const QString &file)
{
    QStringList missing;
    const QStringList lines =
        QString::fromUtf8(outputOf(QStringLiteral("pdffonts"), {file})).split(u'\n', Qt::SkipEmptyParts);
    // Two lines of header; from the right: object and generation, unicode, subset, embedded.
    for (const QString &line : lines.mid(2))
        if (const QStringList columns = line.simplified().split(u' ');
            columns.at(columns.size() - 5) != QStringLiteral("yes"))
            missing << line;
    return lines.size() > 2 ? missing : QStringList(QStringLiteral("no font at all"));
}

PrintedWords printedWords(const QString &file)
{
    PrintedWords printed;
    QXmlStreamReader xml(
        outputOf(QStringLiteral("pdftotext"), {QStringLiteral("-bbox"), file, QStringLiteral("-")}));
    const auto number = [&xml](const char *name) {
        return xml.attributes().value(QLatin1String(name)).toDouble();
    };
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("page"))
            printed.pageSizes << QSizeF(number("width"), number("height"));
        else if (xml.name() == QLatin1String("word")) {
            const QRectF box(QPointF(number("xMin"), number("yMin")),
                             QPointF(number("xMax"), number("yMax")));
            printed.words << PrintedWord{int(printed.pageSizes.size()), box, xml.readElementText()};
        }
    }
    return printed;
}

} // namespace odo::test
