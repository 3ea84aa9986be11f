// The document of an app with edits that can be counted: edit n adds one line whose points say n, so what a
// file holds tells how far the work in it had come.
#pragma once

#include "base/result.h"
#include "document/document.h"

#include <Eigen/Core>
#include <QStringList>
#include <memory>
#include <vector>

namespace ductus {

class EditedDocument
{
public:
    virtual ~EditedDocument() = default;

    virtual Document &document() = 0;
    /// Content to begin with, as unsaved work; no edits yet.
    virtual void start() = 0;
    /// Edit number editCount() + 1 as the app does it, now and then undone and done again. False if it was
    /// refused.
    bool edit();
    /// How many edits are in the document; -1 if it is not exactly the first so many.
    virtual int editCount() const = 0;

protected:
    virtual bool addLine(int number) = 0;
};

/// The kinds: the names of the apps' programs.
QStringList editedKinds();
/// Null for other kinds.
std::unique_ptr<EditedDocument> editedDocument(const QString &kind);

std::unique_ptr<EditedDocument> editedPainting();
std::unique_ptr<EditedDocument> editedSketch();
std::unique_ptr<EditedDocument> editedDoodle();

/// How many edits the project at \a path holds; -1 if something in it is not as it was drawn. Errors: those
/// of opening it.
Result<int> editsIn(const QString &kind, const QString &path);

/// The points of line \a number: x and y in 0..1, exact in single precision.
std::vector<Eigen::Vector3d> lineOf(int number);
/// Whether \a points are those of line \a number, to the last bit.
bool isLine(const std::vector<Eigen::Vector3d> &points, int number);

} // namespace ductus
