<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>ductus::MeasuresPanel</name>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::PrintFindings</name>
    <message numerus="yes">
        <source>Watertight, in %n pieces.</source>
        <translation>
            <numerusform>Watertight, in %n piece.</numerusform>
            <numerusform>Watertight, in %n pieces.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::ReadingList</name>
    <message numerus="yes">
        <source>%n regions</source>
        <translation>
            <numerusform>%n region</numerusform>
            <numerusform>%n regions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::SketchDocument</name>
    <message numerus="yes">
        <source>Move %n strokes</source>
        <translation>
            <numerusform>Move %n stroke</numerusform>
            <numerusform>Move %n strokes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n strokes</source>
        <translation>
            <numerusform>Delete %n stroke</numerusform>
            <numerusform>Delete %n strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::StrokePanel</name>
    <message numerus="yes">
        <source>Border found: the surface ends along %n strokes nobody marked.</source>
        <translation>
            <numerusform>Border found: the surface ends along %n stroke nobody marked.</numerusform>
            <numerusform>Border found: the surface ends along %n strokes nobody marked.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes chosen</source>
        <translation>
            <numerusform>%n stroke chosen</numerusform>
            <numerusform>%n strokes chosen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::SurfaceButton</name>
    <message numerus="yes">
        <source>Up to date: %n regions</source>
        <translation>
            <numerusform>Up to date: %n region</numerusform>
            <numerusform>Up to date: %n regions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points, not surfaced yet.</source>
        <translation>
            <numerusform>%n point, not surfaced yet.</numerusform>
            <numerusform>%n points, not surfaced yet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes, not surfaced yet.</source>
        <translation>
            <numerusform>%n stroke, not surfaced yet.</numerusform>
            <numerusform>%n strokes, not surfaced yet.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::SurfacerWindow</name>
    <message numerus="yes">
        <source>These %n points do not follow one another: they are taken as points of the surface, and creases are found by its shape alone.</source>
        <translation>
            <numerusform>This %n point has no other to follow: it is taken as a point of the surface, and creases are found by its shape alone.</numerusform>
            <numerusform>These %n points do not follow one another: they are taken as points of the surface, and creases are found by its shape alone.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes look like cables and become thin tubes. Where one is none, select it and set its role to “on the surface”.</source>
        <translation>
            <numerusform>%n stroke looks like a cable and becomes a thin tube. If it is none, select it and set its role to “on the surface”.</numerusform>
            <numerusform>%n strokes look like cables and become thin tubes. Where one is none, select it and set its role to “on the surface”.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>And %n more.</numerusform>
            <numerusform>And %n more.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures are in %1.</source>
        <translation>
            <numerusform>%n picture is in %1.</numerusform>
            <numerusform>%n pictures are in %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes pasted.</source>
        <translation>
            <numerusform>%n stroke pasted.</numerusform>
            <numerusform>%n strokes pasted.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes copied.</source>
        <translation>
            <numerusform>%n stroke copied.</numerusform>
            <numerusform>%n strokes copied.</numerusform>
        </translation>
    </message>
</context>
</TS>
