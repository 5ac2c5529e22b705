// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/program_ends.h"

#include "core/base/crash_report.h"
#include "core/base/file_system.h"
#include "core/base/platform/process.h"
#include "ui/main_window/main_window.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QSocketNotifier>
#include <QVBoxLayout>

namespace odo {

CrashNotice::CrashNotice(const std::filesystem::path &report,
                         const std::optional<std::filesystem::path> &project, QWidget *parent)
    : QDialog(parent)
{
    setWindowTitle(tr("Odograph ended unexpectedly"));
    auto *words =
        new QLabel(project ? tr("Odograph crashed the last time. Saved data is safe. If a recording was cut "
                                "off, open its project to recover it up to the last second.")
                           : tr("Odograph crashed the last time. Saved data is safe."));
    words->setTextFormat(Qt::PlainText);
    words->setWordWrap(true);
    const auto pathLabel = [](const std::filesystem::path &path, const char *name) {
        auto *label = new ElidedLabel;
        label->setFullText(QDir::toNativeSeparators(textOf(path)));
        label->setObjectName(QString::fromLatin1(name));
        return label;
    };
    auto *form = new QFormLayout;
    if (project)
        form->addRow(tr("Project:"), pathLabel(*project, "project"));
    form->addRow(tr("Report:"), pathLabel(report, "report"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addLayout(form);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    if (project) {
        QPushButton *open = buttons->addButton(tr("&Open the project"), QDialogButtonBox::AcceptRole);
        open->setDefault(true);
        connect(open, &QPushButton::clicked, this, [this, project = *project] {
            accept();
            Q_EMIT openRequested(project);
        });
    }
    constexpr int width = 520;
    resize(width, layout->totalHeightForWidth(width));
}

void reportCrashes(MainWindow &window, const std::filesystem::path &folder,
                   const std::optional<std::filesystem::path> &opening)
{
    const std::vector<CrashReport> reports = newCrashReports(folder);
    if (reports.empty())
        return;
    std::filesystem::path told;
    for (const CrashReport &report : reports)
        told = keepShownReport(report);
    std::optional<std::filesystem::path> project = reports.back().project;
    const bool isOpenedAnyway = project && opening && files::isSame(*project, *opening);
    if (isOpenedAnyway || (project && !files::exists(*project)))
        project.reset();
    auto *notice = new CrashNotice(told, project, &window);
    notice->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(notice, &CrashNotice::openRequested, &window, &MainWindow::beginOpening);
    notice->open();
}

StopRequests::StopRequests(MainWindow &window) : m_window(window)
{
    connect(
        qGuiApp, &QGuiApplication::commitDataRequest, this, [this] { m_window.finishRecording(); },
        Qt::DirectConnection);
    if (stopDescriptor() < 0)
        return;
    auto *notifier = new QSocketNotifier(stopDescriptor(), QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, [this, notifier] {
        notifier->setEnabled(false); // it stays readable
        stop();
    });
}

void StopRequests::stop()
{
    m_window.finishRecording();
    m_window.close();
    QCoreApplication::exit(); // also where a dialog is open
}

} // namespace odo
