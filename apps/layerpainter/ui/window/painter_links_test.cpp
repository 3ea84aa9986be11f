// "The surface changed - update?" in the real window: the sketch is saved by another program, the line above
// the canvas says so, and an update keeps what was painted; strokes go over the clipboard.
#include "layerpainter/document/stroke_exchange.h"
#include "layerpainter/ui/testing/painter_under_test.h"
#include "project/links/surface_digest.h"
#include "project/project_reader.h"
#include "project/saving/project_lock.h"
#include "project/saving/project_save.h"
#include "widgets/shell/message_bar.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QPushButton>

using namespace ductus;

namespace {

const Uuid sketchId = *Uuid::parse("12121212-3434-4565-8787-909090909090");

// A tent over a square.
Project tent(double high)
{
    SketchSurfaceDocument document;
    Stroke stroke;
    stroke.id = StrokeId{0};
    stroke.points = {{-1, 0, 0}, {1, 0, 0}};
    document.strokes.strokes = {stroke};
    StoredSurface surface;
    surface.mesh.vertices = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, high, 0}};
    surface.mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    document.surface = std::move(surface);
    Project project;
    project.id = *Uuid::parse("01234567-89ab-4cde-8f01-23456789abcd");
    project.documents.push_back(newSketchSurface(sketchId, "Tent", std::move(document)));
    return project;
}

} // namespace

class PainterLinksTest : public QObject
{
    Q_OBJECT
private slots:
    void aSavedSketchIsOfferedAndUpdated();
    void notNowIsTakenForAnAnswer();
    void aProjectThatIsOpenElsewhereIsPaintedOnBeside();
    void strokesAreCopiedAndPasted();

private:
    static void save(const QString &path, double high)
    {
        const Result<SaveReport> saved = saveProject(tent(high), enginePath(path));
        QVERIFY2(saved.ok(), saved ? "" : saved.error().message().c_str());
    }
    static double height(const Painting &painting)
    {
        double high = 0;
        for (const Element &element : painting.stacks[0].substrate->drawings[0].elements)
            if (const auto *mesh = std::get_if<MeshShape>(element.shape.get()))
                for (const Vec3 &vertex : mesh->mesh.vertices)
                    high = std::max(high, vertex.y());
        return high;
    }
    static bool isOffered(PainterUnderTest &app)
    {
        const auto &all = app.window->messages()->messages();
        return std::any_of(all.begin(), all.end(), [](const Message &m) { return m.key == "links"; });
    }
    static void click(PainterUnderTest &app, const QString &text)
    {
        for (auto *button : app.window->messages()->findChildren<QPushButton *>())
            if (button->isVisible() && button->text() == text) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        QFAIL(qPrintable("no button " + text));
    }
};

void PainterLinksTest::aSavedSketchIsOfferedAndUpdated()
{
    PainterUnderTest app;
    const QString path = app.folder.filePath("tent.ductus");
    save(path, 1.0);
    app.window->newPainting();
    app.window->importPath(path);
    QTRY_COMPARE_WITH_TIMEOUT(app.painting().stacks.size(), std::size_t(2), 30'000);
    (void)app.window->painting().perform(act::RemoveStack{app.painting().stacks[0].id});
    const LayerId shade{
        app.window->painting().perform(act::AddLayer{app.painting().stacks[0].id, "shade", -1})->front()};
    const std::string before = app.print();
    save(path, 2.0);
    QTRY_VERIFY_WITH_TIMEOUT(isOffered(app), 30'000);
    app.shot("update-offered");
    click(app, "Update");
    QCOMPARE(height(app.painting()), 2.0);
    QVERIFY(app.painting().findLayer(shade));
    QVERIFY(!isOffered(app));
    app.shot("updated");
    app.window->painting().undoStack()->undo();
    QCOMPARE(app.print(), before);
    QCOMPARE(app.window->painting().undoStack()->redoText(), QString("Update surface"));
}

void PainterLinksTest::notNowIsTakenForAnAnswer()
{
    PainterUnderTest app;
    const QString path = app.folder.filePath("tent.ductus");
    save(path, 1.0);
    app.window->newPainting();
    app.window->importPath(path);
    QTRY_COMPARE_WITH_TIMEOUT(app.painting().stacks.size(), std::size_t(2), 30'000);
    save(path, 2.0);
    QTRY_VERIFY_WITH_TIMEOUT(isOffered(app), 30'000);
    const std::string before = app.print();
    click(app, "Not now");
    QVERIFY(!isOffered(app));
    QCOMPARE(app.print(), before);
    // Asked for, it is offered again.
    app.window->lookForNewerSurfaces(true);
    QTRY_VERIFY_WITH_TIMEOUT(isOffered(app), 30'000);
}

void PainterLinksTest::aProjectThatIsOpenElsewhereIsPaintedOnBeside()
{
    PainterUnderTest app;
    const QString path = app.folder.filePath("tent.ductus");
    save(path, 1.0);
    const Result<ProjectLock> lock = ProjectLock::acquire(enginePath(path), "SketchSurfacer");
    QVERIFY(lock.ok());
    app.window->openPath(path);
    QTRY_COMPARE_WITH_TIMEOUT(app.painting().stacks.size(), std::size_t(1), 30'000);
    QTRY_VERIFY_WITH_TIMEOUT(app.window->painting().filePath().isEmpty(), 30'000);
    QVERIFY(!app.window->painting().isReadOnly());
    save(path, 3.0);
    QTRY_VERIFY_WITH_TIMEOUT(isOffered(app), 30'000);
    click(app, "Update");
    QCOMPARE(height(app.painting()), 3.0);
}

void PainterLinksTest::strokesAreCopiedAndPasted()
{
    PainterUnderTest app;
    app.window->newPainting();
    const LayerId layer = app.painting().stacks[0].substrate->id;
    CopiedStrokes foreign; // a line of SketchSurfacer
    foreign.strokes.resize(1);
    foreign.strokes[0].line.points = {{-1, 0, 0}, {1, 0.5, 0}};
    QGuiApplication::clipboard()->setMimeData(mimeDataOf(foreign).release());
    app.window->view().setFocus();
    app.window->pasteStrokes();
    QCOMPARE(app.strokes(layer), 1);
    QCOMPARE(app.window->view().selection().size(), std::size_t(1));
    app.window->copyStrokes();
    const Result<CopiedStrokes> copied = strokesFrom(QGuiApplication::clipboard()->mimeData());
    QVERIFY(copied.ok());
    QCOMPARE(copied->strokes[0].line.points[1], Vec3(1, 0.5, 0));
    QCOMPARE(*copied->strokes[0].colour, app.window->brush().colour);
    app.window->painting().undoStack()->undo();
    QCOMPARE(app.strokes(layer), 0);
}

QTEST_MAIN(PainterLinksTest)
#include "painter_links_test.moc"
