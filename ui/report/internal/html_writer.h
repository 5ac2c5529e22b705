// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayList>
#include <QList>
#include <QString>
#include <utility>

namespace odo {

/// Attributes of an element, with their values as they are meant.
using HtmlAttributes = QList<std::pair<const char *, QString>>;

/// Writes HTML that an XML parser reads as well: every text and every value escaped, every element closed.
/// One thread.
class HtmlWriter
{
public:
    void open(const char *name, const HtmlAttributes &attributes = {});
    void close(); ///< the last one that is open
    /// An element with this text alone.
    void element(const char *name, const QString &text, const HtmlAttributes &attributes = {});
    /// One without content: a void element of HTML, or a shape of SVG.
    void shape(const char *name, const HtmlAttributes &attributes = {});
    void text(const QString &text);
    /// Our own words in HTML or CSS.
    void raw(const QString &markup) { m_text += markup; }
    qsizetype size() const { return m_text.size(); }
    QString take() { return std::move(m_text); }

private:
    void begin(const char *name, const HtmlAttributes &attributes);

    QString m_text;
    QByteArrayList m_open;
};

} // namespace odo
