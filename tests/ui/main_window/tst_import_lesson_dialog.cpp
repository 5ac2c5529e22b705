// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/import_lesson_dialog.h"

#include "tests/support/registered_test.h"

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>

using namespace odo;

class TestImportLessonDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void proposesATrialForEachRun();
    void takesWhatIsTicked();
    void teamsMayBeKnownOrNew();
    void asksForNamesOfTheirOwn();
    void aRunWithoutAClipHasFewerViews();

private:
    QTableWidget &table() const { return *m_dialog->findChild<QTableWidget *>(); }
    QPushButton *import() const
    {
        auto *box = m_dialog->findChild<QDialogButtonBox *>();
        for (QAbstractButton *button : box->buttons())
            if (box->buttonRole(button) == QDialogButtonBox::AcceptRole)
                return static_cast<QPushButton *>(button);
        return nullptr;
    }
    bool says(const QString &words) const
    {
        return std::ranges::any_of(m_dialog->findChildren<QLabel *>(),
                                   [&](const QLabel *label) { return label->text() == words; });
    }

    std::unique_ptr<ImportLessonDialog> m_dialog;
};

void TestImportLessonDialog::init()
{
    const Instant noon{std::chrono::hours(500'000)};
    m_dialog = std::make_unique<ImportLessonDialog>(
        ImportTrialDialog::Offer{{},
                                 {QStringLiteral("Falcon"), QStringLiteral("Otter")},
                                 {QStringLiteral("Red"), QStringLiteral("Blue")},
                                 {{QStringLiteral("Door"), {}}},
                                 {QStringLiteral("Team 1"), QStringLiteral("Team 2")},
                                 {},
                                 {QStringLiteral("Slalom")}},
        QStringList{QStringLiteral("Trial 1"), QStringLiteral("Trial 3")},
        std::vector<ClipGroup>{{{"x/a1.mp4", "x/b1.mp4"}, noon, 21.04}, {{"x/a2.mp4", ""}, {}, 0}});
}

void TestImportLessonDialog::proposesATrialForEachRun()
{
    QCOMPARE(table().rowCount(), 2);
    QCOMPARE(table().item(0, 0)->text(), QStringLiteral("Trial 4")); // 3 is there
    QCOMPARE(table().item(1, 0)->text(), QStringLiteral("Trial 5"));
    QVERIFY(!table().item(0, 2)->text().isEmpty()); // when it was
    QVERIFY(table().item(1, 2)->text().isEmpty());
    QCOMPARE(table().item(0, 3)->text(), QStringLiteral("21.0 s"));
    QCOMPARE(table().horizontalHeaderItem(4)->text(), QStringLiteral("Clip of Door"));
    QCOMPARE(table().horizontalHeaderItem(5)->text(), QStringLiteral("Clip of B"));
    QCOMPARE(table().item(1, 5)->text(), QStringLiteral("no clip"));
    QVERIFY(import()->isEnabled());
}

void TestImportLessonDialog::takesWhatIsTicked()
{
    QCOMPARE(m_dialog->settings().size(), std::size_t(2));
    table().item(0, 0)->setCheckState(Qt::Unchecked);
    const auto settings = m_dialog->settings();
    QCOMPARE(settings.size(), std::size_t(1));
    QCOMPARE(settings.front().trial, std::string("Trial 5"));
    QVERIFY(!settings.front().date); // it comes from the clips
    table().item(1, 0)->setCheckState(Qt::Unchecked);
    QVERIFY(!import()->isEnabled());
    QVERIFY(says(QStringLiteral("Tick the trials to import.")));
}

void TestImportLessonDialog::teamsMayBeKnownOrNew()
{
    auto *first = static_cast<QComboBox *>(table().cellWidget(0, 1));
    first->setCurrentText(QStringLiteral("Team 2")); // as it is shown
    static_cast<QComboBox *>(table().cellWidget(1, 1))->setCurrentText(QStringLiteral(" Heron "));
    const auto settings = m_dialog->settings();
    QCOMPARE(settings[0].team, std::string("Otter"));
    QCOMPARE(settings[1].team, std::string("Heron"));
}

void TestImportLessonDialog::asksForNamesOfTheirOwn()
{
    table().item(1, 0)->setText(table().item(0, 0)->text());
    QVERIFY(!import()->isEnabled());
    QVERIFY(says(QStringLiteral("Each trial needs a name of its own.")));
    table().item(1, 0)->setText(QStringLiteral("Trial 3")); // which is there
    QVERIFY(!import()->isEnabled());
    table().item(1, 0)->setText(QStringLiteral("Other"));
    QVERIFY(import()->isEnabled());
    for (QComboBox *box : m_dialog->findChildren<QComboBox *>())
        if (box->accessibleName() == QStringLiteral("Camera of view 2"))
            box->setCurrentText(QStringLiteral("Door"));
    QVERIFY(!import()->isEnabled());
    QVERIFY(says(QStringLiteral("Two clips of Trial 4 are of the same camera.")));
    table().item(0, 0)->setCheckState(Qt::Unchecked); // each of the others has one clip
    QVERIFY(import()->isEnabled());
}

void TestImportLessonDialog::aRunWithoutAClipHasFewerViews()
{
    const auto settings = m_dialog->settings();
    using Videos = std::vector<std::pair<std::string, std::filesystem::path>>;
    QVERIFY(settings[0].videos == (Videos{{"Door", "x/a1.mp4"}, {"B", "x/b1.mp4"}}));
    QVERIFY(settings[1].videos == (Videos{{"Door", "x/a2.mp4"}}));
}

ODOGRAPH_TEST(TestImportLessonDialog, QApplication)
#include "tst_import_lesson_dialog.moc"
