// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/video/foreign_files.h"
#include "ui/main_window/internal/import_dialogs.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>

using namespace odo;
using odo::test::writeRaw;

using Sync = SyncBy;

class TestImportTrialDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void asksOneStepForEachFurtherView();
    void aCameraShowsHowWellItIsRegistered();
    void aTeamProposesItsRobots();
    void aViewWithoutAVideoNeedsNoStep();
    void aVideoWithoutTimesNeedsItsRate();
    void chaptersShareARow();
    void imagesNeedTheirRate();
    void isReachedByTheTabKey();
    void paintsThePicture_data();
    void paintsThePicture();

private:
    template <class Field>
    Field *field(const char *accessibleName) const
    {
        for (Field *one : m_dialog->findChildren<Field *>())
            if (one->accessibleName() == QLatin1String(accessibleName))
                return one;
        return nullptr;
    }
    void addThirdView() const;

    std::unique_ptr<ImportTrialDialog> m_dialog;
};

void TestImportTrialDialog::init()
{
    m_dialog = std::make_unique<ImportTrialDialog>(
        ImportTrialDialog::Offer{QStringLiteral("Run 7"),
                                 {QStringLiteral("Falcon")},
                                 {QStringLiteral("Red")},
                                 {{QStringLiteral("Door"), {QStringLiteral("±3 mm"), BadgeState::Good}},
                                  {QStringLiteral("Window"), {}},
                                  {QStringLiteral("Wall"), {QStringLiteral("moved"), BadgeState::Bad}}}});
}

void TestImportTrialDialog::aTeamProposesItsRobots()
{
    const QStringList robots{QStringLiteral("Red"), QStringLiteral("Blue")};
    ImportTrialDialog dialog({QStringLiteral("Run 7"),
                              {QStringLiteral("Falcon"), QStringLiteral("Heron")},
                              robots,
                              {},
                              {QStringLiteral("Team 4"), QStringLiteral("Heron")},
                              {{QStringLiteral("Blue")}, {}},
                              {QStringLiteral("Slalom")}});
    auto *task = dialog.findChildren<QComboBox *>().at(1);
    QVERIFY(dialog.settings().task.empty());
    task->setCurrentIndex(task->findText(QStringLiteral("Slalom")));
    QCOMPARE(dialog.settings().task, std::string("Slalom"));
    task->setEditText(QStringLiteral(" a new one "));
    QCOMPARE(dialog.settings().task, std::string("a new one"));
    auto *team = dialog.findChild<QComboBox *>();
    QVERIFY(dialog.settings().robots.empty());
    team->setCurrentIndex(team->findText(QStringLiteral("Team 4")));
    QCOMPARE(dialog.settings().robots, std::vector<std::string>{"Blue"});
    // has none of its own: what was ticked stays
    team->setCurrentIndex(team->findText(QStringLiteral("Heron")));
    QCOMPARE(dialog.settings().robots, std::vector<std::string>{"Blue"});
    team->setCurrentIndex(0);
    QCOMPARE(dialog.settings().robots, std::vector<std::string>{"Blue"});
}

void TestImportTrialDialog::addThirdView() const
{
    test::button(*m_dialog, "Add view")->click();
    field<QComboBox>("Camera of view 3")->setCurrentText(QStringLiteral("Wall"));
    const auto files = m_dialog->findChildren<PathField *>();
    for (int i = 0; i < 3; ++i)
        files.at(i)->setPath(QStringLiteral("%1.mp4").arg(QChar(u'a' + i)));
}

void TestImportTrialDialog::asksOneStepForEachFurtherView()
{
    auto *how = field<QComboBox>("How to synchronise view 2 with the first");
    auto *later = field<QDoubleSpinBox>("Time offset of view 2");
    QVERIFY(how && later && !later->isEnabled());
    QVERIFY(!field<QComboBox>("How to synchronise view 1 with the first"));
    QVERIFY(!field<QComboBox>("How to synchronise view 3 with the first"));
    addThirdView();
    auto *howThird = field<QComboBox>("How to synchronise view 3 with the first");
    auto *laterThird = field<QDoubleSpinBox>("Time offset of view 3");
    QVERIFY(howThird && laterThird);

    const ImportSettings automatic = m_dialog->settings();
    QCOMPARE(automatic.videos.size(), std::size_t(3));
    QCOMPARE(automatic.steps.size(), std::size_t(2));
    QVERIFY(automatic.steps[0].how == Sync::Automatic && automatic.steps[1].how == Sync::Automatic);

    how->setCurrentIndex(how->findData(int(Sync::Sound)));
    QVERIFY(m_dialog->settings().steps[0].how == Sync::Sound && !later->isEnabled());
    how->setCurrentIndex(how->findData(int(Sync::None)));
    howThird->setCurrentIndex(howThird->findData(int(Sync::Given)));
    QVERIFY(!later->isEnabled() && laterThird->isEnabled());
    laterThird->setValue(-0.1375);
    const ImportSettings told = m_dialog->settings();
    QVERIFY(told.steps[0].how == Sync::None);
    QVERIFY(told.steps[1].how == Sync::Given);
    QCOMPARE(told.steps[1].offsetS, -0.1375);
    // The rows are called as the cameras are.
    QStringList labels;
    for (const auto *label : m_dialog->findChild<ViewSteps *>()->findChildren<QLabel *>())
        labels << label->text();
    QCOMPARE(labels, (QStringList{QStringLiteral("Window"), QStringLiteral("Wall")}));
    field<QComboBox>("Camera of view 3")->setCurrentText(QString());
    QCOMPARE(m_dialog->findChild<ViewSteps *>()->findChildren<QLabel *>().at(1)->text(),
             QStringLiteral("View 3"));
}

