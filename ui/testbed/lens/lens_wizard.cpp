// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/lens_wizard.h"

#include "ui/testbed/lens/lens_pictures_page.h"
#include "ui/testbed/lens/lens_result_page.h"
#include "ui/testbed/lens/lens_source_page.h"

namespace odo {
namespace {

constexpr int fewestPictures = 3;

} // namespace

LensWizard::LensWizard(const QStringList &cameras, const QString &current, const LiveCameras &live, Callbacks callbacks,
                       QWidget *parent)
    : StepDialog(tr("Calibrate camera"), tr("&Save"), parent), m_callbacks(std::move(callbacks)), m_source(new LensSourcePage(cameras, current, live)),
      m_pictures(new LensPicturesPage(m_search)), m_result(new LensResultPage)
{
    addStep(tr("The camera and the board"), m_source);
    addStep(tr("Pictures of the board"), m_pictures);
    addStep(tr("The lens"), m_result);
    resize(1120, 760);
    connect(m_source, &LensSourcePage::completeChanged, this, &LensWizard::updateButtons);
    connect(m_result, &LensResultPage::completeChanged, this, &LensWizard::updateButtons);
    connect(&m_search, &BoardSearch::changed, this, &LensWizard::updateButtons);
    connect(m_pictures, &LensPicturesPage::filesDropped, &m_search, &BoardSearch::addFiles);
    turnTo(Source);
}

LensWizard::~LensWizard() = default;

bool LensWizard::isComplete(int step) const
{
    switch (step) {
    case Source:
        return m_source->isComplete();
    case Pictures:
        return int(m_search.state().kept.size()) >= fewestPictures && m_search.state().waiting == 0;
    default:
        return m_result->calibration().has_value() && !isSaving();
    }
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
    m_search.watch([open = m_callbacks.open, uri = m_source->liveUri()] { return open(uri); });
}

void LensWizard::next()
{
    switch (step()) {
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
        save();
    }
}

void LensWizard::save()
{
    m_result->showSaving();
    saveAndAccept([lens = result(), keep = m_callbacks.keepPictures](const JobControl &control) { return keep(lens, control); });
}

void LensWizard::back()
{
    if (step() == Result_) {
        m_result->cancel();
        turnTo(Pictures);
        return;
    }
    m_search.stop();
    turnTo(Source);
}

void LensWizard::showNotSaved(const Error &error) { m_result->showNotSaved(error); }

void LensWizard::done(int result)
{
    m_search.stop();
    m_result->cancel();
    StepDialog::done(result);
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
