// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/base/message.h"
#include "ui/models/number_text.h"

#include <QByteArray>
#include <QLocale>
#include <QString>
#include <QTranslator>
#include <memory>
#include <vector>

namespace odo {

/// One of the program's languages, for pages in several at once: it does not touch what the windows are shown
/// in. Any thread.
class BoardLanguage : public MessageLanguage
{
public:
    explicit BoardLanguage(QString code);

    /// As HTML names it: "de", "zh-CN".
    QByteArray tag() const;
    const QLocale &locale() const { return m_locale; }
    /// A text of ours, marked by QT_TRANSLATE_NOOP("Scoreboard", …); count: for %n.
    QString text(const char *english, int count = -1) const;
    /// "Time", "Score"
    QString metric(const std::string &name) const;
    /// A metric of the standings with another value, in this language; points to tenths.
    NumberText number(Metric metric, double value, std::optional<double> sigma) const;

    std::string words(const MessageText &text) const override;
    std::string number(double value, int decimals) const override;

private:
    QString translated(const char *context, const char *english, int count) const;

    QString m_code; ///< "zh_CN"
    QLocale m_locale;
    std::unique_ptr<QTranslator> m_words; ///< of English only its plurals
};

/// All that the program has, English first.
class BoardLanguages
{
public:
    BoardLanguages();
    /// The one that a browser prefers, by its Accept-Language (RFC 9110, 12.5.4); English where it knows none
    /// of ours.
    const BoardLanguage &preferred(const QByteArray &accepted) const;
    /// By its tag.
    const BoardLanguage *find(const QByteArray &tag) const;

private:
    std::vector<std::unique_ptr<BoardLanguage>> m_all;
};

} // namespace odo
