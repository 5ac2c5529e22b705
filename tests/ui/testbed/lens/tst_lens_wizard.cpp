// SPDX-License-Identifier: GPL-3.0-or-later
// The lens wizard as a person walks it: by keyboard from files, by mouse from a camera, with cancel at every
// page.
#include "core/base/units.h"
#include "core/calibration/board_collector.h"
#include "core/calibration/intrinsic_calibration.h"
#include "core/capture/internal/stand_in_source.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "core/video/image_reader.h"
#include "core/video/video_writer.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"
#include "tests/ui/support/busy_watch.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/person.h"
#include "ui/models/camera_lists.h"
#include "ui/testbed/lens/internal/board_images_page.h"
#include "ui/testbed/lens/internal/calibration_result_page.h"
#include "ui/testbed/lens/internal/lens_drawings.h"
#include "ui/testbed/lens/internal/rms_so_far.h"
#include "ui/testbed/lens/lens_wizard.h"
#include "ui/views/widgets/theme.h"

#include <Eigen/Geometry>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int widthPx = 640, heightPx = 360, poses = 16;
constexpr int patienceMs = 120'000;

CameraModel lens()
{
    return *CameraModel::create(
        {widthPx, heightPx, 560, 561, 322, 178, LensModel::Standard, {-0.1, 0.02, 0, 0}, {}});
}

CameraDescription simulatedCamera()
{
    return {"sim:T", "simulated", foreignWords("Test camera"), widthPx, heightPx, 30};
}

std::shared_ptr<CameraSource> fastCamera(const std::vector<RigidTransform> &held)
{
    return simulatedBoardSource(simulatedCamera(), lens(), {}, held, Pace::Kind::None);
}

/// Poses of which the first shows a part of the board alone, three quarters of it.
std::vector<RigidTransform> cutFirst(int count)
{
    std::vector<RigidTransform> held = heldBoardPoses(lens(), {}, count - 1, 3);
    RigidTransform cut;
    cut.rotation = Eigen::AngleAxisd(20 * EIGEN_PI / 180, Eigen::Vector3d::UnitX());
    cut.translation = Eigen::Vector3d(0.2, 0, 0.45) - cut.rotation * (0.025 * Eigen::Vector3d(4, 2.5, 0));
    held.insert(held.begin(), cut);
    return held;
}

} // namespace

class TestLensWizard : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void byKeyboardFromFiles();
    void fortyPicturesNeverStallTheWindow();
    void byMouseFromACamera();
    void cancelsAtEveryPage_data();
    void cancelsAtEveryPage();
    void saysWhyPicturesDoNotCount();
    void aCutBoardFirstCostsNoPicture_data();
    void aCutBoardFirstCostsNoPicture();
    void takesOutAndUndoes();
    void saysTheRmsOfTheImagesSoFar();
    void leavesOutWhatIsAboveTheThreshold();
    void aBarIsChosenAndTheThresholdDragged();
    void tellsOfALostCamera();
    void staysOpenWhenTheDiskIsFull();
    void everyHintHasItsWords();

private:
    std::unique_ptr<LensWizard> makeWizard(bool cameraThere = true);
    static int page(LensWizard &wizard) { return wizard.findChild<QStackedWidget *>()->currentIndex(); }
    static QWidget *focused() { return QApplication::focusWidget(); }
    QStringList draw(const std::vector<RigidTransform> &held, const QString &name) const;
    QString film(const std::vector<RigidTransform> &held) const;
    void walkToImages(LensWizard &wizard);
    void typeFiles(QDialog &dialog);

    /// On a thread of the wizard's; read by the test once the wizard is accepted.
    Result<void> keep(const StoredIntrinsics &lens)
    {
        m_kept = lens.images.size();
        return m_problem ? Result<void>(tl::unexpected(*m_problem)) : Result<void>();
    }

    QTemporaryDir m_folder;
    QStringList m_files;
    LiveCameras m_live{[] { return std::vector<CameraDescription>{simulatedCamera()}; }};
    std::vector<RigidTransform> m_held = heldBoardPoses(lens(), {}, poses, 3); ///< before the camera
    std::size_t m_kept = 0;
    std::optional<Error> m_problem; ///< of keeping
};

