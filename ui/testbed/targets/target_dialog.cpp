// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/targets/target_dialog.h"

#include "core/base/units.h"
#include "core/calibration/floor_mat.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/targets/mat_sheet.h"
#include "ui/testbed/targets/target_sheet.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/theme.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>

namespace odo {

/// The sheets as they will come out of the printer, side by side, as large as there is room. Paper stays
/// white in the dark.
class TargetPreview : public QWidget
{
    Q_OBJECT
public:
    explicit TargetPreview(QWidget *parent = nullptr);
    void setSheets(const TargetSpec &spec, std::vector<TargetSheet> sheets);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    TargetSpec m_spec;
    std::vector<TargetSheet> m_sheets;
};

namespace {

constexpr int gapPx = 14, leastPx = 260;

/// The number of columns with which so many sheets come out largest, and how large: pixels a millimetre.
std::pair<int, double> bestGrid(int sheets, QSizeF paperMm, QSizeF roomPx)
{
    std::pair<int, double> best{1, 0};
    for (int columns = 1; columns <= sheets; ++columns) {
        const int rows = (sheets + columns - 1) / columns;
        const double scale = std::min((roomPx.width() - (columns + 1) * gapPx) / (columns * paperMm.width()),
                                      (roomPx.height() - (rows + 1) * gapPx) / (rows * paperMm.height()));
        if (scale > best.second)
            best = {columns, scale};
    }
    return best;
}

} // namespace

TargetPreview::TargetPreview(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("Preview of the sheets"));
    setMinimumSize(leastPx, leastPx);
}

void TargetPreview::setSheets(const TargetSpec &spec, std::vector<TargetSheet> sheets)
{
    m_spec = spec;
    m_sheets = std::move(sheets);
    update();
}

void TargetPreview::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.fillRect(rect(), colours.mapGround);
    if (m_sheets.empty())
        return;
    const int count = int(m_sheets.size());
    const QSizeF paper = m_sheets.front().paperMm;
    const auto [columns, scale] = bestGrid(count, paper, size());
    if (scale <= 0)
        return;
    const int rows = (count + columns - 1) / columns;
    const QSizeF sheetPx = paper * scale;
    const QPointF start(0.5 * (width() - columns * sheetPx.width() - (columns - 1) * gapPx),
                        0.5 * (height() - rows * sheetPx.height() - (rows - 1) * gapPx));
    for (int i = 0; i < count; ++i) {
        const int row = i / columns;
        const QPointF corner =
            start + QPointF((i % columns) * (sheetPx.width() + gapPx), row * (sheetPx.height() + gapPx));
        painter.save();
        painter.translate(corner);
        painter.setPen(colours.border);
        painter.setBrush(Qt::white);
        painter.drawRect(QRectF(QPointF(0, 0), sheetPx));
        painter.scale(scale, scale);
        paintTarget(painter, m_spec, m_sheets[std::size_t(i)]);
        painter.restore();
    }
}

namespace {

constexpr int formWidth = 300;
constexpr double smallestMm = 5, largestMm = 400;

QDoubleSpinBox *lengthBox(double mm)
{
    auto *box = new NumberBox;
    box->setRange(smallestMm, largestMm);
    box->setDecimals(1);
    box->setSuffix(TargetDialog::tr(" mm"));
    box->setValue(mm);
    return box;
}

QSpinBox *countBox(int count, int least, int most, const QString &name)
{
    auto *box = new QSpinBox;
    box->setRange(least, most);
    box->setValue(count);
    box->setAccessibleName(name);
    return box;
}

/// "9 × 6"
QWidget *sizeRow(QSpinBox *columns, QSpinBox *rows)
{
    auto *widget = new QWidget;
    auto *row = new QHBoxLayout(widget);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(columns);
    row->addWidget(new QLabel(TargetDialog::tr("×")));
    row->addWidget(rows);
    row->addStretch(1);
    return widget;
}

} // namespace

