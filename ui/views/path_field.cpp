// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/path_field.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QUrl>

namespace odo {

std::filesystem::path pathOf(const QString &text)
{
    return std::filesystem::path(text.trimmed().toStdString());
}

QString textOf(const std::filesystem::path &path)
{
    return QString::fromStdString(path.string());
}

QStringList localFiles(const QMimeData &data)
{
    QStringList files;
    for (const QUrl &url : data.urls())
        if (url.isLocalFile())
            files << url.toLocalFile();
    return files;
}

PathField::PathField(const QString &name, const QString &filter, QWidget *parent)
    : QWidget(parent), m_line(new QLineEdit(this)), m_name(name), m_filter(filter)
{
    m_line->setAccessibleName(name);
    m_line->setAcceptDrops(false); // a dropped file replaces the text, it is not inserted into it
    setAcceptDrops(true);
    setFocusPolicy(Qt::StrongFocus); // so that the tab order takes it with its line and button
    setFocusProxy(m_line);
    auto *button = new QPushButton(tr("Browse…"), this);
    button->setAccessibleName(tr("Browse: %1").arg(name));
    button->setAutoDefault(false); // Enter is the dialog's
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_line, 1);
    layout->addWidget(button);
    connect(button, &QPushButton::clicked, this, &PathField::browse);
    connect(m_line, &QLineEdit::textChanged, this, &PathField::changed);
}

std::filesystem::path PathField::path() const
{
    return pathOf(m_line->text());
}

void PathField::setPath(const QString &path)
{
    m_line->setText(path);
}

void PathField::browse()
{
    const QString file = QFileDialog::getOpenFileName(this, m_name, m_line->text(), m_filter);
    if (!file.isEmpty())
        m_line->setText(file);
}

void PathField::dragEnterEvent(QDragEnterEvent *event)
{
    if (!localFiles(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void PathField::dropEvent(QDropEvent *event)
{
    m_line->setText(localFiles(*event->mimeData()).constFirst());
    event->acceptProposedAction();
}

} // namespace odo
