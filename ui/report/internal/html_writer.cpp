// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/internal/html_writer.h"

namespace odo {

namespace {

/// What HTML and XML do not allow becomes a sign of its own.
QString escaped(const QString &text)
{
    QString shown = text.toHtmlEscaped();
    shown.replace(u'\'', QStringLiteral("&#39;"));
    for (qsizetype i = 0; i < shown.size(); ++i) {
        const QChar c = shown.at(i);
        const bool isPair = c.isHighSurrogate() && i + 1 < shown.size() && shown.at(i + 1).isLowSurrogate();
        if (isPair) {
            ++i;
            continue;
        }
        const bool isControl = c < QChar(0x20) && c != u'\n' && c != u'\t';
        if (isControl || c.isSurrogate() || c == QChar(0x7f) || c >= QChar(0xfffe))
            shown[i] = QChar::ReplacementCharacter;
    }
    return shown;
}

} // namespace

void HtmlWriter::begin(const char *name, const HtmlAttributes &attributes)
{
    m_text += u'<' + QString::fromLatin1(name);
    for (const auto &[attribute, value] : attributes)
        m_text += u' ' + QString::fromLatin1(attribute) + QStringLiteral("=\"") + escaped(value) + u'"';
}

void HtmlWriter::open(const char *name, const HtmlAttributes &attributes)
{
    begin(name, attributes);
    m_text += u'>';
    m_open.append(name);
}

void HtmlWriter::close()
{
    m_text += QStringLiteral("</") + QString::fromLatin1(m_open.takeLast()) + QStringLiteral(">\n");
}

void HtmlWriter::element(const char *name, const QString &content, const HtmlAttributes &attributes)
{
    open(name, attributes);
    text(content);
    close();
}

void HtmlWriter::shape(const char *name, const HtmlAttributes &attributes)
{
    begin(name, attributes);
    m_text += QStringLiteral("/>\n");
}

void HtmlWriter::text(const QString &text)
{
    m_text += escaped(text);
}

} // namespace odo
