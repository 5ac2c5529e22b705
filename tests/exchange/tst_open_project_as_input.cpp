// SPDX-License-Identifier: GPL-3.0-or-later
// A project that this process has open is named as an input of another kind: it is not opened a second time,
// or the locks of the first opening would be gone.
#include "core/exchange/text_file.h"
#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/video/image_reader.h"
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestOpenProjectAsInput : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        m_file = m_folder.filePath(QStringLiteral("lesson.odo")).toStdString();
        m_project = std::move(*Project::create(m_file, "lesson"));
        QVERIFY(m_project->setTitle("again")); // so that there is a log
        std::filesystem::create_symlink(m_file, link());
    }

    void isRefused_data()
    {
        QTest::addColumn<std::filesystem::path>("file");
        QTest::newRow("project") << m_file;
        QTest::newRow("link") << link();
        QTest::newRow("log") << std::filesystem::path(m_file.string() + "-wal");
        QTest::newRow("index") << std::filesystem::path(m_file.string() + "-shm");
    }
    void isRefused()
    {
        QFETCH(std::filesystem::path, file);
        for (const auto &[what, error] : {std::pair{"a table", errorOf(TextFile::open(file, 1 << 20))},
                                          std::pair{"a video", errorOf(VideoReader::open(file))},
                                          std::pair{"a picture", errorOf(readImage(file))},
                                          std::pair{"a recording", errorOf(fileSha256(file, {}))}}) {
            QVERIFY2(error.code == ErrorCode::InvalidInput, what);
            QVERIFY2(error.why.english() == "it is a project that is open here", error.message().c_str());
        }
    }

    void onceItIsClosedItIsAFileAsAnyOther()
    {
        m_project.reset();
        QVERIFY(fileSha256(m_file, {}));
        QVERIFY(errorOf(VideoReader::open(m_file)).why.english() != "it is a project that is open here");
    }

private:
    template <class Value>
    static Error errorOf(const Result<Value> &result)
    {
        return result ? Error{} : result.error();
    }
    std::filesystem::path link() const { return m_file.parent_path() / "link.odo"; }

    QTemporaryDir m_folder;
    std::filesystem::path m_file;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestOpenProjectAsInput, QCoreApplication)
#include "tst_open_project_as_input.moc"
