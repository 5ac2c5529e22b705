// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/internal/board_images_page.h"

#include "core/calibration/board_placement.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/lens/internal/lens_drawings.h"
#include "ui/testbed/lens/internal/rms_so_far.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"

#include <QAction>
#include <QDragEnterEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMimeData>
#include <QPixmap>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>
#include <QUrl>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <array>

class QLabel;
class QProgressBar;

namespace odo {

/// The four coverage bars and the number of images.
class CoveragePanel : public QWidget
{
    Q_OBJECT
public:
    explicit CoveragePanel(QWidget *parent = nullptr);
    void setCoverage(const BoardCoverage &coverage);

private:
    std::array<QProgressBar *, 5> m_bars{};
    std::array<QLabel *, 5> m_marks{};
    QLabel *m_count;
};

namespace {

constexpr int whole = 100;
constexpr double wantedPart = 0.5; // of the fields, as BoardCoverage::isEnough asks

} // namespace

CoveragePanel::CoveragePanel(QWidget *parent) : QWidget(parent), m_count(new QLabel)
{
    const QString names[] = {tr("Across"), tr("Up and down"), tr("Near"), tr("Tilted"), tr("Covered")};
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(12, 10, 12, 10);
    grid->setVerticalSpacing(8);
    grid->setColumnStretch(1, 1);
    for (std::size_t i = 0; i < m_bars.size(); ++i) {
        auto *name = new QLabel(names[i]);
        m_bars[i] = new QProgressBar;
        m_bars[i]->setRange(0, whole);
        m_bars[i]->setTextVisible(false);
        m_bars[i]->setFixedHeight(10);
        m_bars[i]->setAccessibleName(names[i]);
        m_marks[i] = new QLabel;
        m_marks[i]->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("✓")) + 2);
        grid->addWidget(name, int(i), 0);
        grid->addWidget(m_bars[i], int(i), 1);
        grid->addWidget(m_marks[i], int(i), 2);
    }
    grid->addWidget(m_count, int(m_bars.size()), 0, 1, 3);
    setCoverage({});
}

void CoveragePanel::setCoverage(const BoardCoverage &coverage)
{
    const double parts[] = {coverage.x, coverage.y, coverage.size, coverage.skew,
                            std::min(1.0, coverage.coveredPart() / wantedPart)};
    for (std::size_t i = 0; i < m_bars.size(); ++i) {
        m_bars[i]->setValue(int(parts[i] * whole));
        m_marks[i]->setText(parts[i] >= 1 ? QStringLiteral("✓") : QString());
    }
    m_count->setText(coverage.isEnough()    ? tr("%1 images: enough. More do no harm.").arg(coverage.images)
                     : coverage.images == 1 ? tr("1 image; take ten or more.")
                                            : tr("%1 images; take ten or more.").arg(coverage.images));
}

namespace {

constexpr int sideWidth = 300;

} // namespace

QString wordsOf(BoardHint hint)
{
    switch (hint) {
    case BoardHint::Left:
        return BoardImagesPage::tr("Move it to the left of the image");
    case BoardHint::Right:
        return BoardImagesPage::tr("Move it to the right of the image");
    case BoardHint::Up:
        return BoardImagesPage::tr("Move it up");
    case BoardHint::Down:
        return BoardImagesPage::tr("Move it down");
    case BoardHint::Closer:
        return BoardImagesPage::tr("Closer to the camera");
    case BoardHint::Farther:
        return BoardImagesPage::tr("Farther from the camera");
    case BoardHint::TiltLeft:
        return BoardImagesPage::tr("Tilt it: the left side away from the camera");
    case BoardHint::TiltRight:
        return BoardImagesPage::tr("Tilt it: the right side away from the camera");
    case BoardHint::TiltUp:
        return BoardImagesPage::tr("Tilt it: the upper side away from the camera");
    case BoardHint::TiltDown:
        return BoardImagesPage::tr("Tilt it: the lower side away from the camera");
    case BoardHint::HoldStill:
        return BoardImagesPage::tr("Hold it still");
    }
    return {};
}

