// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/welcome_page.h"

#include "ui/main_window/file_actions.h"
#include "ui/main_window/recent_projects.h"
#include "ui/views/empty_state.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace odo {
namespace {
constexpr int mostRows = 5;
constexpr int rowHeight = 44;
} // namespace

WelcomePage::WelcomePage(FileActions &files, RecentProjects &recent, QWidget *parent)
    : QWidget(parent), m_recent(recent), m_recentBox(new QWidget), m_list(new QListWidget)
{
    setObjectName(QStringLiteral("page"));
    auto *state =
        new EmptyState(QStringLiteral("review"), tr("Odograph"),
                       tr("Measures how a mobile robot moved, from the videos of ordinary cameras."));
    const auto add = [state](const QString &icon, QAction *action) {
        QPushButton *button = state->addButton(icon, action->text().remove(QLatin1Char('&')));
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
    };
    add(QStringLiteral("demo"), files.demo());
    add(QStringLiteral("new"), files.newProject());
    add(QStringLiteral("open"), files.openProject());

    m_list->setAccessibleName(tr("Recent projects"));
    auto *title = new QLabel(tr("Recent projects"));
    title->setObjectName(QStringLiteral("quiet"));
    auto *boxLayout = new QVBoxLayout(m_recentBox);
    boxLayout->setContentsMargins(0, 18, 0, 0);
    boxLayout->addWidget(title);
    boxLayout->addWidget(m_list);
    state->addWidget(m_recentBox);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(state);
    connect(m_list, &QListWidget::itemActivated, this,
            [this](QListWidgetItem *item) { Q_EMIT recentChosen(item->data(Qt::UserRole).toString()); });
    connect(m_list, &QListWidget::itemClicked, m_list, &QListWidget::itemActivated);
    connect(&m_recent, &RecentProjects::changed, this, &WelcomePage::fillRecent);
    fillRecent();
}

void WelcomePage::fillRecent()
{
    m_list->clear();
    const QStringList files = m_recent.files().mid(0, mostRows);
    for (const QString &file : files) {
        const QFileInfo info(file);
        const bool exists = RecentProjects::exists(file);
        auto *item = new QListWidgetItem(m_list);
        item->setText(QStringLiteral("%1\n%2").arg(info.completeBaseName(),
                                                   exists ? QDir::toNativeSeparators(info.path())
                                                          : tr("not found any more")));
        item->setData(Qt::UserRole, file);
        item->setToolTip(file.toHtmlEscaped());
        item->setSizeHint({0, rowHeight});
        if (!exists)
            item->setFlags(Qt::NoItemFlags);
    }
    m_list->setFixedHeight(static_cast<int>(files.size()) * rowHeight + 4);
    m_recentBox->setVisible(!files.isEmpty());
}

} // namespace odo