TargetDialog::TargetDialog(TargetKind kind, const QStringList &labels, QWidget *parent)
    : QDialog(parent), m_kind(new QComboBox), m_paper(new QComboBox),
      m_columns(countBox(9, 3, 30, tr("Inner corners along the board"))),
      m_rows(countBox(6, 3, 30, tr("Inner corners across the board"))),
      m_sheetColumns(countBox(4, 1, FloorMat::mostColumns, tr("Sheets in a row of the mat"))),
      m_sheetRows(countBox(3, 1, FloorMat::mostRows, tr("Rows of the mat"))), m_square(lengthBox(25)),
      m_marker(lengthBox(150)), m_labels(new QLineEdit), m_form(new QFormLayout),
      m_corners(sizeRow(m_columns, m_rows)), m_sheets(sizeRow(m_sheetColumns, m_sheetRows)),
      m_preview(new TargetPreview), m_message(new QLabel),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Close))
{
    setWindowTitle(tr("Print targets"));
    auto *content = new QHBoxLayout;
    content->addWidget(makeForm(labels));
    content->addWidget(m_preview, 1);
    auto *pdf = m_buttons->addButton(tr("&Save as PDF…"), QDialogButtonBox::ActionRole);
    auto *paper = m_buttons->addButton(tr("&Print…"), QDialogButtonBox::ActionRole);
    connect(pdf, &QPushButton::clicked, this, &TargetDialog::askPdf);
    connect(paper, &QPushButton::clicked, this, &TargetDialog::print);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(content, 1);
    layout->addWidget(m_buttons);
    pdf->setDefault(true);
    resize(980, 640);
    m_kind->setCurrentIndex(m_kind->findData(int(kind)));
    connect(m_kind, &QComboBox::currentIndexChanged, this, &TargetDialog::refresh);
    connect(m_paper, &QComboBox::currentIndexChanged, this, &TargetDialog::suggestSizes);
    for (QSpinBox *box : {m_columns, m_rows, m_sheetColumns, m_sheetRows})
        connect(box, &QSpinBox::valueChanged, this, &TargetDialog::refresh);
    for (QDoubleSpinBox *box : {m_square, m_marker})
        connect(box, &QDoubleSpinBox::valueChanged, this, &TargetDialog::refresh);
    connect(m_labels, &QLineEdit::textChanged, this, &TargetDialog::refresh);
    refresh();
}

QWidget *TargetDialog::makeForm(const QStringList &labels)
{
    m_kind->addItem(tr("Floor mat"), int(TargetKind::Mat));
    m_kind->addItem(tr("Checkerboard"), int(TargetKind::Checkerboard));
    m_kind->addItem(tr("ChArUco board"), int(TargetKind::Charuco));
    m_kind->addItem(tr("Floor markers: tags"), int(TargetKind::Tags));
    m_kind->addItem(tr("Floor markers: rings"), int(TargetKind::Rings));
    m_paper->addItem(tr("A4"), QPageSize::A4);
    m_paper->addItem(tr("Letter"), QPageSize::Letter);
    m_paper->addItem(tr("A3"), QPageSize::A3);
    m_labels->setText((labels.isEmpty() ? TargetSpec().labels : labels).join(QStringLiteral(", ")));
    m_form->addRow(tr("&Target"), m_kind);
    m_form->addRow(tr("Pape&r"), m_paper);
    m_form->addRow(tr("S&heets"), m_sheets);
    m_form->addRow(tr("&Inner corners"), m_corners);
    m_form->addRow(tr("S&quare"), m_square);
    m_form->addRow(tr("Si&ze"), m_marker);
    m_form->addRow(tr("&Labels"), m_labels);
    m_message->setWordWrap(true);
    m_message->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_message->setAccessibleName(tr("What is printed"));
    auto *form = new QWidget;
    form->setFixedWidth(formWidth);
    auto *layout = new QVBoxLayout(form);
    layout->setContentsMargins(0, 0, 8, 0);
    layout->addLayout(m_form);
    layout->addSpacing(12);
    layout->addWidget(m_message);
    layout->addStretch(1);
    return form;
}

TargetSpec TargetDialog::spec() const
{
    TargetSpec spec;
    spec.kind = TargetKind(m_kind->currentData().toInt());
    spec.paper = QPageSize::PageSizeId(m_paper->currentData().toInt());
    const bool isMat = spec.kind == TargetKind::Mat;
    spec.columns = (isMat ? m_sheetColumns : m_columns)->value();
    spec.rows = (isMat ? m_sheetRows : m_rows)->value();
    spec.squareM = fromMillimetres(m_square->value());
    spec.markerM = fromMillimetres(m_marker->value());
    spec.labels.clear();
    for (const QString &label : m_labels->text().split(QLatin1Char(','), Qt::SkipEmptyParts))
        if (!label.trimmed().isEmpty())
            spec.labels << label.trimmed();
    return spec;
}

