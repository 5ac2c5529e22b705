// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/school/internal/conflict_dialog.h"

#include "ui/models/shown_message.h"
#include "ui/school/internal/conflict_rows.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/table_list.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <utility>

namespace odo {

namespace {

enum Columns { WhatColumn, HereColumn, ThereColumn, ColumnCount };

constexpr int listWidth = 220, rowPadding = 5;
constexpr QSize usualSize(860, 440);

QString subjectOf(const SchoolConflict &conflict)
{
    const QString words = shownWords(schoolDocumentSubject(conflict.kind, conflict.name));
    return words.left(1).toUpper() + words.mid(1);
}

} // namespace

ConflictDialog::ConflictDialog(std::vector<SchoolConflict> conflicts, QWidget *parent)
    : QDialog(parent), m_conflicts(std::move(conflicts)), m_list(new QListWidget), m_inForce(new QLabel),
      m_values(new QTableWidget(0, ColumnCount))
{
    setWindowTitle(tr("Changed here and elsewhere"));
    auto *intro = new QLabel(tr("You and another bench changed these. Nothing is lost: the hub keeps the "
                                "version that is not in force. To bring a value back, enter it here again."));
    intro->setWordWrap(true);
    m_list->setAccessibleName(tr("What was changed twice"));
    m_list->setFixedWidth(listWidth);
    m_list->setTextElideMode(Qt::ElideMiddle);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    for (const SchoolConflict &conflict : m_conflicts) {
        auto *item = new QListWidgetItem(subjectOf(conflict), m_list);
        item->setToolTip(subjectOf(conflict).toHtmlEscaped());
        item->setSizeHint({0, m_list->fontMetrics().lineSpacing() + 2 * rowPadding});
    }
    m_values->setAccessibleName(tr("Values that differ"));
    showAsList(*m_values);
    m_values->setWordWrap(true);
    m_values->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_values->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    showAsWords(*m_inForce);
    auto *buttons = new QDialogButtonBox;
    QPushButton *close = buttons->addButton(QDialogButtonBox::Close);
    close->setDefault(true);
    QPushButton *done = plainButton(tr("&Remove all from this list"));
    buttons->addButton(done, QDialogButtonBox::AcceptRole);
    auto *right = new QVBoxLayout;
    right->addWidget(m_inForce);
    right->addWidget(m_values, 1);
    auto *middle = new QHBoxLayout;
    middle->addWidget(m_list);
    middle->addLayout(right, 1);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(intro);
    layout->addLayout(middle, 1);
    layout->addWidget(buttons);
    resize(usualSize);
    connect(m_list, &QListWidget::currentRowChanged, this, &ConflictDialog::showConflict);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    m_list->setCurrentRow(0);
}

void ConflictDialog::showConflict(int row)
{
    const SchoolConflict *conflict = recordAt(m_conflicts, row);
    const std::vector<ConflictRow> rows = conflict ? conflictRows(*conflict) : std::vector<ConflictRow>();
    const bool isOurs = conflict && conflict->isOursInForce;
    m_inForce->setText(isOurs ? tr("The version of this project is in force.")
                              : tr("The version of the hub is in force. It comes with the next “Pull”."));
    m_values->setHorizontalHeaderLabels({tr("What"), tr("In this project"), tr("At the hub")});
    m_values->setRowCount(static_cast<int>(rows.size()));
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        const ConflictRow &values = rows[static_cast<std::size_t>(i)];
        for (const auto &[column, text] :
             {std::pair{WhatColumn, values.what}, std::pair{HereColumn, values.here},
              std::pair{ThereColumn, values.there}}) {
            auto *item = new QTableWidgetItem(text.isEmpty() ? QStringLiteral("–") : text);
            item->setToolTip(text.toHtmlEscaped());
            m_values->setItem(i, column, item);
        }
    }
}

} // namespace odo
