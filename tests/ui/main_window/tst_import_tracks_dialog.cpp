// SPDX-License-Identifier: GPL-3.0-or-later
// Finished tracks in the window: the dialog, files dropped on the window, and the run that they become.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/person.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/internal/import_tracks_dialog.h"
#include "ui/main_window/internal/track_preview.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"
#include "ui/models/trial_scene.h"
#include "ui/review/internal/trial_facts.h"
#include "ui/review/review_page.h"
#include "ui/views/widgets/form_fields.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;

class TestImportTracksDialog : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

    QString write(const char *name, const QByteArray &text) const
    {
        QFile file(m_folder.filePath(QString::fromLatin1(name)));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("no test file");
        return file.fileName();
    }
    static QByteArray circle()
    {
        QByteArray text = "t_s,x_mm,y_mm\n";
        for (int i = 0; i < 100; ++i)
            text += QByteArray::number(i / 50.0, 'f', 3) + ',' +
                    QByteArray::number(500 * std::cos(i / 25.0), 'f', 3) + ',' +
                    QByteArray::number(500 * std::sin(i / 25.0), 'f', 3) + '\n';
        return text;
    }
    static QAbstractButton *importButton(const QDialog &dialog)
    {
        for (QAbstractButton *button : dialog.findChild<QDialogButtonBox *>()->buttons())
            if (dialog.findChild<QDialogButtonBox *>()->buttonRole(button) == QDialogButtonBox::AcceptRole)
                return button;
        return nullptr;
    }
    void drop(const QStringList &files) const
    {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString &file : files)
            urls << QUrl::fromLocalFile(file);
        data.setUrls(urls);
        // Qt lets a widget drop only what has entered it.
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &event);
    }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings().clear();
        const auto made = storeExample(m_folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(m_window->openProject(*made));
        QTRY_VERIFY(!m_window->workspace().isBusy() && m_window->isSettled());
    }
    void cleanupTestCase() { m_window.reset(); }

    void theDialogAsks()
    {
        ImportTracksDialog dialog({QStringLiteral("Run 7"),
                                   {QStringLiteral("Falcon")},
                                   {QStringLiteral("Red")},
                                   {QStringLiteral("Lap")},
                                   {QStringLiteral("F")}});
        QVERIFY(!importButton(dialog)->isEnabled());
        dialog.addTrack(QStringLiteral("/a/run.tum"));
        QVERIFY(importButton(dialog)->isEnabled());
        dialog.addTrack(QStringLiteral("/a/other.csv")); // a row of its own, whose robot must be told
        QVERIFY(!importButton(dialog)->isEnabled());
        for (auto *box : dialog.findChildren<QComboBox *>()) {
            if (box->accessibleName() == QStringLiteral("Robot of track 2"))
                box->setCurrentText(QStringLiteral("Blue"));
        }
        QVERIFY(importButton(dialog)->isEnabled());
        const ImportTracksSettings settings = dialog.settings();
        QCOMPARE(settings.trial, std::string("Run 7"));
        QCOMPARE(settings.tracks.size(), std::size_t(2));
        QCOMPARE(settings.tracks[0], (std::pair<std::string, std::filesystem::path>("Red", "/a/run.tum")));
        QCOMPARE(settings.tracks[1], (std::pair<std::string, std::filesystem::path>("Blue", "/a/other.csv")));
        QVERIFY(settings.task.empty() && settings.team.empty());
        dialog.findChild<QLineEdit *>()->clear();
        QVERIFY(!importButton(dialog)->isEnabled());
    }
    /// What was understood is shown, and what is open can be chosen.
    void filesAreShownBeforeTheyAreImported()
    {
        QByteArray text = "t,x,y\n";
        for (int i = 0; i < 100; ++i)
            text += QByteArray::number(i / 50.0, 'f', 3) + ',' +
                    (i == 40 ? QByteArray("nan,nan")
                             : QByteArray::number(500 * std::cos(i / 25.0), 'f', 3) + ',' +
                                   QByteArray::number(500 * std::sin(i / 25.0), 'f', 3)) +
                    '\n';
        ImportTracksDialog dialog({QStringLiteral("Run 7"), {}, {QStringLiteral("Red")}, {}, {}});
        dialog.addTrack(write("open.csv", text));
        const auto *preview = dialog.findChild<TrackPreview *>();
        QVERIFY2(preview->words().contains(QStringLiteral("choose their unit")) ||
                     preview->words().contains(QStringLiteral("Choose their unit")),
                 qPrintable(preview->words()));
        QVERIFY(dialog.findChild<PathSketch *>()->pieces().empty());
        for (auto *label : dialog.findChildren<QLabel *>()) {
            if (label->text() == QStringLiteral("&Unit of positions"))
                qobject_cast<QComboBox *>(label->buddy())->setCurrentText(QStringLiteral("mm"));
        }
        QVERIFY2(preview->words().startsWith(QStringLiteral("open.csv: Tracker, 100 lines in 1.98 s")),
                 qPrintable(preview->words()));
        QCOMPARE(dialog.findChild<PathSketch *>()->pieces().size(), std::size_t(2)); // a gap at the nan
        QCOMPARE(dialog.settings().reading.unit, std::optional(LengthUnit::Millimetre));
    }
    void droppedFilesBecomeARun()
    {
        const QString file = write("lap.csv", circle());
        Person person({[&](QDialog &dialog) {
            QVERIFY(qobject_cast<ImportTracksDialog *>(&dialog));
            dialog.findChild<QLineEdit *>()->setText(QStringLiteral("dropped"));
            importButton(dialog)->click();
        }});
        drop({file});
        QVERIFY(person.isDone());
        QTRY_VERIFY(!m_window->workspace().isBusy() && m_window->isSettled());
        auto *review = m_window->findChild<ReviewPage *>();
        QTRY_COMPARE(review->trial(), QStringLiteral("dropped"));
        const auto scene = loadTrialScene(*m_window->workspace().project(), "dropped");
        QVERIFY(scene);
        QVERIFY((*scene)->views.empty());
        QCOMPARE((*scene)->frameTimes().size(), std::size_t(100));
        QCOMPARE((*scene)->frameTimes().back(), Nanoseconds(1980000000));
        QString told;
        for (const Fact &fact : trialFacts(**scene))
            if (fact.name == QStringLiteral("Imported"))
                told = fact.value;
        QVERIFY2(told.startsWith(QStringLiteral("lap.csv\npositions to 0")), qPrintable(told));
    }
    void aBadFileIsTold()
    {
        const QString file = write("bad.csv", "t_s,x_mm,y_mm\n0,0,0\n0,0,0\n");
        Person person({[&](QDialog &dialog) { importButton(dialog)->click(); }});
        drop({file});
        QVERIFY(person.isDone());
        QTRY_VERIFY(!m_window->workspace().isBusy());
        QCOMPARE(m_window->workspace().project()->trials().all()->size(), std::size_t(4));
    }
};

ODOGRAPH_TEST(TestImportTracksDialog, QApplication)
#include "tst_import_tracks_dialog.moc"
