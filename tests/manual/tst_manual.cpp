// SPDX-License-Identifier: GPL-3.0-or-later
// The documents say what is so: their pictures and links are there, and the menus they name are in the
// window, with the keys they name.
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/preferences/preferences_dialog.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QHash>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

// bytes: a reader on a slow line waits for them
constexpr qint64 largestImage = 150'000, largestOfAll = 3'000'000;

QString source(const QString &path)
{
    return QDir(qEnvironmentVariable("ODOGRAPH_SOURCE_DIR")).filePath(path);
}

QString contentOf(const QString &file)
{
    QFile opened(file);
    return opened.open(QIODevice::ReadOnly) ? QString::fromUtf8(opened.readAll()) : QString();
}

QStringList filesOf(const QString &folder, const QString &pattern)
{
    QStringList files;
    const QDir dir(source(folder));
    for (const QString &name : dir.entryList({pattern}, QDir::Files))
        files << dir.filePath(name);
    return files;
}

QStringList chapters()
{
    return filesOf(QStringLiteral("docs/manual"), QStringLiteral("*.md"));
}

QStringList documents()
{
    return chapters() + filesOf(QStringLiteral("docs"), QStringLiteral("*.md")) +
           filesOf(QStringLiteral("."), QStringLiteral("*.md"));
}

/// Without code, in which nothing is a link.
QString proseOf(const QString &file)
{
    static const QRegularExpression block(QStringLiteral("^(```.*?^```|(    |\\t)[^\\n]*)$"),
                                          QRegularExpression::MultilineOption |
                                              QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression span(QStringLiteral("`[^`\\n]*`"));
    return contentOf(file).remove(block).remove(span);
}

QStringList found(const QString &text, const char *pattern)
{
    QStringList all;
    auto matches = QRegularExpression(QString::fromUtf8(pattern)).globalMatch(text);
    while (matches.hasNext())
        all << matches.next().captured(1);
    return all;
}

/// As GitHub makes them of headings.
QStringList anchorsOf(const QString &file)
{
    QStringList anchors;
    for (const QString &heading : found(u'\n' + contentOf(file), "\\n#+ ([^\\n]+)"))
        anchors << heading.toLower()
                       .remove(QRegularExpression(QStringLiteral("[^\\w\\- ]"),
                                                  QRegularExpression::UseUnicodePropertiesOption))
                       .replace(u' ', u'-');
    return anchors;
}

QString plain(QString words)
{
    return words.remove(u'&').remove(u'…').simplified();
}

/// "File ▸ Report" and its keys, of all menus.
void addCommands(const QMenu &menu, const QString &path, QHash<QString, QKeySequence> &commands)
{
    for (const QAction *action : menu.actions()) {
        const QString name = path + QStringLiteral(" ▸ ") + plain(action->text());
        commands.insert(name, action->shortcut());
        if (action->menu())
            addCommands(*action->menu(), name, commands);
    }
}

} // namespace

class TestManual : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void everyPictureIsNamedAndThere();
    void picturesAreSmall();
    void linksLeadSomewhere();
    void theTableOfContentsHasEveryChapter();
    void menusAreInTheWindow();
    void messagesAreThePrograms();
    void wordsAreOurs();

private:
    QTemporaryDir m_folder;
    QHash<QString, QKeySequence> m_commands;
};

void TestManual::initTestCase()
{
    test::beginWithoutSettings();
    const auto made = storeExample(m_folder.path().toStdString());
    QVERIFY2(made, made ? "" : made.error().message().c_str());
    MainWindow window;
    window.show();
    QVERIFY(window.openProject(*made));
    test::waitFor(window);
    for (const WindowMode mode : allModes) {
        window.showMode(mode);
        test::waitFor(window);
    }
    for (const QAction *menu : window.menuBar()->actions())
        addCommands(*menu->menu(), plain(menu->text()), m_commands);
    Person person({[this](QDialog &dialog) {
        const auto *tabs = dialog.findChild<QTabWidget *>();
        for (int tab = 0; tab < tabs->count(); ++tab)
            m_commands.insert(QStringLiteral("Edit ▸ Preferences ▸ ") + plain(tabs->tabText(tab)), {});
        dialog.reject();
    }});
    window.findChild<QAction *>(QStringLiteral("preferences"))->trigger();
    QVERIFY(person.isDone() && m_commands.size() > 50);
}

void TestManual::everyPictureIsNamedAndThere()
{
    QStringList named;
    for (const QString &chapter : chapters())
        named += found(contentOf(chapter), "!\\[[^\\]]+\\]\\(pictures/([^)]+)\\)");
    QStringList there;
    for (const QString &file : filesOf(QStringLiteral("docs/manual/pictures"), QStringLiteral("*")))
        there << QFileInfo(file).fileName();
    named.removeDuplicates();
    named.sort();
    there.sort();
    QCOMPARE(named, there);
    QVERIFY(!named.isEmpty());
}

