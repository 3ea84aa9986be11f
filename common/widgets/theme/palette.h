// The colours of Ductus: dark and light, one accent per app. Values from the design (look.md, section 1);
// shades in between are mixed from them here and nowhere else.
#pragma once

#include <QColor>
#include <QPalette>

namespace ductus {

enum class AppKind { SketchSurfacer, LayerPainter, DoodleStudio };

struct ThemeColours
{
    bool isDark = true;
    QColor window; // behind everything
    QColor panel;  // bars, inspector
    QColor raised; // buttons, fields, cards
    QColor line;   // borders
    QColor text;
    QColor dim;        // secondary text
    QColor disabled;   // text of what cannot be used now
    QColor accent;     // selection, focus, the running part of bars
    QColor accentText; // links and words in the accent's colour: readable on panel and window
    QColor onAccent;   // text on the button colour
    QColor button;     // the accent where text stands on it
    QColor hover;      // a raised thing under the pointer
    QColor pressed;
    QColor success, warning, error;                               // marks
    QColor successText, warningText, errorText;                   // words in them
    QColor infoGround, successGround, warningGround, errorGround; // of the message bar
};

ThemeColours themeColours(bool dark, AppKind app);

/// A QPalette for Fusion made of them.
QPalette qtPalette(const ThemeColours &colours);

/// Contrast of two opaque colours, 1..21 (WCAG 2.1, relative luminance).
double contrast(const QColor &a, const QColor &b);

/// \a share of \a b over \a a, in sRGB.
QColor mixed(const QColor &a, const QColor &b, double share);

} // namespace ductus
