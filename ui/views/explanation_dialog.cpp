// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/explanation_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace odo {
namespace {

class ExplanationDialogWords
{
    Q_DECLARE_TR_FUNCTIONS(ExplanationDialog)
};

constexpr QSize usualSize(480, 420);

} // namespace

QString howComputedWords()
{
    return ExplanationDialogWords::tr("How was this computed?");
}

void showExplanation(QWidget *parent, const Explanation &explanation)
{
    auto *dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("explanation"));
    dialog->setWindowTitle(howComputedWords());
    auto *text = new QPlainTextEdit(explanation.text());
    text->setReadOnly(true);
    text->setTabChangesFocus(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text->setAccessibleName(howComputedWords());
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton *copy = buttons->addButton(ExplanationDialogWords::tr("&Copy"), QDialogButtonBox::ActionRole);
    QObject::connect(copy, &QPushButton::clicked, dialog,
                     [words = explanation.text()] { QApplication::clipboard()->setText(words); });
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto *layout = new QVBoxLayout(dialog);
    layout->addWidget(text);
    layout->addWidget(buttons);
    dialog->resize(usualSize);
    dialog->show();
}

} // namespace odo
