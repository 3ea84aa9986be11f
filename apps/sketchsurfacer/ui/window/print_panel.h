// PrintPanel: whether the surface can be printed, in sentences; what is wrong can be shown. The check runs in
// the background while the panel is seen.
#pragma once

#include "document/jobs/job_runner.h"
#include "sketchsurfacer/document/sketch_document.h"
#include "sketchsurfacer/ui/presentation/print_findings.h"
#include "sketchsurfacer/ui/presentation/result_view.h"

#include <QTimer>
#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QVBoxLayout;

namespace ductus {

class PrintPanel : public QWidget
{
    Q_OBJECT
public:
    /// Both must outlive this.
    PrintPanel(SketchDocument &document, JobRunner &runner, QWidget *parent = nullptr);

    /// What is shown of the result, or null.
    void setResult(const std::shared_ptr<const ResultView> &view);
    /// Of the result, once it is known.
    std::shared_ptr<const PrintCheck> check() const { return mCheck; }
    const std::vector<PrintFinding> &findings() const { return mFindings; }

signals:
    void checked();
    /// "Show" was pressed.
    void showRequested(const ductus::FoundPlace &place);
    /// What was shown is no longer so.
    void outdated();

protected:
    void showEvent(QShowEvent *event) override;

private:
    void checkSoon();
    void startCheck();
    void proposeSize();
    void refresh();
    QWidget *newRow(const PrintFinding &finding);
    PrintSize printSize() const;

    SketchDocument &mDocument;
    JobRunner &mRunner;
    std::shared_ptr<const SurfaceResult> mSurface; // to be checked
    std::shared_ptr<const PrintCheck> mCheck;
    std::vector<PrintFinding> mFindings;
    QTimer mSoon;
    bool mSizeIsOwn = false; // the user chose it
    QDoubleSpinBox *mLongest, *mNozzle;
    QLabel *mState;
    QVBoxLayout *mRows;
};

} // namespace ductus
