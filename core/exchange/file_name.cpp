// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/file_name.h"

#include <QString>
#include <QStringList>

namespace odo {

namespace {

constexpr qsizetype mostBytes = 180;

bool isHarmless(char32_t c)
{
    if (c < 0x20 || c == QChar::ReplacementCharacter ||
        QStringView(u"/\\:*?\"<>|").contains(QChar(c < 0x10000 ? char16_t(c) : u'x')))
        return false;
    switch (QChar::category(c)) {
    case QChar::Other_Control:
    case QChar::Other_Format:
    case QChar::Other_Surrogate:
    case QChar::Other_NotAssigned:
    case QChar::Separator_Line:
    case QChar::Separator_Paragraph:
        return false;
    default:
        return true;
    }
}

/// "CON", "com1.txt": Windows opens a device instead of a file.
bool isDevice(const QString &name)
{
    static const QStringList devices = {QStringLiteral("CON"), QStringLiteral("PRN"), QStringLiteral("AUX"),
                                        QStringLiteral("NUL")};
    const QString stem = name.section(u'.', 0, 0).trimmed().toUpper();
    if (devices.contains(stem))
        return true;
    return stem.size() == 4 &&
           (stem.startsWith(QStringLiteral("COM")) || stem.startsWith(QStringLiteral("LPT"))) &&
           stem[3] >= u'1' && stem[3] <= u'9';
}

} // namespace

std::string fileNameOf(const std::string &name)
{
    QString file;
    qsizetype bytes = 0;
    for (const char32_t c : QString::fromStdString(name).toUcs4()) {
        const QString one = isHarmless(c) ? QString::fromUcs4(&c, 1) : QStringLiteral("-");
        bytes += one.toUtf8().size();
        if (bytes > mostBytes)
            break;
        file += one;
    }
    while (file.endsWith(u' ') || file.endsWith(u'.'))
        file.chop(1);
    if (file.isEmpty() || file.startsWith(u'.'))
        file.prepend(u'-');
    if (isDevice(file))
        file.prepend(u'_');
    return file.toStdString();
}

} // namespace odo
