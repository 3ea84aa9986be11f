#include "layerpainter/ui/window/film_dialog.h"

#include "document/settings/action_catalogue.h"
#include "widgets/controls/number_slider.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ductus {

namespace {

enum View { AroundOnce, AlongPath, PresentView };
enum Kind { Mp4, WebM, Gif, Pictures };
constexpr const char *extensions[] = {".mp4", ".webm", ".gif", ""};

struct Size
{
    const char *text;
    int width, height;
};
constexpr Size sizes[] = {{QT_TRANSLATE_NOOP("ductus::FilmDialog", "Full HD, 1920 × 1080"), 1920, 1080},
                          {QT_TRANSLATE_NOOP("ductus::FilmDialog", "HD, 1280 × 720"), 1280, 720},
                          {QT_TRANSLATE_NOOP("ductus::FilmDialog", "Small, 640 × 360"), 640, 360},
                          {QT_TRANSLATE_NOOP("ductus::FilmDialog", "Square, 1080 × 1080"), 1080, 1080},
                          {QT_TRANSLATE_NOOP("ductus::FilmDialog", "Upright, 1080 × 1920"), 1080, 1920},
                          {QT_TRANSLATE_NOOP("ductus::FilmDialog", "4K, 3840 × 2160"), 3840, 2160}};
constexpr int rates[] = {25, 30, 50, 60, 12};

constexpr int presentLook = -1, everyLook = -2;
constexpr double turnSeconds = 8;

} // namespace

FilmDialog::FilmDialog(std::shared_ptr<const Painting> painting, const CameraKey &present, QWidget *parent)
    : QDialog(parent), mPainting(std::move(painting)), mPresent(present),
      mMotionSeconds(motionSeconds(*mPainting))
{
    setWindowTitle(tr("Export film"));
    setMinimumWidth(440);
    auto *rows = new QVBoxLayout(this);
    auto *form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    rows->addLayout(form);
    const auto combo = [&](const QString &label, const QString &teaches) {
        auto *made = new QComboBox;
        made->setToolTip(teaches);
        form->addRow(label, made);
        made->setAccessibleName(plainText(label));
        connect(made, &QComboBox::currentIndexChanged, this, &FilmDialog::refresh);
        return made;
    };
    mView = combo(tr("&Seen"), tr("From where the film looks at the painting."));
    mView->addItem(tr("Once around, from the present view"), AroundOnce);
    if (!mPainting->camera.keys.empty())
        mView->insertItem(0, tr("Along the camera path"), AlongPath);
    mView->addItem(tr("From the present view"), PresentView);
    mView->setCurrentIndex(!mPainting->camera.keys.empty() ? 0 : mMotionSeconds > 0 ? 1 : 0);
    mLook = combo(tr("&Look"), tr("Which look the film shows."));
    mLook->addItem(tr("As shown now"), presentLook);
    for (const Look &look : mPainting->looks)
        mLook->addItem(QString::fromStdString(look.name), look.id.value);
    if (mPainting->looks.size() > 1)
        mLook->addItem(tr("All looks, a film each"), everyLook);
    mKind = combo(tr("&Kind"), tr("MP4 plays everywhere; WebM and pictures keep transparency."));
    mKind->addItem(tr("MP4 - plays everywhere"), Mp4);
    mKind->addItem(tr("WebM - for the web, can be transparent"), WebM);
    mKind->addItem(tr("GIF - a small loop"), Gif);
    mKind->addItem(tr("Folder of PNG pictures"), Pictures);
    mSize = combo(tr("S&ize"), tr("Pixels of a frame."));
    for (const Size &size : sizes)
        mSize->addItem(tr(size.text));
    mRate = combo(tr("&Frames a second"), tr("25 suits films, 12 a hand-drawn loop."));
    for (const int rate : rates)
        mRate->addItem(QString::number(rate), rate);
    const double seconds = mMotionSeconds > 0 ? mMotionSeconds : turnSeconds;
    mSeconds = new NumberSlider(tr("Length"), {0.1, std::max(60.0, seconds), 0.5, seconds, 1, tr("s")},
                                tr("How long the film is; double click: as long as the painting moves."));
    mSeconds->setValue(seconds);
    rows->addWidget(mSeconds);
    mTransparent = new QCheckBox(tr("&Without background"));
    rows->addWidget(mTransparent);
    mSummary = new QLabel;
    mSummary->setProperty("dim", true);
    mSummary->setWordWrap(true);
    rows->addWidget(mSummary);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    auto *go = buttons->addButton(tr("&Export..."), QDialogButtonBox::AcceptRole);
    go->setProperty("primary", true);
    go->setDefault(true);
    rows->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(mSeconds, &NumberSlider::valueChanged, this, &FilmDialog::refresh);
    refresh();
}

FilmChoice FilmDialog::choice() const
{
    FilmChoice choice;
    const Size &size = sizes[mSize->currentIndex()];
    choice.film.frames.width = size.width;
    choice.film.frames.height = size.height;
    choice.film.frames.transparentBackground = mTransparent->isEnabled() && mTransparent->isChecked();
    FilmPlan &plan = choice.film.plan;
    plan.rate = {mRate->currentData().toInt(), 1};
    plan.frames = framesOf(mSeconds->value(), plan.rate);
    switch (mView->currentData().toInt()) {
    case AroundOnce:
        plan.view = FilmPlan::View::Turntable;
        plan.from = mPresent;
        break;
    case PresentView:
        plan.view = FilmPlan::View::Still;
        plan.from = mPresent;
        break;
    default:
        plan.view = FilmPlan::View::Path;
    }
    const int look = mLook->currentData().toInt();
    choice.everyLook = look == everyLook;
    if (look >= 0)
        choice.film.look = LookId{look};
    choice.extension = QLatin1String(extensions[mKind->currentData().toInt()]);
    return choice;
}

void FilmDialog::refresh()
{
    if (!mSummary)
        return; // while it is being built
    const bool canBeClear = mKind->currentData().toInt() != Mp4;
    mTransparent->setEnabled(canBeClear);
    mTransparent->setToolTip(canBeClear ? QString()
                                        : tr("MP4 has no transparency; choose WebM, GIF or PNG."));
    const FilmChoice now = choice();
    const int films = now.everyLook ? int(mPainting->looks.size()) : 1;
    mSummary->setText(tr("%n frames", nullptr, now.film.plan.frames * films) +
                      (films > 1 ? tr(" in %n films", nullptr, films) : QString()) +
                      tr(", drawn in the background; you can go on painting."));
}

} // namespace ductus
