// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/language.h"

#include "resources/resources.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <algorithm>

namespace odo {
namespace {

const QString languageKey = QStringLiteral("language"), english = QStringLiteral("en");

QString installed = english;

bool isKnown(const QString &code)
{
    const QList<Language> &all = languages();
    return std::any_of(all.begin(), all.end(), [&code](const Language &each) { return each.code == code; });
}

/// "de" of "de-AT", "zh_CN" of "zh-Hans-CN"; English where none of the computer's languages is known.
QString languageOfComputer()
{
    for (const QString &wanted : QLocale::system().uiLanguages()) {
        const QLocale locale(wanted);
        for (const QString &code : {locale.name(), locale.name().section(u'_', 0, 0)})
            if (isKnown(code))
                return code;
    }
    return english;
}

QLocale localeOf(const QString &code)
{
    const QLocale own = QLocale::system(), wanted(code);
    if (own.language() == wanted.language())
        return own;
    // Not that of one country: 11/12 would be the twelfth of November in one and the eleventh of December in
    // others.
    return code == english ? QLocale(QLocale::English, QLocale::World) : wanted;
}

bool addWords(QCoreApplication &application, const QString &file, const QString &folder)
{
    auto *words = new QTranslator(&application);
    if (words->load(file, folder))
        return QCoreApplication::installTranslator(words);
    delete words;
    return false;
}

} // namespace

const QList<Language> &languages()
{
    static const QList<Language> all{
        {english, QStringLiteral("English")},
        {QStringLiteral("de"), QStringLiteral("Deutsch")},
        {QStringLiteral("es"), QStringLiteral("Español")},
        {QStringLiteral("fr"), QStringLiteral("Français")},
        {QStringLiteral("ko"), QStringLiteral("한국어")},
        {QStringLiteral("zh_CN"), QStringLiteral("简体中文")},
    };
    return all;
}

QString chosenLanguage()
{
    const QString code = QSettings().value(languageKey).toString();
    return isKnown(code) ? code : QString();
}

void chooseLanguage(const QString &code)
{
    if (code.isEmpty())
        QSettings().remove(languageKey);
    else
        QSettings().setValue(languageKey, code);
}

void installLanguage(QCoreApplication &application, const QString &code)
{
    installed = isKnown(code) ? code : languageOfComputer();
    QLocale::setDefault(localeOf(installed));
    // Qt's own words (OK, Cancel, the file dialog): of English and some others there is no file.
    addWords(application, QStringLiteral("qtbase_") + installed,
             QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    const bool isThere = addWords(application, QStringLiteral("odograph_") + installed,
                                  QStringLiteral(":/odograph/translations"));
    // Where core's English names the command line. The other languages have only the windows' words.
    if (installed == english)
        addWords(application, QStringLiteral("odograph_en_windows"),
                 QStringLiteral(":/odograph/translations"));
    Q_ASSERT(isThere); // compiled in
    Q_UNUSED(isThere)
}

QString shownLanguage()
{
    return installed;
}

QString helpPage(const QString &name)
{
    return QString::fromUtf8(resourceBytes(QStringLiteral("help/%1/%2.html").arg(installed, name)));
}

} // namespace odo
