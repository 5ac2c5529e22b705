// SPDX-License-Identifier: GPL-3.0-or-later
// The silhouettes in Review's views are shown and hidden by a key, and stay as they were left.
#include "core/project/project.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"
#include "ui/models/timeline.h"
#include "ui/review/review_desk.h"
#include "ui/review/review_page.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/image/camera_view.h"

#include <QAction>
#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <cstdlib>
#include <memory>

using namespace odo;

class TestSilhouetteSwitch : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings().clear();
        const auto made = storeExample(m_folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_project = std::move(*Project::open(*made, Project::Access::ReadWrite));
    }
    void init()
    {
        m_page = std::make_unique<ReviewPage>(*m_project);
        m_page->resize(1400, 900);
        m_page->refresh();
        m_page->show();
        QTRY_VERIFY(m_page->scene());
        m_page->timeline().setCurrentFrame(20);
        QTRY_VERIFY(m_page->isSettled());
    }

    void cleanupTestCase() { QSettings().clear(); }

    void theyAreShownAtFirst()
    {
        QVERIFY(action()->isChecked());
        QVERIFY(drawn() > 60);
    }

    void aKeyHidesThemForGood()
    {
        const int before = drawn();
        m_page->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_page.get()));
        m_page->setFocus();
        QTest::keyClick(m_page.get(), Qt::Key_S);
        QVERIFY(!action()->isChecked());
        QVERIFY(drawn() < before - 30);
        init(); // a new window
        QVERIFY(!action()->isChecked());
        QVERIFY(drawn() < before - 30);
        action()->trigger();
        QCOMPARE(drawn(), before);
    }

private:
    QAction *action() const
    {
        for (QAction *each : m_page->desk().viewActions())
            if (each->objectName() == QStringLiteral("silhouettes"))
                return each;
        return nullptr;
    }
    static bool isNear(const QColor &a, const QColor &b)
    {
        return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) <
               60;
    }
    /// Pixels of the first view that have the first robot's colour: its outline, name and trail.
    int drawn() const
    {
        const QImage image = m_page->findChild<CameraView *>()->imageArea()->grab().toImage();
        const QColor colour = colourOnImage(0);
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += isNear(image.pixelColor(x, y), colour);
        return count;
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
    std::unique_ptr<ReviewPage> m_page;
};

ODOGRAPH_TEST(TestSilhouetteSwitch, QApplication)
#include "tst_silhouette_switch.moc"
