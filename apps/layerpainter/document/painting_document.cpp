#include "layerpainter/document/painting_document.h"

#include "document/project_picture.h"
#include "layerpainter/document/import_file.h"
#include "layerpainter/document/painting_project.h"

#include <QDateTime>
#include <QUndoCommand>
#include <algorithm>

namespace ductus {

namespace {

constexpr double historyBytes = 512e6; // of copies of lists; strokes are shared

int undoLimitFor(const Painting &painting)
{
    std::size_t elements = 0;
    for (const Layer *layer : painting.layers())
        elements += std::size_t(layer->elementCount());
    const double bytes = double(elements) * sizeof(Element) + 20'000;
    return int(std::clamp(historyBytes / bytes, 30.0, 1000.0));
}

std::string now()
{
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs).toStdString();
}

void add(PaintingChanged &to, const PaintingChanged &change)
{
    to.elements |= change.elements;
    to.layers |= change.layers;
    to.properties |= change.properties;
    to.looks |= change.looks;
    to.scene |= change.scene;
}

} // namespace

/// The one undo command of LayerPainter: this painting becomes that painting.
class EditPainting : public QUndoCommand
{
public:
    EditPainting(PaintingDocument &document, const PaintingAction &action,
                 std::shared_ptr<const Painting> before, std::shared_ptr<const Painting> after, quint64 drag)
        : QUndoCommand(ductus::actionText(action)), mDocument(document), mChange(changeOf(action)),
          mKind(action.index()), mBefore(std::move(before)), mAfter(std::move(after)), mDrag(drag)
    {
    }

    void redo() override
    {
        if (!mDocument.mIsPerforming)
            mDocument.log({now(), LogRedo()});
        mDocument.show(mAfter, mChange);
    }

    void undo() override
    {
        mDocument.log({now(), LogUndo()});
        mDocument.show(mBefore, mChange);
    }

    int id() const override { return mDrag > 0 ? 1 : -1; }

    bool mergeWith(const QUndoCommand *other) override
    {
        const auto *next = dynamic_cast<const EditPainting *>(other);
        if (!next || next->mDrag != mDrag || next->mKind != mKind)
            return false;
        mAfter = next->mAfter;
        add(mChange, next->mChange);
        return true;
    }

private:
    PaintingDocument &mDocument;
    PaintingChanged mChange;
    std::size_t mKind;
    std::shared_ptr<const Painting> mBefore, mAfter;
    quint64 mDrag;
};

PaintingDocument::PaintingDocument(QObject *parent)
    : Document(parent), mPainting(std::make_shared<const Painting>()), mDocumentId(Uuid::create())
{
    // Also after opening: there the path is known only now.
    connect(this, &Document::changed, this, [this](const ChangeEvent &event) {
        if (event.as<DocumentReset>())
            beginLog();
    });
    beginLog();
}

void PaintingDocument::start(Painting painting, const QString &name, const QString &source)
{
    reset();
    mPainting = std::make_shared<const Painting>(std::move(painting));
    undoStack()->setUndoLimit(undoLimitFor(*mPainting));
    emit changed(DocumentReset());
    mLogSource = source;
    setUntitledName(name);
}

Result<std::vector<std::int32_t>> PaintingDocument::perform(const PaintingAction &action, quint64 drag)
{
    // A save in the middle of a drag ends it: QUndoStack merges nothing into a saved step.
    const bool continues = drag > 0 && drag == mDrag && action.index() == mDragKind &&
                           !undoStack()->isClean() && undoStack()->index() == undoStack()->count();
    const std::shared_ptr<const Painting> base = continues ? mDragBase : mPainting;
    Result<PerformedAction> result = performed(*base, action);
    if (!result) {
        emit refused(result.error());
        return result.error();
    }
    LogEntry entry{now(), action, result->made};
    if (continues)
        mLog.back() = std::move(entry);
    else
        log(std::move(entry));
    mDrag = drag;
    mDragKind = action.index();
    mDragBase = drag > 0 ? base : nullptr;
    mIsPerforming = true;
    undoStack()->push(new EditPainting(*this, action, base,
                                       std::make_shared<const Painting>(std::move(result->painting)), drag));
    mIsPerforming = false;
    return std::move(result->made);
}

void PaintingDocument::show(std::shared_ptr<const Painting> painting, const PaintingChanged &change)
{
    mPainting = std::move(painting);
    emit changed(change);
}

void PaintingDocument::beginLog()
{
    mLog.clear();
    mLogStart = mPainting;
    mLogSource = filePath();
    mDrag = 0;
    mDragBase = nullptr;
}

void PaintingDocument::log(LogEntry entry)
{
    mDrag = 0; // undone steps are not dragged on
    mLog.push_back(std::move(entry));
}

std::string PaintingDocument::actionLog() const
{
    LogStart start;
    const bool isEmptyStart = mLogStart->nextId == 1 && mLogSource.isEmpty();
    if (!isEmptyStart)
        start = {mLogSource.isEmpty() ? displayName().toStdString() : mLogSource.toStdString(),
                 paintingFingerprint(*mLogStart)};
    std::string text = logLine({mLog.empty() ? now() : mLog.front().time, start}) + "\n";
    for (const LogEntry &entry : mLog)
        text += logLine(entry) + "\n";
    return text;
}

Result<void> PaintingDocument::readFrom(const Project &project)
{
    Result<StoredPainting> stored = paintingFromProject(project);
    const bool isMadeOfSurfaces = !stored;
    if (!stored && stored.error().code == ErrorCode::TooLittleData)
        // Sent here by SketchSurfacer: its surfaces are what is painted on, in the same project.
        if (const Result<ImportedFile> surfaces = importSurfaces(project, ""))
            stored = StoredPainting{Uuid::create(), surfaces->name,
                                    std::make_shared<const PaintingContent>(surfaces->painting,
                                                                            UnknownPaintingMembers())};
    if (!stored)
        return stored.error();
    mIsMadeOfSurfaces = isMadeOfSurfaces;
    mDocumentId = stored->documentId;
    mContent = stored->content;
    mPainting = std::shared_ptr<const Painting>(mContent, &mContent->painting());
    mPicture = {};
    undoStack()->clear();
    undoStack()->setUndoLimit(undoLimitFor(*mPainting));
    return {};
}

void PaintingDocument::writeTo(Project &project) const
{
    std::shared_ptr<const PaintingContent> content = mContent;
    if (!content || &content->painting() != mPainting.get())
        content = std::make_shared<const PaintingContent>(*mPainting, mContent ? mContent->unknown()
                                                                               : UnknownPaintingMembers());
    putPainting(std::move(content), mDocumentId, displayName().toStdString(), project);
    project.generator = "LayerPainter";
    if (!mPicture.isNull())
        setProjectThumbnail(project, mPicture);
}

void PaintingDocument::clear()
{
    mPainting = std::make_shared<const Painting>();
    mContent = nullptr;
    mIsMadeOfSurfaces = false;
    mDocumentId = Uuid::create();
    mPicture = {};
}

} // namespace ductus
