#include "doodlestudio/ui/film/export_dialog.h"

#include "document/document_files.h"
#include "document/words/engine_words.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QUrl>
#include <QVBoxLayout>

#include <memory>
#include <optional>

namespace ductus {

namespace {

constexpr int slideLines = 360; // small enough to be mailed, large enough to be seen

QString words(const Error &error)
{
    QString text = engineWords(error.problem);
    if (!error.remedy.empty())
        text += QStringLiteral(". ") + engineWords(error.remedy) + QLatin1Char('.');
    return text;
}

} // namespace

FilmExport exportOf(ExportPreset preset, bool withSound)
{
    FilmExport what;
    what.withSound = withSound;
    switch (preset) {
    case ExportPreset::Share:
        break;
    case ExportPreset::Slides:
        what.kind = FilmKind::Gif;
        what.mostLines = slideLines;
        what.everyNth = 2;
        break;
    case ExportPreset::Overlay:
        what.kind = FilmKind::WebM;
        what.content = ExportContent::Doodle;
        break;
    }
    return what;
}

QString suffixOf(ExportPreset preset)
{
    switch (preset) {
    case ExportPreset::Slides:
        return QStringLiteral("gif");
    case ExportPreset::Overlay:
        return QStringLiteral("webm");
    case ExportPreset::Share:
        break;
    }
    return QStringLiteral("mp4");
}

ExportDialog::ExportDialog(DoodleDocument &document, JobRunner &runner, QWidget *parent)
    : QDialog(parent), mDocument(document), mRunner(runner)
{
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export"));
    setMinimumWidth(480);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(10);
    buildPresets(layout);
    auto *row = new QHBoxLayout;
    mPath = new QLineEdit;
    mPath->setObjectName(QStringLiteral("exportPath"));
    mPath->setAccessibleName(tr("File"));
    auto *browse = new QPushButton(tr("Choose..."));
    row->addWidget(mPath, 1);
    row->addWidget(browse);
    layout->addLayout(row);
    connect(browse, &QPushButton::clicked, this, &ExportDialog::choosePath);
    mSound = new QCheckBox(tr("With the sound of the clip"));
    mSound->setObjectName(QStringLiteral("withSound"));
    mSound->setChecked(true);
    layout->addWidget(mSound);
    mProgress = new QProgressBar;
    mProgress->setRange(0, 1000);
    mProgress->hide();
    layout->addWidget(mProgress);
    mStatus = new QLabel;
    mStatus->setObjectName(QStringLiteral("exportStatus"));
    mStatus->setWordWrap(true);
    mStatus->hide();
    layout->addWidget(mStatus);
    auto *buttons = new QHBoxLayout;
    mFolder = new QPushButton(tr("Show in folder"));
    mFolder->setObjectName(QStringLiteral("showInFolder"));
    mFolder->hide();
    mClose = new QPushButton(tr("Close"));
    mStart = new QPushButton(tr("Export"));
    mStart->setObjectName(QStringLiteral("startExport"));
    mStart->setProperty("primary", true);
    mStart->setDefault(true);
    buttons->addWidget(mFolder);
    buttons->addStretch(1);
    buttons->addWidget(mClose);
    buttons->addWidget(mStart);
    layout->addLayout(buttons);
    connect(mStart, &QPushButton::clicked, this, &ExportDialog::start);
    // Closing is not cancelling: the film goes on, its job is shown in the window.
    connect(mClose, &QPushButton::clicked, this, &QDialog::reject);
    connect(mFolder, &QPushButton::clicked, this,
            [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path()).absolutePath())); });
    connect(&runner, &JobRunner::jobProgress, this, [this](const JobState &state) {
        if (state.id != mJob)
            return;
        mProgress->setValue(int(1000 * state.fraction));
        mStatus->setText(state.remainingSeconds
                             ? tr("%1, about %n s left", nullptr, *state.remainingSeconds).arg(state.text)
                             : state.text);
    });
    connect(mPath, &QLineEdit::textChanged, this, &ExportDialog::pathEdited);
    setPreset(ExportPreset::Share);
}

void ExportDialog::buildPresets(QVBoxLayout *layout)
{
    mPresets = new QButtonGroup(this);
    const std::pair<QString, QString> presets[] = {
        {tr("&Share"), tr("A film with your drawings (MP4). Plays everywhere: phone, web, projector.")},
        {tr("S&lides"), tr("A moving picture (GIF) for slides and worksheets. No sound.")},
        {tr("&Overlay"),
         tr("Your drawings alone, see-through (WebM), to lay over the clip in another program.")}};
    for (int i = 0; i < 3; ++i) {
        auto *button = new QRadioButton(presets[i].first);
        QFont font = button->font();
        font.setBold(true);
        button->setFont(font);
        button->setToolTip(presets[i].second);
        auto *lesson = new QLabel(presets[i].second);
        lesson->setProperty("dim", true);
        lesson->setWordWrap(true);
        lesson->setContentsMargins(24, 0, 0, 0);
        lesson->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);
        lesson->setAlignment(Qt::AlignTop);
        mPresets->addButton(button, i);
        auto *preset = new QVBoxLayout; // the words belong to the button above them
        preset->setSpacing(0);
        preset->addWidget(button);
        preset->addWidget(lesson);
        layout->addLayout(preset);
    }
    connect(mPresets, &QButtonGroup::idClicked, this, [this](int id) { setPreset(ExportPreset(id)); });
}

