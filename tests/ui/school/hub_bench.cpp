// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/school/hub_bench.h"

#include <QTest>
#include <algorithm>

namespace odo::test {

QString HubBench::start()
{
    QString problem = server.start();
    if (!problem.isEmpty())
        return problem;
    if (const auto made = initialiseHub(address("postgres")); !made)
        return QString::fromStdString(whyNot(made));
    server.sql(
        QStringLiteral("CREATE ROLE bench1 LOGIN IN ROLE bench; CREATE ROLE bench2 LOGIN IN ROLE bench; "
                       "CREATE ROLE anna LOGIN IN ROLE teacher; CREATE ROLE stranger LOGIN; "
                       "CREATE ROLE secret LOGIN PASSWORD 'hunter2' IN ROLE bench"));
    return {};
}

void HubBench::clear()
{
    m_folder = std::make_unique<QTemporaryDir>();
    server.sql(QStringLiteral("DELETE FROM odograph.document; DELETE FROM odograph.older_document"));
}

std::unique_ptr<Project> HubBench::project(const char *name, int trials) const
{
    auto project = Project::create(m_folder->filePath(QString::fromLatin1(name)).toStdString(), "Bench");
    if (!project)
        qFatal("%s", whyNot(project).c_str());
    if (const auto filled = addBenchTrials(**project, 1, trials); !filled)
        qFatal("%s", whyNot(filled).c_str());
    return std::move(*project);
}

HubAddress HubBench::address(const char *login) const
{
    return *HubAddress::parse(server.url(QString::fromLatin1(login)).toStdString());
}

HubPace quickPace()
{
    using std::chrono::milliseconds;
    return {milliseconds(20), milliseconds(100), milliseconds(100), milliseconds(200)};
}

StandstillWatch::StandstillWatch()
{
    m_since.start();
    startTimer(1);
}

void StandstillWatch::timerEvent(QTimerEvent *)
{
    m_longestMs = std::max(m_longestMs, m_since.restart());
}

} // namespace odo::test