void TestManual::picturesAreSmall()
{
    qint64 all = 0;
    for (const QString &file : filesOf(QStringLiteral("docs/manual/pictures"), QStringLiteral("*"))) {
        all += QFileInfo(file).size();
        QVERIFY2(QFileInfo(file).size() <= largestImage, qPrintable(file));
    }
    QVERIFY2(all <= largestOfAll, qPrintable(QString::number(all)));
}

void TestManual::linksLeadSomewhere()
{
    QStringList lost;
    for (const QString &file : documents())
        for (const QString &link : found(proseOf(file), "\\]\\(([^)\\s]+)\\)")) {
            if (link.startsWith(QStringLiteral("http")))
                continue;
            const QString path = link.section(u'#', 0, 0), anchor = link.section(u'#', 1);
            const QString target = path.isEmpty() ? file : QFileInfo(file).dir().filePath(path);
            if (!QFileInfo::exists(target) || (!anchor.isEmpty() && !anchorsOf(target).contains(anchor)))
                lost << QFileInfo(file).fileName() + QStringLiteral(": ") + link;
        }
    QVERIFY2(lost.isEmpty(), qPrintable(lost.join(u'\n')));
}

void TestManual::theTableOfContentsHasEveryChapter()
{
    const QString contents = contentOf(source(QStringLiteral("docs/manual/README.md")));
    for (const QString &chapter : chapters())
        if (const QString name = QFileInfo(chapter).fileName(); name != QStringLiteral("README.md"))
            QVERIFY2(contents.contains(u'(' + name + u')'), qPrintable(name));
}

void TestManual::menusAreInTheWindow()
{
    QStringList wrong;
    int named = 0;
    const QStringList help = filesOf(QStringLiteral("resources/help/en"), QStringLiteral("*.html"));
    for (const QString &file : documents() + help) {
        // *File ▸ Report…* (Ctrl+P), or <i>File → Report</i>
        static const QRegularExpression path(
            QStringLiteral("(?:\\*|<i>)(\\w+\\s+(?:▸|→)[^*<]+)(?:\\*|</i>)(?:\\s+\\((\\w+(?:\\+\\w+)*)\\))?"),
            QRegularExpression::UseUnicodePropertiesOption);
        auto matches = path.globalMatch(help.contains(file) ? contentOf(file) : proseOf(file));
        while (matches.hasNext()) {
            const auto match = matches.next();
            const QString command = plain(match.captured(1).replace(u'→', u'▸'));
            const QKeySequence keys(match.captured(2));
            ++named;
            if (!m_commands.contains(command) || (!keys.isEmpty() && m_commands.value(command) != keys))
                wrong << QFileInfo(file).fileName() + QStringLiteral(": ") + match.captured(0);
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    QVERIFY(named > 50);
}

/// The first column of the tables of trouble.md and spikes.md: what stands between … must be in the sources,
/// with %1 or %.0f for what varies.
void TestManual::messagesAreThePrograms()
{
    QString words;
    for (const char *part : {"core", "ui", "app"}) {
        QDirIterator files(source(QString::fromLatin1(part)), {QStringLiteral("*.cpp")}, QDir::Files,
                           QDirIterator::Subdirectories);
        while (files.hasNext())
            words += contentOf(files.next());
    }
    static const QRegularExpression broken(QStringLiteral("\"\\s*\\n\\s*\"")); // one text over two lines
    words.remove(broken);
    QStringList wrong;
    for (const char *chapter : {"docs/manual/trouble.md", "docs/manual/spikes.md"})
        for (const QString &cell :
             found(contentOf(source(QString::fromLatin1(chapter))), "\\n\\| (\\*[^|]*\\*) \\|"))
            for (const QString &message : found(cell, "\\*([^*]+)\\*"))
                for (const QString &piece : message.split(u'…', Qt::SkipEmptyParts))
                    if (!words.contains(piece.trimmed()))
                        wrong << message;
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

/// Words that docs/conventions.md has another word for.
void TestManual::wordsAreOurs()
{
    static const QRegularExpression others(
        QStringLiteral("\\b(workspace|extrinsics|dataset|outliers?|experiments?)\\b"),
        QRegularExpression::CaseInsensitiveOption);
    for (const QString &chapter : chapters()) {
        const auto match = others.match(proseOf(chapter));
        QVERIFY2(!match.hasMatch(),
                 qPrintable(QFileInfo(chapter).fileName() + QStringLiteral(": ") + match.captured(0)));
    }
}

ODOGRAPH_TEST(TestManual, QApplication)
#include "tst_manual.moc"
