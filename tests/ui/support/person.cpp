// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/person.h"

#include <QApplication>
#include <QComboBox>
#include <QInputDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

namespace odo {

Person::Person(QList<Answer> answers) : m_answers(std::move(answers))
{
    connect(&m_timer, &QTimer::timeout, this, &Person::look);
    m_timer.start(5);
}

void Person::look()
{
    auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget());
    if (!dialog || (m_answering && dialog == m_answered))
        return;
    if (dialog == m_answered || m_answers.isEmpty()) { // unasked, or still open after its answer
        ++m_unasked;
        dialog->reject();
        return;
    }
    m_answered = dialog;
    m_answering = true;
    m_answers.takeFirst()(*dialog);
    m_answering = false;
}

void press(QDialog &dialog)
{
    for (auto *button : dialog.findChildren<QPushButton *>())
        if (button->isDefault()) {
            QVERIFY2(button->isEnabled(), qPrintable(dialog.windowTitle()));
            return QTest::mouseClick(button, Qt::LeftButton);
        }
    QFAIL("the dialog has no button to press");
}

Answer chooseFile(const QString &file)
{
    return [file](QDialog &dialog) {
        auto *line = dialog.findChild<QLineEdit *>(QStringLiteral("fileNameEdit"));
        QVERIFY2(line, qPrintable(dialog.windowTitle()));
        line->setText(file);
        QMetaObject::invokeMethod(&dialog, "accept");
    };
}

Answer enterText(const QString &text)
{
    return [text](QDialog &dialog) {
        auto &input = dynamic_cast<QInputDialog &>(dialog);
        if (auto *box = input.findChild<QComboBox *>())
            box->setEditText(text);
        else
            input.setTextValue(text);
        input.accept();
    };
}

} // namespace odo
