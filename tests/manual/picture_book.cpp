// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/manual/picture_book.h"

#include "tests/ui/support/driven_window.h"
#include "ui/main_window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QImage>
#include <QPainter>
#include <QTest>

namespace odo::test {
namespace {

constexpr QSize windowPx(1280, 800);
constexpr int lookMs = 150, looks = 3, longestMs = 8000;

} // namespace

PictureBook::PictureBook(QString folder)
    : m_folder(std::move(folder)), m_window(std::make_unique<MainWindow>())
{
    fitWindow();
    m_window->show();
}

PictureBook::~PictureBook() = default;

void PictureBook::fitWindow()
{
    m_window->resize(windowPx);
}

void PictureBook::open(const QString &project)
{
    QVERIFY(m_window->openProject(project.toStdString()));
    waitFor(*m_window);
}

void PictureBook::showPage(WindowMode mode)
{
    m_window->showMode(mode);
    waitFor(*m_window);
}

void PictureBook::write(const QImage &image, const QString &name)
{
    QImage framed = image.convertToFormat(QImage::Format_RGB32);
    QPainter painter(&framed);
    painter.setPen(QColor(0xb0, 0xb4, 0xb8)); // a dialog has no edge of its own
    painter.drawRect(framed.rect().adjusted(0, 0, -1, -1));
    painter.end();
    QVERIFY2(framed.save(QDir(m_folder).filePath(name + QStringLiteral(".png"))), qPrintable(name));
    m_names << name;
}

void PictureBook::take(QWidget &widget, const QString &name)
{
    waitUntilStill(widget);
    write(widget.grab().toImage(), name);
}

void PictureBook::takeWindow(const QString &name)
{
    waitFor(*m_window);
    take(*m_window, name);
}

void PictureBook::takeDialog(const char *command, const QString &name,
                             const std::function<void(QDialog &)> &fill)
{
    auto *action = m_window->findChild<QAction *>(QString::fromLatin1(command));
    QVERIFY2(action && action->isEnabled(), command);
    const auto look = [&](QDialog &dialog) {
        if (fill)
            fill(dialog);
        if (!name.isEmpty())
            take(dialog, name);
        dialog.done(QDialog::Rejected); // without the question that Esc may ask
    };
    Person person({look});
    action->trigger();
    for (QWidget *other : QApplication::topLevelWidgets()) // one that does not wait for an answer
        if (auto *dialog = qobject_cast<QDialog *>(other); dialog && dialog->isVisible())
            look(*dialog);
    waitFor(*m_window);
}

void waitUntilStill(QWidget &widget)
{
    QElapsedTimer since;
    since.start();
    QImage last;
    for (int same = 0; same < looks && since.elapsed() < longestMs;) {
        QTest::qWait(lookMs);
        const QImage now = widget.grab().toImage();
        same = now == last ? same + 1 : 0;
        last = now;
    }
}

} // namespace odo::test
