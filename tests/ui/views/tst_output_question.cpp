// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/form_fields.h"

#include "core/files/protected_files.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/person.h"

#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

using namespace odo;

namespace {

/// Reads a message and presses one of its buttons.
Answer answerMessage(QString &text, QMessageBox::StandardButton button)
{
    return [&text, button](QDialog &dialog) {
        auto &box = dynamic_cast<QMessageBox &>(dialog);
        text = box.text();
        QTest::mouseClick(box.button(button), Qt::LeftButton);
    };
}

/// As chooseFile, when the person's own turn is over: the dialog asks before it replaces a file.
Answer chooseOutput(const QString &file)
{
    return [file](QDialog &dialog) {
        QTimer::singleShot(0, &dialog, [&dialog, file] { chooseFile(file)(dialog); });
    };
}

Answer giveUp()
{
    return [](QDialog &dialog) { dialog.reject(); };
}

} // namespace

/// How a window asks where to write.
class TestOutputQuestion : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    const QList<OutputFormat> m_formats{
        {QStringLiteral("PDF files (*.pdf)"), QStringLiteral("pdf"), FileKind::Pdf},
        {QStringLiteral("SVG images (*.svg)"), QStringLiteral("svg"), FileKind::Svg}};

    QString path(const char *name) const { return m_folder.filePath(QString::fromUtf8(name)); }
    void write(const char *name, const QByteArray &bytes) const
    {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    std::optional<ChosenOutput> ask(const QList<Answer> &answers) const
    {
        Person person(answers);
        auto chosen = askOutput(nullptr, QStringLiteral("Save the report"), path("offered.pdf"), m_formats);
        return person.isDone() ? chosen : std::nullopt;
    }

private Q_SLOTS:
    void initTestCase()
    {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        write("old.pdf", "%PDF-1.4\n");
        write("letter.pdf", "Dear Anna\n");
        write("p.odo", "SQLite format 3");
        write("named", "%PDF-1.4\n");
    }

    void aNewFileIsTakenWithItsEnding()
    {
        const auto chosen = ask({chooseOutput(path("report"))});
        QVERIFY(chosen.has_value());
        QCOMPARE(chosen->file, path("report.pdf"));
        QCOMPARE(chosen->target.file.string(), path("report.pdf").toStdString());
        QVERIFY(chosen->target.existing == Existing::ReplaceAny);
        QCOMPARE(chosen->format, 0);
        QCOMPARE(ask({chooseOutput(path("chart.svg"))})->format, 1); // what its name says
        QCOMPARE(ask({chooseOutput(path("notes.txt"))})->file, path("notes.txt"));
        QVERIFY(!ask({giveUp()}).has_value());
    }

    void whatTheFileDialogHasAskedIsNotAskedAgain()
    {
        QString text;
        QVERIFY(ask({chooseOutput(path("old.pdf")), answerMessage(text, QMessageBox::Yes)}).has_value());
    }

    void aFileThatGetsItsEndingHereIsAskedAbout()
    {
        QString text;
        const auto chosen = ask({chooseOutput(path("old")), answerMessage(text, QMessageBox::Yes)});
        QVERIFY(chosen.has_value());
        QCOMPARE(chosen->file, path("old.pdf"));
        QCOMPARE(text, path("old.pdf") + QStringLiteral(" exists. Replace it?"));
        QVERIFY(
            !ask({chooseOutput(path("old")), answerMessage(text, QMessageBox::No), giveUp()}).has_value());
    }

    void aFileOfAnotherKindIsAskedAbout()
    {
        QString dialogs, text;
        QVERIFY(ask({chooseOutput(path("letter.pdf")), answerMessage(dialogs, QMessageBox::Yes),
                     answerMessage(text, QMessageBox::Yes)})
                    .has_value());
        QCOMPARE(text, path("letter.pdf") + QStringLiteral(" is a file of another kind. Replace it?"));
    }

    void whatMustStayIsRefusedAndAskedAgain()
    {
        const OpenProjectFile open(path("p.odo").toStdString());
        QString dialogs, text;
        const auto chosen = ask({chooseOutput(path("p.odo")), answerMessage(dialogs, QMessageBox::Yes),
                                 answerMessage(text, QMessageBox::Ok), chooseOutput(path("new.pdf"))});
        QVERIFY(chosen.has_value());
        QCOMPARE(
            text,
            QStringLiteral("File '%1': it is the project itself. Choose another name.").arg(path("p.odo")));
        QCOMPARE(chosen->file, path("new.pdf"));
    }
};

ODOGRAPH_TEST(TestOutputQuestion, QApplication)
#include "tst_output_question.moc"
