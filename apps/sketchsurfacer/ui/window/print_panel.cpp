#include "sketchsurfacer/ui/window/print_panel.h"

#include "widgets/theme/icons.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

namespace ductus {

namespace {

const QString jobKey = QStringLiteral("print check");
constexpr int afterResultMilliseconds = 500; // edits that follow each other are checked once
constexpr double largestBed = 0.35;          // metres; what is larger in truth is printed as a model
constexpr double modelSize = 0.2;

using CheckPointer = std::shared_ptr<const PrintCheck>;

QDoubleSpinBox *millimetreField(double least, double most, int decimals, double value, const QString &name)
{
    auto *field = new QDoubleSpinBox;
    field->setRange(least, most);
    field->setDecimals(decimals);
    field->setValue(value);
    field->setSuffix(QStringLiteral(" mm"));
    field->setAccessibleName(name);
    field->setKeyboardTracking(false);
    return field;
}

} // namespace

PrintPanel::PrintPanel(SketchDocument &document, JobRunner &runner, QWidget *parent)
    : QWidget(parent), mDocument(document), mRunner(runner)
{
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(6);
    auto *form = new QFormLayout;
    form->setVerticalSpacing(6);
    mLongest = millimetreField(1.0, 100'000.0, 0, 200.0, tr("Longest side of the print"));
    mLongest->setObjectName(QStringLiteral("printLongest"));
    mLongest->setToolTip(tr("How long the longest side is to be on the printer. Nothing is scaled; the check "
                            "asks what would be too thin at that size."));
    mNozzle = millimetreField(0.05, 5.0, 2, 0.4, tr("Width of a line of the nozzle"));
    mNozzle->setObjectName(QStringLiteral("printNozzle"));
    mNozzle->setSingleStep(0.1);
    mNozzle->setToolTip(tr("The width of the lines the printer lays; 0.4 mm is usual."));
    form->addRow(tr("Lon&gest side"), mLongest);
    form->addRow(tr("&Nozzle"), mNozzle);
    rows->addLayout(form);
    mState = new QLabel;
    mState->setWordWrap(true);
    mState->setProperty("dim", true);
    rows->addWidget(mState);
    mRows = new QVBoxLayout;
    mRows->setSpacing(6);
    rows->addLayout(mRows);
    mSoon.setSingleShot(true);
    mSoon.setInterval(afterResultMilliseconds);
    connect(&mSoon, &QTimer::timeout, this, &PrintPanel::startCheck);
    connect(mLongest, &QDoubleSpinBox::valueChanged, this, [this] {
        mSizeIsOwn = true;
        refresh();
    });
    connect(mNozzle, &QDoubleSpinBox::valueChanged, this, &PrintPanel::refresh);
    connect(&document, &Document::changed, this, [this](const ChangeEvent &event) {
        if (event.as<DocumentReset>())
            mSizeIsOwn = false;
        const auto *change = event.as<SketchChanged>();
        if (event.as<DocumentReset>() || (change && change->strokes)) {
            proposeSize();
            refresh();
        }
    });
    refresh();
}

void PrintPanel::setResult(const std::shared_ptr<const ResultView> &view)
{
    const auto surface = view && !view->isPreview ? view->state->surface : nullptr;
    if (surface == mSurface)
        return;
    mSurface = surface;
    mCheck = nullptr;
    mRunner.cancelKey(jobKey);
    emit outdated();
    proposeSize();
    refresh();
    checkSoon();
}

void PrintPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    checkSoon();
}

void PrintPanel::checkSoon()
{
    if (mSurface && !mCheck && isVisible())
        mSoon.start();
}

void PrintPanel::startCheck()
{
    if (!mSurface || mCheck || !isVisible())
        return;
    auto work = [surface = mSurface](const JobControl &control) -> Result<CheckPointer> {
        Result<PrintCheck> check = checkForPrint(surface->mesh, control);
        if (!check)
            return check.error();
        return CheckPointer(std::make_shared<const PrintCheck>(std::move(*check)));
    };
    mRunner.start<CheckPointer>({jobKey, tr("Checking the print"), true}, this, work,
                                [this, surface = mSurface](Result<CheckPointer> check) {
                                    if (!check || surface != mSurface)
                                        return; // cancelled: another result came
                                    mCheck = *check;
                                    refresh();
                                    emit checked();
                                });
}

// As large as it is, where it fits on a printer.
void PrintPanel::proposeSize()
{
    const StrokeSet &strokes = mDocument.strokes();
    const Box3 box = mSurface ? boundingBox(mSurface->mesh.vertices) : strokes.box();
    if (mSizeIsOwn || box.isEmpty())
        return;
    const double metres = (box.max - box.min).maxCoeff() * strokes.metresPerUnit;
    const QSignalBlocker blocker(mLongest);
    mLongest->setValue(1000.0 * (metres > 0.001 && metres <= largestBed ? metres : modelSize));
}

PrintSize PrintPanel::printSize() const
{
    const double longest = (mCheck->box.max - mCheck->box.min).maxCoeff();
    return {longest > 0.0 ? 0.001 * mLongest->value() / longest : 1.0, 0.001 * mNozzle->value()};
}

void PrintPanel::refresh()
{
    mFindings = mCheck ? printFindings(*mCheck, printSize(), locale()) : std::vector<PrintFinding>();
    while (QLayoutItem *item = mRows->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater(); // it may be its button that is pressed
        delete item;
    }
    mState->setVisible(!mCheck);
    mState->setText(mSurface ? tr("Looking at walls and gaps...")
                             : tr("Surface the sketch to see whether it can be printed."));
    mLongest->setEnabled(bool(mSurface));
    mNozzle->setEnabled(bool(mSurface));
    for (const PrintFinding &finding : mFindings)
        mRows->addWidget(newRow(finding));
}

QWidget *PrintPanel::newRow(const PrintFinding &finding)
{
    auto *row = new QWidget;
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    const auto [name, tint] =
        finding.kind == FindingKind::Good       ? std::pair("status-success", IconTint::Success)
        : finding.kind == FindingKind::Doubtful ? std::pair("status-warning", IconTint::Warning)
                                                : std::pair("status-error", IconTint::Error);
    auto *mark = new QLabel;
    mark->setPixmap(icon(QLatin1String(name), tint).pixmap(16, 16));
    auto *text = new QLabel(finding.text);
    text->setObjectName(finding.id);
    text->setWordWrap(true);
    layout->addWidget(mark, 0, Qt::AlignTop);
    layout->addWidget(text, 1);
    if (finding.place) {
        auto *button = new QPushButton(tr("Show"));
        button->setObjectName(QStringLiteral("show-") + finding.id);
        button->setAccessibleName(tr("Show: %1").arg(finding.text));
        button->setToolTip(tr("Turns the view to the place and marks it; Esc takes the mark away."));
        connect(button, &QPushButton::clicked, this,
                [this, place = *finding.place] { emit showRequested(place); });
        layout->addWidget(button, 0, Qt::AlignTop);
    }
    return row;
}

} // namespace ductus