void TestImportTrialDialog::aCameraShowsHowWellItIsRegistered()
{
    const auto badge = [&] { return field<QLabel>("Registration of the camera of view 1")->text(); };
    QCOMPARE(badge(), QStringLiteral("±3 mm"));
    field<QComboBox>("Camera of view 1")->setCurrentText(QStringLiteral("Wall"));
    QCOMPARE(badge(), QStringLiteral("moved"));
    field<QComboBox>("Camera of view 1")->setCurrentText(QStringLiteral("a new one"));
    QVERIFY(badge().isEmpty());
}

void TestImportTrialDialog::aViewWithoutAVideoNeedsNoStep()
{
    addThirdView();
    field<QComboBox>("How to synchronise view 2 with the first")->setCurrentIndex(4);
    field<QComboBox>("How to synchronise view 3 with the first")->setCurrentIndex(5);
    const auto files = m_dialog->findChildren<PathField *>();
    files.at(1)->setPath({});
    const ImportSettings gap = m_dialog->settings();
    QCOMPARE(gap.videos.size(), std::size_t(2));
    QCOMPARE(gap.videos[1].first, std::string("Wall"));
    QCOMPARE(gap.steps.size(), std::size_t(1));
    QVERIFY(gap.steps[0].how == Sync::Given);
    files.at(1)->setPath(QStringLiteral("b.mp4"));
    files.at(0)->setPath({}); // the second is the first one now
    const ImportSettings later = m_dialog->settings();
    QCOMPARE(later.videos[0].first, std::string("Window"));
    QCOMPARE(later.steps.size(), std::size_t(1));
    QVERIFY(later.steps[0].how == Sync::Given);
}

/// JPEG images one after another: nothing says when they were taken.
void TestImportTrialDialog::aVideoWithoutTimesNeedsItsRate()
{
    QTemporaryDir folder;
    const QString bare = folder.filePath(QStringLiteral("bare.mjpeg"));
    QVERIFY(writeRaw(bare.toStdString(), "mjpeg", "yuvj420p", 5, 1, 320));
    const auto files = m_dialog->findChildren<PathField *>();
    auto *given = m_dialog->findChild<QCheckBox *>();
    auto *rate = field<QDoubleSpinBox>("Camera's real rate");
    QVERIFY(given && rate);
    const auto canImport = [&] { return test::button(*m_dialog, "Import")->isEnabled(); };
    files.at(0)->setPath(QStringLiteral("a.mp4"));
    QVERIFY(canImport() && given->isEnabled() && !given->isChecked() && !m_dialog->settings().rate);
    files.at(1)->setPath(bare);
    QTRY_VERIFY(given->isChecked());
    QVERIFY(!given->isEnabled() && rate->isEnabled());
    QCOMPARE(rate->text(), QStringLiteral("not entered"));
    QVERIFY(!canImport());
    rate->setValue(30);
    QVERIFY(canImport());
    QCOMPARE(m_dialog->settings().rate, std::optional(30.0));
    files.at(1)->setPath(QStringLiteral("b.mp4"));
    QVERIFY(canImport() && given->isEnabled() && !given->isChecked() && !m_dialog->settings().rate);
}