void ExportDialog::setPreset(ExportPreset preset)
{
    mPresets->button(int(preset))->setChecked(true);
    mSound->setEnabled(preset == ExportPreset::Share);
    const QFileInfo shown(path());
    const QFileInfo clip(mDocument.clipPath());
    const QString folder = path().isEmpty() ? clip.absolutePath() : shown.absolutePath();
    const QString name =
        path().isEmpty() ? tr("%1 with drawings").arg(mDocument.displayName()) : shown.completeBaseName();
    mPath->setText(QStringLiteral("%1/%2.%3").arg(folder, name, suffixOf(preset)));
    mFolder->hide();
    mStatus->hide();
}

void ExportDialog::setPath(const QString &path)
{
    mPath->setText(path);
}

QString ExportDialog::path() const
{
    return mPath->text().trimmed();
}

void ExportDialog::choosePath()
{
    const QString suffix = suffixOf(ExportPreset(mPresets->checkedId()));
    QString chosen =
        QFileDialog::getSaveFileName(this, tr("Export"), path(), QStringLiteral("*.%1").arg(suffix));
    if (chosen.isEmpty())
        return;
    if (QFileInfo(chosen).suffix().toLower() != suffix)
        chosen += QLatin1Char('.') + suffix;
    mMayReplace = chosen; // the file dialog has asked
    setPath(chosen);
}

bool ExportDialog::asksToReplace()
{
    const QString target = path();
    if (!QFileInfo::exists(target) || mMayReplace == target)
        return false;
    mMayReplace = target;
    mStart->setText(tr("Replace"));
    mFolder->hide();
    mStatus->setText(
        tr("%1 is there already. Replace it, or choose another name.").arg(QFileInfo(target).fileName()));
    mStatus->show();
    return true;
}

void ExportDialog::pathEdited()
{
    if (path() == mMayReplace)
        return;
    mMayReplace.clear();
    mStart->setText(tr("Export"));
    mStatus->hide();
    mFolder->hide();
}

void ExportDialog::start()
{
    if (isExporting()) {
        mRunner.cancel(mJob);
        return;
    }
    if (asksToReplace())
        return;
    const FilmExport what = exportOf(ExportPreset(mPresets->checkedId()), mSound->isChecked());
    const QString target = path();
    // A cancel that comes while the last bytes are written is too late: the film is there, and is told of.
    const auto written = std::make_shared<std::optional<ExportReport>>();
    mJob = mRunner.start<ExportReport>(
        {QStringLiteral("export"), tr("Exporting %1").arg(QFileInfo(target).fileName())}, this,
        [clipPath = enginePath(mDocument.clipPath()), shot = mDocument.sceneShot(),
         scene = mDocument.sharedScene(), what, written,
         to = enginePath(target)](const JobControl &control) -> Result<ExportReport> {
            // A clip of its own: the player's is in use.
            Result<std::unique_ptr<Clip>> clip = openClip(clipPath, control.part(0.0, 0.03));
            if (!clip)
                return clip.error();
            Result<ExportReport> report =
                exportFilm(**clip, clipPath, *shot, *scene, what, to, control.part(0.03, 1.0));
            if (report)
                *written = *report;
            return report;
        },
        [this, target, written](Result<ExportReport> report) {
            finish(target, *written ? Result<ExportReport>(**written) : std::move(report));
        });
    showRunning(true);
}

void ExportDialog::finish(const QString &path, Result<ExportReport> report)
{
    mJob = 0;
    showRunning(false);
    mStatus->show();
    if (report) {
        mStatus->setText(tr("Done: %1 (%2 x %3, %n frame(s))", nullptr, report->frames)
                             .arg(QFileInfo(path).fileName())
                             .arg(report->width)
                             .arg(report->height));
        mMayReplace = path; // made here
        mFolder->show();
        emit exported(path);
    } else if (report.error().isCancelled()) {
        mStatus->setText(tr("Cancelled; nothing was written."));
    } else {
        mStatus->setText(tr("It could not be exported: %1").arg(words(report.error())));
    }
}

void ExportDialog::showRunning(bool running)
{
    mProgress->setVisible(running);
    mProgress->setValue(0);
    mStatus->setVisible(running);
    mStatus->setText({});
    mStart->setText(running ? tr("Cancel") : tr("Export"));
    for (QAbstractButton *button : mPresets->buttons())
        button->setEnabled(!running);
    mPath->setEnabled(!running);
    mSound->setEnabled(!running && mPresets->checkedId() == int(ExportPreset::Share));
    mFolder->hide();
}

} // namespace ductus