/// Larger squares need a larger sheet.
void TargetDialog::suggestSizes()
{
    const bool large = m_paper->currentData().toInt() == QPageSize::A3;
    m_square->setValue(large ? 36 : 25);
    m_marker->setValue(large ? 220 : 150);
    m_sheetColumns->setValue(large ? 3 : 4);
    m_sheetRows->setValue(large ? 2 : 3);
    refresh();
}

QString TargetDialog::whatIsPrinted(const TargetSpec &wanted)
{
    if (isBoard(wanted.kind))
        return tr("One sheet. Afterwards measure a square on the paper: printers often shrink by 2 to 4 %.");
    if (wanted.kind != TargetKind::Mat)
        return tr("One sheet for each marker. A tag's number is the position of its label in the layout.");
    const Eigen::Vector2d sheet = matSheetM(matOf(wanted).paper);
    return tr("A plan and %1 sheets, to be taped together to a mat of %2 × %3 m. Its markers are known: "
              "nothing on the floor needs to be measured. The larger the mat, the more exact the floor.")
        .arg(wanted.columns * wanted.rows)
        .arg(QLocale().toString(wanted.columns * sheet.x(), 'f', 2),
             QLocale().toString(wanted.rows * sheet.y(), 'f', 2));
}

void TargetDialog::refresh()
{
    const TargetSpec wanted = spec();
    const bool board = isBoard(wanted.kind), mat = wanted.kind == TargetKind::Mat;
    const bool singly = !board && !mat;
    const std::pair<QWidget *, bool> rows[] = {
        {m_sheets, mat}, {m_corners, board}, {m_square, board}, {m_marker, singly}, {m_labels, singly}};
    for (const auto &[field, shown] : rows) {
        field->setVisible(shown);
        m_form->labelForField(field)->setVisible(shown);
    }
    auto sheets = layOutTarget(wanted);
    for (QAbstractButton *button : m_buttons->buttons())
        if (m_buttons->buttonRole(button) == QDialogButtonBox::ActionRole)
            button->setEnabled(sheets.has_value());
    if (sheets)
        showOutcome({}, whatIsPrinted(wanted));
    else
        showOutcome(tl::unexpected(sheets.error()), {});
    m_preview->setSheets(wanted, sheets ? std::move(*sheets) : std::vector<TargetSheet>());
}

void TargetDialog::askPdf()
{
    if (const auto chosen = askOutput(this, tr("Save targets"), tr("targets.pdf"),
                                      {{tr("PDF (*.pdf)"), QStringLiteral("pdf"), FileKind::Pdf}}))
        savePdf(*chosen);
}

bool TargetDialog::savePdf(const ChosenOutput &output)
{
    const Result<void> written = writeTargetPdf(spec(), output.target);
    showOutcome(written, tr("Saved as %1.").arg(output.file));
    return written.has_value();
}

void TargetDialog::print()
{
    const auto sheets = layOutTarget(spec());
    QPrinter printer(QPrinter::HighResolution);
    QPrintDialog dialog(&printer, this);
    if (!sheets || dialog.exec() != QDialog::Accepted)
        return;
    // not by Qt, which would write over anything; it has asked
    if (const QString file = printer.outputFileName(); !file.isEmpty())
        savePdf({{pathOf(file), Existing::ReplaceAny}, file});
    else
        showOutcome(printTarget(printer, spec(), *sheets), tr("Sent to the printer."));
}

void TargetDialog::showOutcome(const Result<void> &outcome, const QString &success)
{
    const ThemeColours colours = ThemeColours::of(palette());
    QPalette words = palette();
    words.setColor(QPalette::WindowText, outcome ? colours.muted : colours.spike);
    m_message->setPalette(words);
    m_message->setText(
        outcome ? success
                : tr("%1: %2.").arg(shownWords(outcome.error().why), shownWords(outcome.error().advice)));
}

} // namespace odo

#include "target_dialog.moc"