void TestImportTrialDialog::chaptersShareARow()
{
    m_dialog->addVideos({QStringLiteral("/d/GX020007.MP4"), QStringLiteral("/d/side.mp4"),
                         QStringLiteral("/d/GX010007.MP4")});
    const auto videos = m_dialog->settings().videos;
    QCOMPARE(videos.size(), std::size_t(2));
    QCOMPARE(videos[0].first, std::string("Door"));
    QCOMPARE(videos[0].second.string(), std::string("/d/GX010007.MP4+GX020007.MP4"));
    QCOMPARE(videos[1].second.string(), std::string("/d/side.mp4"));

    // several files dropped on one camera
    auto *field = m_dialog->findChildren<PathField *>().at(1);
    const auto drop = [&](const QStringList &files) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString &file : files)
            urls << QUrl::fromLocalFile(file);
        data.setUrls(urls);
        QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(field, &enter);
        QDropEvent event(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(field, &event);
        return QString::fromStdString(field->path().string());
    };
    QCOMPARE(drop({QStringLiteral("/d/GOPR0003.MP4"), QStringLiteral("/d/GP010003.MP4")}),
             QStringLiteral("/d/GOPR0003.MP4+GP010003.MP4"));
    QCOMPARE(drop({QStringLiteral("/d/one.mp4"), QStringLiteral("/d/other.mp4")}),
             QStringLiteral("/d/one.mp4"));
}

void TestImportTrialDialog::imagesNeedTheirRate()
{
    QTemporaryDir folder;
    for (const char *name : {"1.png", "2.png"}) {
        QFile file(folder.filePath(QLatin1String(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
    }
    m_dialog->findChildren<PathField *>().at(0)->setPath(folder.path());
    QTRY_VERIFY(m_dialog->findChild<QCheckBox *>()->isChecked());
    QVERIFY(!test::button(*m_dialog, "Import")->isEnabled());
    field<QDoubleSpinBox>("Camera's real rate")->setValue(30);
    QVERIFY(test::button(*m_dialog, "Import")->isEnabled());
}

void TestImportTrialDialog::isReachedByTheTabKey()
{
    addThirdView();
    field<QComboBox>("How to synchronise view 2 with the first")->setCurrentIndex(5);
    m_dialog->show();
    QVERIFY(QTest::qWaitForWindowActive(m_dialog.get()));
    QStringList reached;
    field<QComboBox>("Camera of view 1")->setFocus();
    for (int i = 0; i < 15; ++i) {
        const QWidget *focus = QApplication::focusWidget();
        QVERIFY(focus);
        const auto *button = qobject_cast<const QPushButton *>(focus);
        reached << (focus->accessibleName().isEmpty() && button ? button->text() : focus->accessibleName());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    const auto s = [](const char *text) { return QString::fromLatin1(text); };
    const QStringList wanted{s("Camera of view 1"),
                             s("Video of view 1"),
                             s("Browse: Video of view 1"),
                             s("Camera of view 2"),
                             s("Video of view 2"),
                             s("Browse: Video of view 2"),
                             s("Camera of view 3"),
                             s("Video of view 3"),
                             s("Browse: Video of view 3"),
                             s("Add &view"),
                             s("How to synchronise view 2 with the first"),
                             s("Time offset of view 2"),
                             s("How to synchronise view 3 with the first")};
    QCOMPARE(reached.mid(0, 13), wanted);
    // By keyboard alone.
    auto *third = field<QComboBox>("How to synchronise view 3 with the first");
    third->setFocus();
    QTest::keyClick(third, Qt::Key_End);
    QTest::keyClick(third, Qt::Key_Tab);
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("1.25"));
    QCOMPARE(m_dialog->settings().steps.at(1).offsetS, 1.25);
}

void TestImportTrialDialog::paintsThePicture_data()
{
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

void TestImportTrialDialog::paintsThePicture()
{
    QFETCH(bool, dark);
    m_dialog->setPalette(dark ? darkPalette() : lightPalette());
    addThirdView();
    field<QComboBox>("How to synchronise view 3 with the first")->setCurrentIndex(5);
    field<QDoubleSpinBox>("Time offset of view 3")->setValue(0.4137);
    m_dialog->adjustSize();
    const QPixmap image = m_dialog->grab();
    // Nothing is cut off.
    for (const auto *box : m_dialog->findChild<ViewSteps *>()->findChildren<QComboBox *>())
        QVERIFY(box->width() >= box->minimumSizeHint().width());
    QVERIFY(m_dialog->width() <= 900);
    const QString folder = qEnvironmentVariable("ODOGRAPH_KEEP_PICTURES");
    if (!folder.isEmpty())
        QVERIFY(image.save(QStringLiteral("%1/import_%2_%3.png")
                               .arg(folder, QString::fromLatin1(QTest::currentDataTag()))
                               .arg(m_dialog->devicePixelRatio())));
}

ODOGRAPH_TEST(TestImportTrialDialog, QApplication)
#include "tst_import_trial_dialog.moc"
