<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>ductus::FilmDialog</name>
    <message numerus="yes">
        <source>%n frames</source>
        <translation>
            <numerusform>%n frame</numerusform>
            <numerusform>%n frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> in %n films</source>
        <translation>
            <numerusform> in %n film</numerusform>
            <numerusform> in %n films</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::LayerTree</name>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n stroke</numerusform>
            <numerusform>%n strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::PainterWindow</name>
    <message numerus="yes">
        <source>%n films are ready.</source>
        <translation>
            <numerusform>%n film is ready.</numerusform>
            <numerusform>%n films are ready.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes joined the painting</source>
        <translation>
            <numerusform>%n stroke joined the painting</numerusform>
            <numerusform>%n strokes joined the painting</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> in %n stacks.</source>
        <translation>
            <numerusform> in %n stack.</numerusform>
            <numerusform> in %n stacks.</numerusform>
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
        <source>The log of %n actions is saved.</source>
        <translation>
            <numerusform>The log of %n action is saved.</numerusform>
            <numerusform>The log of %n actions is saved.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes copied.</source>
        <translation>
            <numerusform>%n stroke copied.</numerusform>
            <numerusform>%n strokes copied.</numerusform>
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
        <source>%n surfaces changed in SketchSurfacer.</source>
        <translation>
            <numerusform>%n surface changed in SketchSurfacer.</numerusform>
            <numerusform>%n surfaces changed in SketchSurfacer.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n surfaces are as in their sketches now.</source>
        <translation>
            <numerusform>%n surface is as in its sketch now.</numerusform>
            <numerusform>%n surfaces are as in their sketches now.</numerusform>
        </translation>
    </message>
</context>
</TS>
