// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/demo.h"
#include "core/workflow/project_copy.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QGuiApplication>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestNewProjectLike : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        const auto made = storeExample(m_folder->path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_original = *made;
        m_new = m_folder->filePath(QStringLiteral("next year.odo")).toStdString();
    }
    void theSetUpIsTakenOver()
    {
        QVERIFY(makeProjectLike(m_original, m_new, "Next year", {}));
        const auto from = Project::open(m_original, Project::Access::ReadOnly),
                   to = Project::open(m_new, Project::Access::ReadWrite);
        QVERIFY(from && to);
        QCOMPARE((*to)->title().value(), std::string("Next year"));
        QVERIFY(!(*from)->cameras().all()->empty());
        QCOMPARE((*to)->cameras().all()->size(), (*from)->cameras().all()->size());
        const auto cameras = (*to)->cameras().all();
        for (const CameraRecord &camera : *cameras) {
            const auto before =
                (*from)->cameras().currentIntrinsics((*from)->cameras().find(camera.name)->id);
            const auto lens = (*to)->cameras().currentIntrinsics(camera.id);
            QVERIFY(before->has_value() && lens->has_value());
            QCOMPARE((*lens)->calibration.intrinsics.fxPx, (*before)->calibration.intrinsics.fxPx);
            QVERIFY(!(*to)->cameras().currentRegistration(camera.id)->has_value()); // it stands elsewhere now
        }
        QCOMPARE((*to)->layouts().all()->front().layout.name, (*from)->layouts().all()->front().layout.name);
        QCOMPARE((*to)->robots().all()->size(), (*from)->robots().all()->size());
        QCOMPARE((*to)->tasks().current()->size(), (*from)->tasks().current()->size());
        const auto tasks = (*to)->tasks().current();
        for (const TaskRecord &task : *tasks)
            QCOMPARE((*to)->tasks().scoring(task.id)->size(),
                     (*from)->tasks().scoring((*from)->tasks().find(task.name)->id)->size());
        QVERIFY((*to)->teams().all()->empty() && (*to)->trials().names()->empty());
        QVERIFY((*to)->check(false)->empty());
    }
    void whatIsThereStays()
    {
        QVERIFY(makeProjectLike(m_original, m_new, "Next year", {}));
        const auto again = makeProjectLike(m_original, m_new, "Another", {});
        QVERIFY(!again);
        QCOMPARE(again.error().code, ErrorCode::AlreadyExists);
        QCOMPARE((*Project::open(m_new, Project::Access::ReadOnly))->title().value(),
                 std::string("Next year"));
    }
    void noNameOfAnotherProjectIsTaken()
    {
        const std::filesystem::path lock = m_original.string() + ".lock";
        QCOMPARE(makeProjectLike(m_original, lock, "Next year", {}).error().code, ErrorCode::WrongCall);
        const std::filesystem::path demo =
            m_original.parent_path() / (m_original.stem().string() + ".media") / "demo";
        QCOMPARE(makeDemo(demo, {}).error().code, ErrorCode::WrongCall);
        QVERIFY(!std::filesystem::exists(lock) && !std::filesystem::exists(demo));
    }
    void nothingHalfMadeIsLeft()
    {
        JobControl control;
        control.cancel.cancel();
        const auto stopped = makeProjectLike(m_original, m_new, "Next year", control);
        QVERIFY(!stopped && stopped.error().code == ErrorCode::Cancelled);
        QVERIFY(!std::filesystem::exists(m_new));
        QVERIFY(!makeProjectLike(m_folder->filePath(QStringLiteral("none.odo")).toStdString(), m_new,
                                 "Next year", {}));
        QVERIFY(!std::filesystem::exists(m_new));
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_original, m_new;
};

ODOGRAPH_TEST(TestNewProjectLike, QGuiApplication)
#include "tst_new_project_like.moc"