void TestLensWizard::initTestCase()
{
    m_live.poll();
    QTRY_VERIFY(!m_live.isSearching());
    m_files = draw(heldBoardPoses(lens(), {}, poses, 3), QStringLiteral("board"));
}

QStringList TestLensWizard::draw(const std::vector<RigidTransform> &held, const QString &name) const
{
    QStringList files;
    SimulatedBoard board;
    for (const RigidTransform &pose : held) {
        board.cameraFromBoard = pose;
        files << m_folder.filePath(
            QStringLiteral("%1%2.png").arg(name).arg(files.size() + 1, 2, 10, QLatin1Char('0')));
        if (!writeImage(renderBoard(lens(), board, 2, 7), files.last().toStdString()))
            qFatal("cannot write a picture");
    }
    return files;
}

/// A clip in which the board is held still in each pose for a second.
QString TestLensWizard::film(const std::vector<RigidTransform> &held) const
{
    const QString file = m_folder.filePath(QStringLiteral("clip.mkv"));
    SimulatedBoard board;
    VideoWriterOptions options;
    options.codec = VideoCodec::Mjpeg;
    std::unique_ptr<VideoWriter> writer;
    std::int64_t index = 0;
    for (const RigidTransform &pose : held) {
        board.cameraFromBoard = pose;
        Frame frame = renderBoard(lens(), board, 2, 7);
        if (!writer)
            writer = std::move(*VideoWriter::create(file.toStdString(), frame.format, options));
        for (int i = 0; i < 20; ++i, ++index) {
            frame.time = std::chrono::milliseconds(50 * index);
            if (!writer->write(frame))
                qFatal("cannot write a frame");
        }
    }
    if (!writer->finish())
        qFatal("cannot write a clip");
    return file;
}

std::unique_ptr<LensWizard> TestLensWizard::makeWizard(bool cameraThere)
{
    auto wizard = std::make_unique<LensWizard>(
        QStringList{QStringLiteral("A"), QStringLiteral("B")}, QStringLiteral("B"), m_live,
        LensWizard::Callbacks{
            [this, cameraThere](const QString &) -> Result<std::shared_ptr<CameraSource>> {
                if (!cameraThere)
                    return test::saidFailure(ErrorCode::Io, "'sim:T'", "the camera does not answer",
                                             "plug it in again");
                return fastCamera(m_held);
            },
            [this](const StoredIntrinsics &lens, const JobControl &) { return keep(lens); }});
    wizard->show(); // not modal: who answers dialogs must not take it for one
    return wizard;
}

