// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/lens_wizard.h"

#include "ui/testbed/lens/lens_pictures_page.h"
#include "ui/testbed/lens/lens_result_page.h"
#include "ui/testbed/lens/lens_source_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace odo {
namespace {

constexpr int fewestPictures = 3;

} // namespace

LensWizard::LensWizard(const QStringList &cameras, const QString &current, const std::vector<CameraDescription> &live,
                       OpenCamera open, QWidget *parent)
    : QDialog(parent), m_open(std::move(open)), m_source(new LensSourcePage(cameras, current, live)),
      m_pictures(new LensPicturesPage(m_search)), m_result(new LensResultPage), m_pages(new QStackedWidget), m_title(new QLabel),
      m_steps(new QLabel), m_back(new QPushButton(tr("< &Back"))), m_next(new QPushButton), m_cancel(new QPushButton(tr("Cancel")))
{
    setWindowTitle(tr("Calibrate camera"));
    m_title->setStyleSheet(QStringLiteral("font-size: 16pt; font-weight: 600"));
    m_steps->setObjectName(QStringLiteral("quiet"));
    m_pages->addWidget(m_source);
    m_pages->addWidget(m_pictures);
    m_pages->addWidget(m_result);
    auto *head = new QHBoxLayout;
    head->addWidget(m_title);
    head->addStretch(1);
    head->addWidget(m_steps);
    auto *buttons = new QHBoxLayout;
    buttons->addStretch(1);
    for (QPushButton *button : {m_back, m_next, m_cancel}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    m_next->setProperty("primary", true);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addLayout(head);
    layout->addSpacing(6);
    layout->addWidget(m_pages, 1);
    layout->addLayout(buttons);
    m_next->setDefault(true);
    resize(1120, 760);
    connect(m_next, &QPushButton::clicked, this, &LensWizard::next);
    connect(m_back, &QPushButton::clicked, this, &LensWizard::back);
    connect(m_cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_source, &LensSourcePage::completeChanged, this, &LensWizard::updateButtons);
    connect(m_result, &LensResultPage::completeChanged, this, &LensWizard::updateButtons);
    connect(&m_search, &BoardSearch::changed, this, &LensWizard::updateButtons);
    connect(m_pictures, &LensPicturesPage::filesDropped, &m_search, &BoardSearch::addFiles);
    turnTo(Source);
}

LensWizard::~LensWizard() = default;

void LensWizard::turnTo(Page page)
{
    const QString titles[] = {tr("The camera and the board"), tr("Pictures of the board"), tr("The lens")};
    m_title->setText(titles[page]);
    m_steps->setText(tr("step %1 of 3").arg(int(page) + 1));
    m_pages->setCurrentIndex(page);
    m_next->setText(page == Result_ ? tr("&Save") : tr("&Next >"));
    updateButtons();
    m_pages->currentWidget()->setFocus();
}

void LensWizard::updateButtons()
{
    const bool complete[] = {m_source->isComplete(), int(m_search.state().kept.size()) >= fewestPictures && m_search.state().waiting == 0,
                             m_result->calibration().has_value()};
    m_back->setEnabled(m_pages->currentIndex() > Source);
    m_next->setEnabled(complete[m_pages->currentIndex()]);
}

void LensWizard::beginPictures()
{
    BoardSpec board;
    board.squareM = m_source->squareM();
    m_search.begin(board);
    m_pictures->begin(m_source->isLive());
    if (!m_source->isLive()) {
        m_search.addFiles(m_source->files());
        return;
    }
    auto camera = m_open(m_source->liveUri());
    if (camera)
        m_search.watch(std::move(*camera));
    else
        Q_EMIT m_search.failed(QString::fromStdString(camera.error().message()));
}

void LensWizard::next()
{
    switch (m_pages->currentIndex()) {
    case Source:
        turnTo(Pictures);
        beginPictures();
        break;
    case Pictures:
        m_search.stop();
        m_result->begin(m_search.state());
        turnTo(Result_);
        break;
    default:
        accept();
    }
}

void LensWizard::back()
{
    if (m_pages->currentIndex() == Result_) {
        m_result->cancel();
        turnTo(Pictures);
        return;
    }
    m_search.stop();
    turnTo(Source);
}

void LensWizard::done(int result)
{
    m_search.stop();
    m_result->cancel();
    QDialog::done(result);
}

MeasuredLens LensWizard::result() const
{
    MeasuredLens lens{m_source->camera(), {}, m_result->calibration().value_or(IntrinsicCalibration()), {}};
    lens.board.squareM = m_source->squareM();
    for (const KeptPicture &picture : m_result->pictures()) {
        const BoardView &view = picture.board.view;
        lens.board.pattern = view.pattern;
        lens.board.columns = view.columns;
        lens.board.rows = view.rows;
        lens.pictures.push_back({view.source, picture.png});
    }
    return lens;
}

} // namespace odo
