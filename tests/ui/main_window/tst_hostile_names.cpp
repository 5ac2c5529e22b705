// SPDX-License-Identifier: GPL-3.0-or-later
// Names of a project that comes from elsewhere may be anything: no window may take them for more than
// letters.
#include "core/base/plain_text.h"
#include "core/project/project.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/stored_example.h"
#include "ui/history/history_page.h"
#include "ui/main_window/main_window.h"
#include "ui/views/widgets/theme.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QLabel>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestHostileNames : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        test::beginWithoutSettings();
        applyAppearance(*qApp, Theme::Light);
    }
    void theyAreShownAsLetters_data();
    void theyAreShownAsLetters();
};

namespace {

/// Gives everything that has a name this one, each with a number behind it, past all checks.
void nameAll(const std::filesystem::path &project, const QString &name)
{
    static const QStringList places{
        QStringLiteral("camera.name"), QStringLiteral("layout.name"),      QStringLiteral("robot.name"),
        QStringLiteral("class.name"),  QStringLiteral("team.name"),        QStringLiteral("task.name"),
        QStringLiteral("trial.name"),  QStringLiteral("trial.notes"),      QStringLiteral("gate.name"),
        QStringLiteral("zone.name"),   QStringLiteral("team_member.name"), QStringLiteral("trial_tag.tag")};
    {
        QSqlDatabase database =
            QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("hostile"));
        database.setDatabaseName(QString::fromStdString(project.string()));
        QVERIFY(database.open());
        for (const QString &place : places) {
            QSqlQuery query(database);
            query.prepare(QStringLiteral("UPDATE %1 SET %2 = ? || rowid")
                              .arg(place.section(u'.', 0, 0), place.section(u'.', 1)));
            query.addBindValue(name);
            QVERIFY2(query.exec(), qPrintable(place + query.lastError().text()));
        }
    }
    QSqlDatabase::removeDatabase(QStringLiteral("hostile"));
}

/// What of a window's words would be taken for markup, and what is wider than a small screen.
QStringList mistakenIn(const QWidget &window, const QString &name)
{
    QStringList mistaken;
    const bool isMarkup = Qt::mightBeRichText(name);
    const auto note = [&mistaken](const QWidget &widget, const QString &what) {
        mistaken << QString::fromLatin1(widget.metaObject()->className()) + u' ' + widget.objectName() +
                        QStringLiteral(": ") + what;
    };
    for (const auto *widget : window.findChildren<QWidget *>()) {
        if (isMarkup && Qt::mightBeRichText(widget->toolTip()) && widget->toolTip().contains(name))
            note(*widget, QStringLiteral("tool tip"));
        const auto *label = qobject_cast<const QLabel *>(widget);
        const bool isTaken =
            label && (label->textFormat() == Qt::RichText ||
                      (label->textFormat() == Qt::AutoText && Qt::mightBeRichText(label->text())));
        if (isMarkup && isTaken && label->text().contains(name))
            note(*widget, QStringLiteral("text"));
        const auto *table = qobject_cast<const QAbstractItemView *>(widget);
        for (int row = 0; table && table->model() && row < std::min(20, table->model()->rowCount()); ++row)
            for (int column = 0; column < table->model()->columnCount(); ++column) {
                const QString tip = table->model()->index(row, column).data(Qt::ToolTipRole).toString();
                if (isMarkup && Qt::mightBeRichText(tip) && tip.contains(name))
                    note(*widget, QStringLiteral("tool tip of a cell"));
            }
    }
    constexpr int screen = 1366;
    for (const auto *widget : window.findChildren<QWidget *>()) // the innermost ones, to be found
        if (widget->minimumSizeHint().width() > screen && widget->minimumWidth() == 0 && !widget->layout() &&
            widget->isVisibleTo(&window))
            note(*widget, QStringLiteral("%1 wide").arg(widget->minimumSizeHint().width()));
    if (window.minimumSizeHint().width() > screen || window.width() > screen)
        note(window, QStringLiteral("%1 wide").arg(window.minimumSizeHint().width()));
    mistaken.removeDuplicates();
    return mistaken;
}

} // namespace

void TestHostileNames::theyAreShownAsLetters_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("markup") << QStringLiteral("<img src=x><b>bold</b>&amp;");
    QTest::newRow("path") << QStringLiteral("../../etc/passwd");
    QTest::newRow("right to left") << QString::fromUtf8(
        "photo\u202Egnp.exe"); // NOLINT(misc-misleading-bidirectional): such a name is what is shown
    QTest::newRow("formula") << QStringLiteral("=1+1");
    QTest::newRow("key") << QStringLiteral("A&B &&");
    QTest::newRow("lines") << QStringLiteral("one\ntwo\t%1 %n");
    QTest::newRow("long") << QString(10'000, u'W');
    QTest::newRow("a word of a million letters") << QString(1'000'000, u'W');
    QTest::newRow("a million words") << QStringLiteral("to ").repeated(1'000'000);
}

void TestHostileNames::theyAreShownAsLetters()
{
    QFETCH(QString, name);
    QTemporaryDir folder;
    const auto made = storeExample(folder.path().toStdString());
    QVERIFY2(made, made ? "" : made.error().message().c_str());
    nameAll(*made, name);
    MainWindow window;
    window.resize(1366, 728);
    QVERIFY(window.openProject(*made));
    window.show();
    test::waitFor(window);
    QStringList mistaken;
    for (const WindowMode mode : allModes) {
        window.showMode(mode);
        test::waitFor(window);
        mistaken << mistakenIn(window, name);
    }
    const auto *trials = window.findChild<QTableView *>(QStringLiteral("trials"));
    bool isShown = false;
    for (int column = 0; column < trials->model()->columnCount(); ++column)
        isShown = isShown || trials->model()->index(0, column).data().toString().startsWith(
                                 QString::fromStdString(plainLine(name.toStdString())).left(100));
    QVERIFY(isShown);
    const int dialogs = test::lookAtDialogs(window, [&](const QAction &command, QDialog &dialog) {
        for (const QString &each : mistakenIn(dialog, name))
            mistaken << command.text() + QStringLiteral(" · ") + each;
    });
    QVERIFY(dialogs > 15);
    QVERIFY2(mistaken.isEmpty(), qPrintable(mistaken.join(u'\n').left(3000)));
    QVERIFY(QDir(folder.path()).entryList({QStringLiteral("passwd*")}, QDir::AllEntries).isEmpty());
}

ODOGRAPH_TEST(TestHostileNames, QApplication)
#include "tst_hostile_names.moc"