void TestLensWizard::walkToImages(LensWizard &wizard)
{
    wizard.source().addFiles(m_files);
    QTest::mouseClick(button(wizard, "Next >"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(button(wizard, "Next >")->isEnabled(), patienceMs);
}

/// All pictures of the folder, as they are typed into Qt's file dialog.
void TestLensWizard::typeFiles(QDialog &dialog)
{
    auto *line = dialog.findChild<QLineEdit *>(QStringLiteral("fileNameEdit"));
    QVERIFY(line);
    QStringList quoted;
    for (const QString &file : m_files)
        quoted << QLatin1Char('"') + file + QLatin1Char('"');
    line->setText(quoted.join(QLatin1Char(' '))); // at once, so that completion stays out of it
    QTest::keyClick(line, Qt::Key_Return);
}

void TestLensWizard::byKeyboardFromFiles()
{
    const auto wizard = makeWizard();
    QVERIFY(QTest::qWaitForWindowActive(wizard.get()));
    QVERIFY(!button(*wizard, "Next >")->isEnabled());
    // The square is reached by its shortcut, and typed.
    QTest::keyClick(wizard.get(), Qt::Key_S, Qt::AltModifier);
    QVERIFY(qobject_cast<QDoubleSpinBox *>(focused()));
    QTest::keyClick(focused(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(focused(), QStringLiteral("25.00"));
    QTest::keyClick(wizard.get(), Qt::Key_V, Qt::AltModifier);
    QVERIFY(qobject_cast<QRadioButton *>(focused()));
    BusyWatch busy;
    Person person({[this](QDialog &dialog) { typeFiles(dialog); }});
    QTest::keyClick(wizard.get(), Qt::Key_A, Qt::AltModifier);
    QTRY_COMPARE(wizard->source().files().size(), m_files.size());
    QVERIFY(person.isDone());
    QTest::keyClick(wizard.get(), Qt::Key_Return);
    QCOMPARE(page(*wizard), 1);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Next >")->isEnabled(), patienceMs);
    const int kept = wizard->findChild<FilmStrip *>()->count();
    QVERIFY(kept >= 14); // two of the poses may be alike
    QTest::keyClick(wizard.get(), Qt::Key_Return);
    QCOMPARE(page(*wizard), 2);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    QVERIFY2(busy.longestMs() < longestAllowedMs(),
             qPrintable(QStringLiteral("the event loop stood for %1 ms").arg(busy.longestMs())));
    QTest::keyClick(wizard.get(), Qt::Key_Return);
    QTRY_COMPARE(wizard->QDialog::result(), int(QDialog::Accepted));
    QCOMPARE(m_kept, std::size_t(kept));
    const StoredIntrinsics measured = wizard->result();
    QCOMPARE(measured.camera, QStringLiteral("B"));
    QCOMPARE(measured.images.size(), std::size_t(kept));
    QVERIFY(!measured.images.front().png.empty());
    // 0.3 %, what the issue of this wizard demands of simulated sets.
    QVERIFY(std::abs(measured.calibration.intrinsics.fxPx / 560 - 1) < 0.003);
}

void TestLensWizard::fortyPicturesNeverStallTheWindow()
{
    const auto wizard = makeWizard();
    wizard->source().addFiles(draw(heldBoardPoses(lens(), {}, 40, 3), QStringLiteral("forty")));
    BusyWatch busy;
    QTest::mouseClick(button(*wizard, "Next >"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Next >")->isEnabled(), patienceMs);
    QVERIFY(wizard->findChild<FilmStrip *>()->count() >= 30); // some of so many poses are alike
    QTest::mouseClick(button(*wizard, "Next >"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    QTest::mouseClick(button(*wizard, "Save"), Qt::LeftButton);
    QTRY_COMPARE(wizard->QDialog::result(), int(QDialog::Accepted));
    QVERIFY2(busy.longestMs() < longestAllowedMs(),
             qPrintable(QStringLiteral("the event loop stood for %1 ms").arg(busy.longestMs())));
}

void TestLensWizard::byMouseFromACamera()
{
    const auto wizard = makeWizard();
    auto *live = wizard->findChildren<QRadioButton *>().at(0);
    QTest::mouseClick(live, Qt::LeftButton, {}, {8, live->height() / 2});
    QVERIFY(wizard->source().isLive());
    QTest::mouseClick(button(*wizard, "Next >"), Qt::LeftButton);
    // Pictures are taken by themselves until they are enough.
    auto *strip = wizard->findChild<FilmStrip *>();
    QTRY_VERIFY_WITH_TIMEOUT(strip->count() >= 10, patienceMs);
    QVERIFY2(strip->viewport()->rect().intersects(strip->visualItemRect(strip->item(strip->count() - 1))),
             "the newest picture is in sight");
    QVERIFY(wizard->findChild<BoardImagesPage *>()->findChild<BoardCanvas *>()->content().wanted.has_value());
    QTest::mouseClick(button(*wizard, "Next >"), Qt::LeftButton);
    QCOMPARE(page(*wizard), 2);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    QTest::mouseClick(button(*wizard, "Save"), Qt::LeftButton);
    QTRY_COMPARE(wizard->QDialog::result(), int(QDialog::Accepted));
    QVERIFY(std::abs(wizard->result().calibration.intrinsics.fxPx / 560 - 1) < 0.01);
}

void TestLensWizard::cancelsAtEveryPage_data()
{
    QTest::addColumn<int>("lastPage");
    for (int last = 0; last < 3; ++last)
        QTest::addRow("page %d", last + 1) << last;
}

void TestLensWizard::cancelsAtEveryPage()
{
    QFETCH(int, lastPage);
    const auto wizard = makeWizard();
    if (lastPage > 0)
        walkToImages(*wizard);
    if (lastPage > 1)
        QTest::mouseClick(button(*wizard, "Next >"), Qt::LeftButton);
    QCOMPARE(page(*wizard), lastPage);
    if (lastPage == 0)
        QVERIFY(says(*wizard, "Add images or a video of the board."));
    if (lastPage > 0) { // boards that were found are not thrown away unasked
        Person keeper({press});
        QTest::keyClick(wizard.get(), Qt::Key_Escape);
        QVERIFY(keeper.isDone() && wizard->isVisible());
    }
    const auto discard = [](QDialog &question) {
        QVERIFY(says(question, "of the board?"));
        button(question, "Discard")->click();
    };
    Person person(lastPage > 0 ? QList<Answer>{discard} : QList<Answer>());
    QTest::keyClick(wizard.get(), Qt::Key_Escape);
    QVERIFY(person.isDone());
    QVERIFY(!wizard->isVisible());
    QCOMPARE(wizard->QDialog::result(), int(QDialog::Rejected));
}

void TestLensWizard::saysWhyPicturesDoNotCount()
{
    const QString noImage = m_folder.filePath(QStringLiteral("text.png"));
    QFile file(noImage);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("this is no picture");
    file.close();
    const auto wizard = makeWizard();
    wizard->source().addFiles({m_files[0], m_files[0] + QStringLiteral("x"), noImage});
    QTest::mouseClick(button(*wizard, "Next >"), Qt::LeftButton);
    QListWidget *refused = nullptr;
    for (auto *list : wizard->findChildren<QListWidget *>())
        if (list->accessibleName() == QStringLiteral("Rejected images"))
            refused = list;
    QVERIFY(refused);
    QTRY_COMPARE_WITH_TIMEOUT(refused->count(), 2, patienceMs);
    QVERIFY(refused->item(1)->text().startsWith(QStringLiteral("text.png: ")));
    QVERIFY2(!button(*wizard, "Next >")->isEnabled(), "one picture is too few");
    QVERIFY(says(*wizard, "At least 3 images that show the board are needed; so far there are 1."));
}

void TestLensWizard::aCutBoardFirstCostsNoPicture_data()
{
    QTest::addColumn<QString>("source");
    for (const char *source : {"images", "clip", "camera"})
        QTest::newRow(source) << QString::fromLatin1(source);
}

/// What the board is, most images decide; the first, which shows a part of it, is searched again.
void TestLensWizard::aCutBoardFirstCostsNoPicture()
{
    QFETCH(QString, source);
    const auto held = cutFirst(20);
    const auto restore = qScopeGuard([this, before = m_held] { m_held = before; });
    m_held = held;
    const auto wizard = makeWizard();
    QString first = QStringLiteral("cut01.png");
    if (source == QStringLiteral("camera")) {
        wizard->findChildren<QRadioButton *>().at(0)->setChecked(true);
        first = QStringLiteral("image 1");
    } else if (source == QStringLiteral("clip")) {
        wizard->source().addFiles({film(held)});
        first = QStringLiteral("clip.mkv@10");
    } else {
        wizard->source().addFiles(draw(held, QStringLiteral("cut")));
    }
    QTest::mouseClick(button(*wizard, "Next >"), Qt::LeftButton);
    auto *strip = wizard->findChild<FilmStrip *>();
    // The poses of heldBoardPoses differ enough, but for two of them.
    const int all = source == QStringLiteral("camera") ? 10 : 18;
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Next >")->isEnabled() && strip->count() >= all, patienceMs);
    QVERIFY(!strip->findItems(first, Qt::MatchExactly).isEmpty());
    QTest::mouseClick(button(*wizard, "Next >"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    const StoredIntrinsics lens = wizard->result();
    QCOMPARE(lens.board.columns, 9);
    QCOMPARE(lens.board.rows, 6);
    QVERIFY(lens.calibration.imagesUsed() >= std::size_t(all));
}

void TestLensWizard::takesOutAndUndoes()
{
    const auto wizard = makeWizard();
    walkToImages(*wizard);
    auto *strip = wizard->findChild<FilmStrip *>();
    const int kept = strip->count();
    strip->setCurrentRow(2);
    const QString name = strip->currentItem()->text();
    QTest::keyClick(strip, Qt::Key_Delete);
    QTRY_COMPARE(strip->count(), kept - 1);
    QVERIFY(strip->item(2)->text() != name);
    QTest::keyClick(strip, Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(strip->count(), kept);
    QCOMPARE(strip->item(2)->text(), name);
    QVERIFY(!strip->undoAction()->isEnabled());
}

/// It is the RMS that a calibration by the accepted images alone gives; of too few there is none.
void TestLensWizard::saysTheRmsOfTheImagesSoFar()
{
    const auto wizard = makeWizard();
    walkToImages(*wizard);
    auto *words = wizard->findChild<RmsSoFar *>();
    const auto settled = [&] {
        return QTest::qWaitFor([&] { return words->isSettled() && words->text().contains(u"RMS so far"); },
                               patienceMs);
    };
    QVERIFY2(settled(), qPrintable(words->text()));
    BoardCollector collector(BoardSpec{});
    for (const QString &file : m_files)
        collector.offer(*readImage(file.toStdString()), file.toStdString());
    const std::vector<BoardView> views = collector.views();
    const auto fit = calibrateIntrinsics(views, widthPx, heightPx, LensModel::Standard, {});
    QVERIFY(fit.has_value());
    const QString expected = QStringLiteral("RMS so far: %1 px;").arg(fit->rmsPx, 0, 'f', 2);
    QVERIFY2(words->text().startsWith(expected), qPrintable(words->text() + expected));
    auto *strip = wizard->findChild<FilmStrip *>();
    while (strip->count() > 2) {
        const int before = strip->count();
        strip->setCurrentRow(0);
        QTest::keyClick(strip, Qt::Key_Delete);
        QTRY_COMPARE(strip->count(), before - 1);
    }
    QCOMPARE(words->text(), QStringLiteral("RMS: from 3 images on"));
    QTest::keyClick(strip, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY2(settled() || words->text().startsWith(u"RMS: not yet"), qPrintable(words->text()));
}

void TestLensWizard::leavesOutWhatIsAboveTheThreshold()
{
    const auto wizard = makeWizard();
    walkToImages(*wizard);
    QTest::mouseClick(button(*wizard, "Next >"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    const std::size_t kept = wizard->result().calibration.imagesUsed();
    auto *bars = wizard->findChild<ImageBars *>();
    // from 1.5 times the worst down
    for (int i = 0; i < 30 && wizard->result().calibration.imagesUsed() == kept; ++i) {
        QTest::keyClick(bars, Qt::Key_Down);
        QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    }
    const StoredIntrinsics fewer = wizard->result();
    QVERIFY(fewer.calibration.imagesUsed() < kept);
    for (int i = 0; i < 40; ++i)
        QTest::keyClick(bars, Qt::Key_Up);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    QCOMPARE(wizard->result().calibration.imagesUsed(), kept);
}

void TestLensWizard::aBarIsChosenAndTheThresholdDragged()
{
    ImageBars bars;
    bars.resize(500, 220);
    bars.setBars({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c"), QStringLiteral("d")},
                 {0.2, 0.3, 0.1, 0.4});
    bars.show();
    QVERIFY(std::abs(bars.threshold() - 1.5 * 0.4) < 1e-9);
    QSignalSpy chosen(&bars, &ImageBars::currentChanged), changed(&bars, &ImageBars::thresholdChanged);
    QTest::mouseClick(bars.viewport(), Qt::LeftButton, {}, bars.plot().at(1, 0.15).toPoint());
    QCOMPARE(bars.current(), 1);
    QCOMPARE(chosen.count(), 1);
    const auto ink = [&bars](double index) { // how many pixels of a bar are filled
        const QImage image = bars.grab().toImage();
        const QPoint middle = bars.plot().at(index, 0.05).toPoint();
        int filled = 0;
        for (int x = -8; x <= 8; ++x)
            for (int y = -4; y <= 4; ++y)
                filled += image.pixelColor(middle + QPoint(x, y)) == ThemeColours::of(bars.palette()).accent;
        return filled;
    };
    constexpr int all = 17 * 9;
    QCOMPARE(ink(0), all);
    QCOMPARE(ink(3), all);
    const QPoint from = bars.plot().at(2, bars.threshold()).toPoint(), to = bars.plot().at(2, 0.35).toPoint();
    QTest::mousePress(bars.viewport(), Qt::LeftButton, {}, from);
    QTest::mouseMove(bars.viewport(), to);
    QCOMPARE(changed.count(), 0); // it is not let go yet
    QTest::mouseRelease(bars.viewport(), Qt::LeftButton, {}, to);
    QCOMPARE(changed.count(), 1);
    QVERIFY2(std::abs(bars.threshold() - 0.35) < 0.01,
             qPrintable(QString::number(bars.threshold()))); // a pixel
    QCOMPARE(bars.current(), 1);
    QCOMPARE(ink(0), all);
    QCOMPARE(ink(3), 0); // hatched in another colour: it does not count
    bars.showValues(ValueRange{0, 0.5});
    bars.setCurrent(2);
    QCOMPARE(bars.plot().values.high, 0.5); // as it was zoomed
    bars.setBars({QStringLiteral("a")}, {0.2});
    QVERIFY(bars.plot().values.high < 0.5);
}

void TestLensWizard::tellsOfALostCamera()
{
    const auto wizard = makeWizard(false);
    wizard->findChildren<QRadioButton *>().at(0)->setChecked(true);
    QTest::mouseClick(button(*wizard, "Next >"), Qt::LeftButton);
    QTRY_VERIFY(says(*wizard, "the camera does not answer; plug it in again"));
}

void TestLensWizard::staysOpenWhenTheDiskIsFull()
{
    const auto wizard = makeWizard();
    walkToImages(*wizard);
    QTest::mouseClick(button(*wizard, "Next >"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    m_problem = test::saidError(ErrorCode::Io, "calibration image 'B_1'", "no space left on device",
                                "check the free space");
    QTest::mouseClick(button(*wizard, "Save"), Qt::LeftButton);
    QTRY_VERIFY(says(*wizard, "The lens calibration was not stored. calibration image 'B_1': no space left "
                              "on device; check the free space"));
    QVERIFY(wizard->isVisible());
    m_problem.reset();
    QTRY_VERIFY(button(*wizard, "Save")->isEnabled());
    QTest::mouseClick(button(*wizard, "Save"), Qt::LeftButton);
    QTRY_COMPARE(wizard->QDialog::result(), int(QDialog::Accepted));
}

void TestLensWizard::everyHintHasItsWords()
{
    QSet<QString> words;
    for (int hint = 0; hint <= int(BoardHint::HoldStill); ++hint)
        words << wordsOf(BoardHint(hint));
    QCOMPARE(words.size(), qsizetype(int(BoardHint::HoldStill) + 1));
    QVERIFY(!words.contains(QString()));
}

ODOGRAPH_TEST(TestLensWizard, QApplication)
#include "tst_lens_wizard.moc"