BoardImagesPage::BoardImagesPage(BoardSearch &search, QWidget *parent)
    : QWidget(parent), m_search(search), m_canvas(new BoardCanvas), m_coverage(new CoveragePanel),
      m_rms(new RmsSoFar), m_refused(new QListWidget), m_strip(new FilmStrip), m_headline(new QLabel),
      m_detail(new QLabel), m_take(plainButton(tr("&Take an image now")))
{
    setAcceptDrops(true);
    m_headline->setStyleSheet(QStringLiteral("font-size: 14pt; font-weight: 600"));
    m_headline->setAccessibleName(tr("What to do"));
    m_detail->setObjectName(QStringLiteral("quiet"));
    for (QLabel *label : {m_headline, m_detail}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    connect(m_take, &QPushButton::clicked, &m_search, &BoardSearch::takeNow);
    auto *words = new QVBoxLayout;
    words->setSpacing(2);
    words->addWidget(m_headline);
    words->addWidget(m_detail);
    auto *row = new QHBoxLayout;
    row->addLayout(words, 1);
    row->addWidget(m_take);
    auto *left = new QVBoxLayout;
    left->addWidget(m_canvas, 1);
    left->addLayout(row);
    auto *top = new QHBoxLayout;
    top->addLayout(left, 1);
    top->addWidget(makeSide());
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(top, 1);
    layout->addWidget(makeStrip());
    connect(&m_search, &BoardSearch::searched, this, &BoardImagesPage::showSearched);
    connect(&m_search, &BoardSearch::changed, this, &BoardImagesPage::showState);
    connect(&m_search, &BoardSearch::troubled, this,
            [this](const QString &message) { showStatus(tr("No image from the camera"), message); });
    connect(m_strip, &FilmStrip::removeRequested, &m_search, &BoardSearch::remove);
    connect(m_strip, &FilmStrip::undoRequested, &m_search, &BoardSearch::undoRemove);
    connect(m_strip, &QListWidget::currentRowChanged, this, &BoardImagesPage::showKept);
}

QWidget *BoardImagesPage::makeSide()
{
    m_refused->setAccessibleName(tr("Rejected images"));
    m_refused->setWordWrap(true);
    m_refused->setTextElideMode(Qt::ElideNone);
    m_refused->setResizeMode(QListView::Adjust);
    m_refused->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_refused->setSelectionMode(QAbstractItemView::NoSelection);
    auto *needed = new Card(tr("Coverage of the images"));
    auto *ofImages = new QWidget;
    auto *ofImagesLayout = new QVBoxLayout(ofImages);
    ofImagesLayout->setContentsMargins(0, 0, 0, 10);
    ofImagesLayout->addWidget(m_coverage);
    m_rms->setContentsMargins(12, 0, 12, 0);
    ofImagesLayout->addWidget(m_rms);
    needed->setContent(ofImages);
    auto *content = new QWidget;
    auto *contentLayout = new QVBoxLayout(content);
    contentLayout->setContentsMargins(0, 0, 0, 0);
    contentLayout->addWidget(m_refused);
    auto *refused = new Card(tr("Rejected"));
    refused->setContent(content);
    auto *side = new QWidget;
    side->setFixedWidth(sideWidth);
    auto *layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(needed);
    layout->addWidget(refused, 1);
    return side;
}

QWidget *BoardImagesPage::makeStrip()
{
    auto *buttons = new QVBoxLayout;
    buttons->addWidget(actionButton(m_strip->removeAction(), m_strip->removeAction()->text()));
    buttons->addWidget(actionButton(m_strip->undoAction(), m_strip->undoAction()->text()));
    buttons->addStretch(1);
    auto *strip = new QWidget;
    auto *layout = new QHBoxLayout(strip);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_strip, 1);
    layout->addLayout(buttons);
    return strip;
}

void BoardImagesPage::begin(bool live)
{
    m_live = live;
    m_take->setVisible(live);
    m_canvas->setContent({});
    m_canvas->setEmptyText(live ? tr("Waiting for the camera…") : tr("Detecting the board…"));
    showStatus(live ? tr("Hold the board before the camera") : tr("Detecting the board"),
               live ? tr("Odograph takes an image whenever the board is still, sharp and in a new position.")
                    : QString());
}

namespace {

QString shownRefusal(const Error &refusal)
{
    return shownWords(joined({refusal.why, refusal.advice}, Join::Semicolon));
}

} // namespace

void BoardImagesPage::showSearched(const SearchedImage &image)
{
    const ImageVerdict &answer = image.answer;
    BoardCanvas::Content content{image.image, image.size, {}, answer.kept, m_search.state().coverage,
                                 {},          {},         {}};
    if (answer.image)
        content.corners = answer.image->view.pixels;
    if (m_live && image.wanted)
        content.wanted = image.wanted->placement;
    if (!m_live)
        content.label = image.name;
    m_canvas->setContent(std::move(content));
    if (!m_live)
        return;
    if (answer.kept)
        showStatus(tr("Taken"), tr("Now the dashed outline shows where the board would help most."));
    else if (answer.image && image.wanted)
        showStatus(wordsOf(hintTowards(*image.wanted, answer.image->placement)),
                   answer.refusal ? shownRefusal(*answer.refusal) : QString());
    else if (answer.refusal)
        showStatus(tr("Hold the board before the camera"), shownRefusal(*answer.refusal));
}

