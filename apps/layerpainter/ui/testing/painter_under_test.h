// The window as a painter uses it in tests: clicks, drags and keys; pictures under DUCTUS_SHOTS.
#pragma once

#include "layerpainter/ui/window/painter_window.h"
#include "widgets/controls/number_slider.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QTemporaryDir>
#include <QtTest>

namespace ductus {

struct PainterUnderTest
{
    QTemporaryDir folder;
    Settings settings{folder.filePath("settings.ini")};
    JobRunner jobs;
    ActionCatalogue actions{&settings};
    std::unique_ptr<PainterWindow> window;

    PainterUnderTest()
    {
        qputenv("XDG_STATE_HOME", folder.filePath("state").toUtf8()); // nothing of the user's own is offered
        settings.setRaw(QStringLiteral("appearance/theme"), qEnvironmentVariable("DUCTUS_THEME", "dark"));
        window = std::make_unique<PainterWindow>(ShellServices{&settings, &jobs, &actions});
        window->resize(1280, 800);
        window->show();
        window->activateWindow();
    }
    ~PainterUnderTest() { window->painting().reset(); }

    const Painting &painting() const { return window->painting().painting(); }
    std::string print() const { return paintingFingerprint(painting()); }
    int strokes(LayerId layer) const { return painting().findLayer(layer)->elementCount(); }

    void shot(const QString &name)
    {
        const QString to = qEnvironmentVariable("DUCTUS_SHOTS");
        if (to.isEmpty())
            return;
        QTest::qWait(400);
        window->grab().save(to + '/' + name + ".png");
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(window->windowHandle(), key, modifiers);
    }
    void drag(const std::vector<QPoint> &points, Qt::KeyboardModifiers modifiers = {})
    {
        PaintingView &view = window->view();
        view.setFocus();
        QTest::mousePress(&view, Qt::LeftButton, modifiers, points.front());
        for (const QPoint &p : points) {
            // QTest::mouseMove tells of no buttons
            QMouseEvent move(QEvent::MouseMove, p, view.mapToGlobal(p), Qt::NoButton, Qt::LeftButton,
                             modifiers);
            QApplication::sendEvent(&view, &move);
            QCoreApplication::processEvents();
        }
        QTest::mouseRelease(&view, Qt::LeftButton, modifiers, points.back());
    }
    bool open(const QString &sample)
    {
        const int before = window->view().frameCount();
        window->openSample(sample);
        return QTest::qWaitFor([&] { return window->view().frameCount() > before; }, 60'000);
    }
    /// Clicks the row of a stack.
    void chooseStack(const QString &name)
    {
        LayerTree &tree = window->layers().tree();
        for (int i = 0; i < tree.topLevelItemCount(); ++i)
            if (tree.topLevelItem(i)->text(0) == name) {
                tree.scrollToItem(tree.topLevelItem(i));
                const QRect row = tree.visualItemRect(tree.topLevelItem(i));
                QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, row.center() - QPoint(40, 0));
                window->view().setFocus();
                return;
            }
        QFAIL(qPrintable("no stack " + name));
    }
    void chooseColour(const QColor &colour)
    {
        auto *field = window->findChild<ColourField *>();
        const int square = field->width() - 30; // the bar of hues lies right of it
        QTest::mouseClick(field, Qt::LeftButton, {},
                          {field->width() - 5, qRound(colour.hueF() * (field->height() - 2)) + 1});
        QTest::mouseClick(field, Qt::LeftButton, {},
                          {qRound(colour.saturationF() * square),
                           qRound((1 - colour.valueF()) * (field->height() - 2)) + 1});
        window->view().setFocus();
    }
    void type(const QString &label, const QString &number)
    {
        for (auto *slider : window->findChildren<NumberSlider *>())
            if (slider->label() == label && slider->isVisible()) {
                auto *field = slider->findChild<QDoubleSpinBox *>();
                field->setFocus();
                field->selectAll();
                QTest::keyClicks(field, number);
                QTest::keyClick(field, Qt::Key_Return);
                window->view().setFocus();
                return;
            }
        QFAIL(qPrintable("no number " + label));
    }
    void chooseBlend(const QString &mode)
    {
        for (auto *box : window->findChildren<QComboBox *>())
            if (const int index = box->findText(mode); index >= 0) {
                box->setFocus();
                while (box->currentIndex() != index)
                    QTest::keyClick(box, box->currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
                window->view().setFocus();
                return;
            }
        QFAIL(qPrintable("no blend mode " + mode));
    }
};

} // namespace ductus
