// A small document for tests: one text, kept as the name of the project's first document.
#pragma once

#include "document/commands/change_value.h"
#include "document/document.h"
#include "project/testing/sample_project.h"

namespace ductus {

struct NoteChanged : ChangeEvent
{
    QString text;
};

class NoteDocument : public Document
{
public:
    using Document::Document;

    const QString &text() const { return mText; }
    void applyText(const QString &text)
    {
        mText = text;
        NoteChanged event;
        event.text = text;
        emit changed(event);
    }
    /// As an undo step.
    void write(const QString &text, quint64 drag = 0);

protected:
    Result<void> readFrom(const Project &project) override
    {
        if (project.documents.empty())
            return Error{ErrorCode::TooLittleData, "Opening the note", "there is none", "", ""};
        mText = QString::fromStdString(project.documents.front().name);
        return {};
    }
    void writeTo(Project &project) const override
    {
        if (project.documents.empty())
            project.documents.push_back(newSketchSurface(Uuid::create(), "", sampleSketchSurface(1, 2, 3)));
        project.documents.front().name = mText.toStdString();
    }
    void clear() override { mText.clear(); }

private:
    QString mText;
};

struct WriteNote : ChangeValue<NoteDocument *, QString>
{
    using ChangeValue::ChangeValue;
    QString get(NoteDocument *const &note) const override { return note->text(); }
    void set(NoteDocument *const &note, const QString &text) override { note->applyText(text); }
};

inline void NoteDocument::write(const QString &text, quint64 drag)
{
    undoStack()->push(new WriteNote(QStringLiteral("Write"), 1, this, text, drag));
}

} // namespace ductus