void BoardImagesPage::showState()
{
    const SearchState &state = m_search.state();
    m_coverage->setCoverage(state.coverage);
    m_rms->setState(state);
    m_strip->setState(state);
    QStringList shown, refused;
    for (int row = 0; row < m_refused->count(); ++row)
        shown << m_refused->item(row)->text();
    for (const auto &[name, reason] : state.refused)
        refused << breakable(QStringLiteral("%1: %2").arg(name, reason));
    if (refused != shown) {
        m_refused->clear();
        m_refused->addItems(refused);
        m_refused->scrollToBottom();
    }
    if (m_live)
        return;
    if (state.waiting > 0)
        showStatus(tr("Detecting the board"), tr("%1 to go").arg(state.waiting));
    else if (state.kept.empty())
        showStatus(tr("No image accepted"),
                   tr("See the reasons on the right. Drop other images here to add them."));
    else
        showStatus(tr("All images checked"),
                   state.coverage.isEnough() ? tr("They are enough.")
                                             : tr("Drop more images here; the bars show what is missing."));
}

void BoardImagesPage::showKept(int row)
{
    const auto &kept = m_search.state().kept;
    if (row < 0 || row >= int(kept.size()) || m_live)
        return;
    const KeptImage &image = kept[std::size_t(row)];
    m_canvas->setContent({image.image,
                          m_search.state().size,
                          image.board.view.pixels,
                          true,
                          m_search.state().coverage,
                          {},
                          {},
                          image.name});
}

void BoardImagesPage::showStatus(const QString &headline, const QString &detail)
{
    m_headline->setText(headline);
    m_detail->setText(detail);
}

void BoardImagesPage::dragEnterEvent(QDragEnterEvent *event)
{
    if (!localFiles(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void BoardImagesPage::dropEvent(QDropEvent *event)
{
    Q_EMIT filesDropped(localFiles(*event->mimeData()));
}

namespace {

constexpr QSize thumbnail(112, 63);

} // namespace

FilmStrip::FilmStrip(QWidget *parent)
    : QListWidget(parent), m_remove(new QAction(tr("&Remove"), this)), m_undo(new QAction(tr("&Undo"), this))
{
    setViewMode(QListView::IconMode);
    setFlow(QListView::LeftToRight);
    setWrapping(false);
    setMovement(QListView::Static);
    setIconSize(thumbnail);
    setSpacing(4);
    setUniformItemSizes(true);
    setTextElideMode(Qt::ElideMiddle);
    setAccessibleName(tr("Accepted images"));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFixedHeight(thumbnail.height() + fontMetrics().height() + horizontalScrollBar()->sizeHint().height() +
                   34);
    m_remove->setShortcut(QKeySequence::Delete);
    m_undo->setShortcut(QKeySequence::Undo);
    for (QAction *action : {m_remove, m_undo}) {
        action->setShortcutContext(Qt::WindowShortcut);
        addAction(action);
    }
    setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(m_remove, &QAction::triggered, this, [this] {
        if (currentRow() >= 0)
            Q_EMIT removeRequested(currentRow());
    });
    connect(m_undo, &QAction::triggered, this, &FilmStrip::undoRequested);
    connect(this, &QListWidget::currentRowChanged, this, [this](int row) { m_remove->setEnabled(row >= 0); });
    setState({});
}

void FilmStrip::setState(const SearchState &state)
{
    const int row = currentRow();
    QStringList there, wanted;
    for (int i = 0; i < count(); ++i)
        there << item(i)->text();
    for (const KeptImage &image : state.kept)
        wanted << image.name;
    m_undo->setEnabled(state.canUndo);
    if (there == wanted) {
        m_remove->setEnabled(row >= 0);
        return;
    }
    // While a camera runs, images are only added at the end.
    const auto common =
        std::mismatch(there.begin(), there.end(), wanted.begin(), wanted.end()).first - there.begin();
    while (count() > common)
        delete takeItem(count() - 1);
    for (int i = int(common); i < wanted.size(); ++i) {
        const QImage &image = state.kept[std::size_t(i)].image;
        const QPixmap icon = QPixmap::fromImage(
            image.scaled(thumbnail * devicePixelRatioF(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
        auto *item = new QListWidgetItem(QIcon(icon), wanted.at(i), this);
        item->setToolTip(wanted.at(i));
        item->setSizeHint({thumbnail.width() + 14, thumbnail.height() + fontMetrics().height() + 12});
    }
    const bool added = wanted.size() > there.size();
    setCurrentRow(row < 0 ? -1 : std::min(row, count() - 1));
    if (added)
        scrollToItem(item(count() - 1)); // the newest
    m_remove->setEnabled(currentRow() >= 0);
}

} // namespace odo

#include "board_images_page.moc"
