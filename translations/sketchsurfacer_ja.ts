<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>ductus::AmbiguityPresenter</name>
    <message>
        <source>What the sketch leaves open</source>
        <translation>スケッチで決まらない部分</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>確定</translation>
    </message>
    <message>
        <source>open</source>
        <translation>未確定</translation>
    </message>
    <message>
        <source>Looking for other readings</source>
        <translation>別の解釈を検索</translation>
    </message>
</context>
<context>
    <name>ductus::ExportDialog</name>
    <message>
        <source>OBJ - with regions as groups</source>
        <translation>OBJ - 領域をグループに</translation>
    </message>
    <message>
        <source>PLY - with region numbers</source>
        <translation>PLY - 領域番号つき</translation>
    </message>
    <message>
        <source>STL - for printing</source>
        <translation>STL - 3D プリント用</translation>
    </message>
    <message>
        <source>GLB - for the web and game engines</source>
        <translation>GLB - Web・ゲームエンジン用</translation>
    </message>
    <message>
        <source>OFF - plain</source>
        <translation>OFF - 形状のみ</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>サーフェスの書き出し</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>Keep &amp;regions apart</source>
        <translation>領域を分けておく(&amp;R)</translation>
    </message>
    <message>
        <source>Add &amp;creases as lines</source>
        <translation>クリースを線として追加(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>形式(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>単位(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>書き出し(&amp;E)...</translation>
    </message>
    <message>
        <source>GLB is always in metres.</source>
        <translation>GLB は常にメートル単位です。</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 in the file, %4 triangles, about %5</source>
        <translation>ファイル内 %1 × %2 × %3、三角形 %4 個、約 %5</translation>
    </message>
</context>
<context>
    <name>ductus::MeasuresPanel</name>
    <message>
        <source>metre</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>decimetre</source>
        <translation>デシメートル</translation>
    </message>
    <message>
        <source>centimetre</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>フィート</translation>
    </message>
    <message>
        <source>Half of the strokes&apos; points lie nearer to the surface than this; in brackets: 95 %.</source>
        <translation>ストロークの点の半分はこれよりサーフェスに近く、かっこ内は 95 % の値です。</translation>
    </message>
    <message>
        <source>Unit of the sketch</source>
        <translation>スケッチの単位</translation>
    </message>
    <message>
        <source>What the number 1 of the sketch&apos;s file means. Nothing is scaled.</source>
        <translation>スケッチのファイルでの 1 が表す長さです。拡大縮小はしません。</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>上方向の軸</translation>
    </message>
    <message>
        <source>y is up</source>
        <translation>y が上</translation>
    </message>
    <message>
        <source>z is up</source>
        <translation>z が上</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Off the strokes</source>
        <translation>ずれ</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>Watertight</source>
        <translation>閉じた形状</translation>
    </message>
    <message>
        <source>&amp;One unit is a</source>
        <translation>1 単位(&amp;O)</translation>
    </message>
    <message>
        <source>Ax&amp;es</source>
        <translation>軸(&amp;E)</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n 点</numerusform>
        </translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no, it has a border</source>
        <translation>いいえ (縁があります)</translation>
    </message>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 L</translation>
    </message>
    <message>
        <source>%1 m³</source>
        <translation>%1 m³</translation>
    </message>
</context>
<context>
    <name>ductus::ParameterPanel</name>
    <message>
        <source>Tightness</source>
        <translation>密着度</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>How closely the first rough skin (the proxy) wraps the strokes: tight finds handles and holes, loose bridges gaps. Technically: alpha of the wrap.</source>
        <translation>最初の大まかな皮 (プロキシ) がどれだけストロークに沿うか。密着させると取っ手や穴が見つかり、緩めると隙間が埋まります。技術的にはラップのアルファ値です。</translation>
    </message>
    <message>
        <source>loose</source>
        <translation>緩い</translation>
    </message>
    <message>
        <source>tight</source>
        <translation>密着</translation>
    </message>
    <message>
        <source>Choose tightness by itself</source>
        <translation>密着度を自動で選ぶ</translation>
    </message>
    <message>
        <source>Takes the tightest skin that does not fall in between the strokes.</source>
        <translation>ストロークの間に落ち込まない範囲で、最も密着した皮を使います。</translation>
    </message>
    <message>
        <source>Looseness</source>
        <translation>許容幅</translation>
    </message>
    <message>
        <source>How far the surface may stay away from the strokes. Raise it for wobbly sketches. Technically: epsilon, in percent of the sketch&apos;s diagonal.</source>
        <translation>サーフェスがストロークから離れてよい距離です。線がふらつくスケッチでは大きくします。技術的にはイプシロン (スケッチの対角線に対する %) です。</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>正確</translation>
    </message>
    <message>
        <source>Simplicity</source>
        <translation>単純さ</translation>
    </message>
    <message>
        <source>How much few and simple surfaces are preferred to many. Technically: the weight of the label costs, w_simplicity, as a multiple of its default.</source>
        <translation>多くの面より少数の単純な面をどれだけ優先するか。技術的にはラベルコストの重み w_simplicity で、既定値に対する倍率です。</translation>
    </message>
    <message>
        <source>detailed</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>simple</source>
        <translation>単純</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>対称</translation>
    </message>
    <message>
        <source>Only one half is solved and mirrored, welded exactly in the plane.</source>
        <translation>半分だけを計算して鏡映し、対称面で正確に接合します。</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Find it</source>
        <translation>自動検出</translation>
    </message>
    <message>
        <source>Mirror left–right (x)</source>
        <translation>左右に鏡映 (x)</translation>
    </message>
    <message>
        <source>Mirror along y</source>
        <translation>y 方向に鏡映</translation>
    </message>
    <message>
        <source>Mirror along z</source>
        <translation>z 方向に鏡映</translation>
    </message>
    <message>
        <source>S&amp;ymmetry</source>
        <translation>対称(&amp;Y)</translation>
    </message>
    <message>
        <source>Change tightness</source>
        <translation>密着度の変更</translation>
    </message>
    <message>
        <source>Change looseness</source>
        <translation>許容幅の変更</translation>
    </message>
    <message>
        <source>Change simplicity</source>
        <translation>単純さの変更</translation>
    </message>
    <message>
        <source>Change symmetry</source>
        <translation>対称の変更</translation>
    </message>
    <message>
        <source>Found: %1 % of the strokes mirror, %2 apart.</source>
        <translation>検出: ストロークの %1 % が鏡映、ずれ %2。</translation>
    </message>
    <message>
        <source>None was found.</source>
        <translation>見つかりませんでした。</translation>
    </message>
    <message>
        <source>A plane of its own</source>
        <translation>独自の対称面</translation>
    </message>
</context>
<context>
    <name>ductus::PrintFindings</name>
    <message>
        <source>Watertight, in one piece.</source>
        <translation>閉じた形状、1 個の部品。</translation>
    </message>
    <message numerus="yes">
        <source>Watertight, in %n pieces.</source>
        <translation>
            <numerusform>閉じた形状、%n 個の部品。</numerusform>
        </translation>
    </message>
    <message>
        <source>Not watertight: the surface ends at a border. A printer needs a closed shape, or a sheet that is given a thickness elsewhere.</source>
        <translation>閉じていません: サーフェスに縁があります。印刷には閉じた形状か、ほかのソフトで厚みを付けたシートが必要です。</translation>
    </message>
    <message>
        <source>ends here</source>
        <translation>ここが縁</translation>
    </message>
    <message>
        <source>Thinnest wall %1: less than one line of the nozzle, it will be missing. %2 of the surface is as thin.</source>
        <translation>最も薄い壁 %1: ノズルの線 1 本より薄く、印刷されません。サーフェスの %2 が同じ薄さです。</translation>
    </message>
    <message>
        <source>Thinnest wall %1: less than two lines of the nozzle, it breaks easily. %2 of the surface is as thin.</source>
        <translation>最も薄い壁 %1: ノズルの線 2 本より薄く、折れやすくなります。サーフェスの %2 が同じ薄さです。</translation>
    </message>
    <message>
        <source>Thinnest wall %1.</source>
        <translation>最も薄い壁 %1。</translation>
    </message>
    <message>
        <source>Narrowest gap %1: less than one line of the nozzle, it will grow shut.</source>
        <translation>最も狭い隙間 %1: ノズルの線 1 本より狭く、埋まってしまいます。</translation>
    </message>
    <message>
        <source>Narrowest gap %1.</source>
        <translation>最も狭い隙間 %1。</translation>
    </message>
    <message>
        <source>Nowhere runs through itself.</source>
        <translation>自己交差はありません。</translation>
    </message>
    <message>
        <source>Runs through itself: slicers may leave holes there.</source>
        <translation>自己交差があります: スライサーによっては穴になります。</translation>
    </message>
    <message>
        <source>runs through itself</source>
        <translation>自己交差</translation>
    </message>
    <message>
        <source>Pieces overlap: most slicers join them to one.</source>
        <translation>部品が重なっています: ほとんどのスライサーは 1 つに結合します。</translation>
    </message>
    <message>
        <source>pieces overlap</source>
        <translation>部品の重なり</translation>
    </message>
    <message>
        <source>Less than 1 %</source>
        <translation>1 % 未満</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>ductus::PrintPanel</name>
    <message>
        <source>Longest side of the print</source>
        <translation>印刷物の最も長い辺</translation>
    </message>
    <message>
        <source>How long the longest side is to be on the printer. Nothing is scaled; the check asks what would be too thin at that size.</source>
        <translation>印刷時の最も長い辺の長さです。拡大縮小はせず、その大きさで薄すぎる箇所を調べます。</translation>
    </message>
    <message>
        <source>Width of a line of the nozzle</source>
        <translation>ノズルの線幅</translation>
    </message>
    <message>
        <source>The width of the lines the printer lays; 0.4 mm is usual.</source>
        <translation>プリンターが積む線の幅です。通常は 0.4 mm です。</translation>
    </message>
    <message>
        <source>Lon&amp;gest side</source>
        <translation>最も長い辺(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Nozzle</source>
        <translation>ノズル(&amp;N)</translation>
    </message>
    <message>
        <source>Checking the print</source>
        <translation>印刷チェック</translation>
    </message>
    <message>
        <source>Looking at walls and gaps...</source>
        <translation>壁と隙間を調べています...</translation>
    </message>
    <message>
        <source>Surface the sketch to see whether it can be printed.</source>
        <translation>印刷できるか調べるには、スケッチをサーフェス化してください。</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Show: %1</source>
        <translation>表示: %1</translation>
    </message>
    <message>
        <source>Turns the view to the place and marks it; Esc takes the mark away.</source>
        <translation>その場所に視点を向けて印を付けます。Esc で印が消えます。</translation>
    </message>
</context>
<context>
    <name>ductus::ReadingList</name>
    <message>
        <source>&amp;Look for other readings</source>
        <translation>別の解釈を探す(&amp;L)</translation>
    </message>
    <message>
        <source>Colours where the strokes allow more than one surface, and offers the others (A).</source>
        <translation>ストロークから複数のサーフェスが考えられる箇所に色を付け、別の候補を示します (A)。</translation>
    </message>
    <message>
        <source>Where strokes are few, they allow more than one surface.</source>
        <translation>ストロークが少ない所では、複数のサーフェスが考えられます。</translation>
    </message>
    <message>
        <source>Trying what else the strokes could mean...</source>
        <translation>ストロークの別の解釈を試しています...</translation>
    </message>
    <message>
        <source>Surface the sketch to see what it leaves open.</source>
        <translation>スケッチで決まらない部分を見るには、サーフェス化してください。</translation>
    </message>
    <message>
        <source>The strokes say enough: no other surface is nearly as likely.</source>
        <translation>ストロークは十分です: ほかに同じくらい確からしいサーフェスはありません。</translation>
    </message>
    <message>
        <source>The strokes could also mean this. Choose one, or draw a stroke where the surface is coloured.</source>
        <translation>ストロークはこのようにも解釈できます。どれかを選ぶか、色の付いた所にストロークを描いてください。</translation>
    </message>
    <message numerus="yes">
        <source>%n regions</source>
        <translation>
            <numerusform>領域 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>as likely</source>
        <translation>同じくらい確からしい</translation>
    </message>
    <message>
        <source>nearly as likely</source>
        <translation>ほぼ同じくらい確からしい</translation>
    </message>
    <message>
        <source>less likely</source>
        <translation>可能性は低い</translation>
    </message>
    <message>
        <source>Other reading %1: %2, %3</source>
        <translation>別の解釈 %1: %2、%3</translation>
    </message>
    <message>
        <source>Takes this surface instead. Undo brings the present one back.</source>
        <translation>こちらのサーフェスに切り替えます。元に戻すと今のものに戻ります。</translation>
    </message>
</context>
<context>
    <name>ductus::RegionList</name>
    <message>
        <source>plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>quadric</source>
        <translation>2 次曲面</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>3 次曲面</translation>
    </message>
    <message>
        <source>quartic</source>
        <translation>4 次曲面</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>サーフェス</translation>
    </message>
    <message>
        <source>The regions appear here once the sketch is surfaced.</source>
        <translation>サーフェス化すると、ここに領域が表示されます。</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>領域</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>Off by</source>
        <translation>ずれ</translation>
    </message>
    <message>
        <source>Mean distance of its strokes from the region.</source>
        <translation>領域とそのストロークとの平均距離です。</translation>
    </message>
    <message>
        <source>Press Enter or right-click to change a region&apos;s kind; the lock keeps it as it is.</source>
        <translation>Enter キーか右クリックで領域の種類を変えます。鍵を掛けるとそのまま保たれます。</translation>
    </message>
    <message>
        <source>Locked: stays as it is. Click to free it.</source>
        <translation>ロック中: 変わりません。クリックで解除します。</translation>
    </message>
    <message>
        <source>Click to keep this region as it is.</source>
        <translation>クリックすると、この領域はそのまま保たれます。</translation>
    </message>
    <message>
        <source>Make it a %1</source>
        <translation>%1にする</translation>
    </message>
    <message>
        <source>Lock or free it</source>
        <translation>ロックまたは解除</translation>
    </message>
</context>
<context>
    <name>ductus::SketchDocument</name>
    <message>
        <source>Change role of strokes</source>
        <translation>ストロークの役割の変更</translation>
    </message>
    <message>
        <source>New region</source>
        <translation>新しい領域</translation>
    </message>
    <message>
        <source>Merge regions</source>
        <translation>領域の結合</translation>
    </message>
    <message>
        <source>Draw seam</source>
        <translation>シームを描く</translation>
    </message>
    <message>
        <source>Forbid seam</source>
        <translation>シームの禁止</translation>
    </message>
    <message>
        <source>Split region</source>
        <translation>領域の分割</translation>
    </message>
    <message>
        <source>Lock region</source>
        <translation>領域のロック</translation>
    </message>
    <message>
        <source>Change surface kind</source>
        <translation>面の種類の変更</translation>
    </message>
    <message>
        <source>Remove scribble</source>
        <translation>スクリブルの削除</translation>
    </message>
    <message>
        <source>Remove all scribbles</source>
        <translation>すべてのスクリブルの削除</translation>
    </message>
    <message>
        <source>Draw stroke</source>
        <translation>ストロークを描く</translation>
    </message>
    <message>
        <source>Move stroke</source>
        <translation>ストロークの移動</translation>
    </message>
    <message numerus="yes">
        <source>Move %n strokes</source>
        <translation>
            <numerusform>%n 本のストロークの移動</numerusform>
        </translation>
    </message>
    <message>
        <source>Bend stroke</source>
        <translation>ストロークを曲げる</translation>
    </message>
    <message>
        <source>Delete stroke</source>
        <translation>ストロークの削除</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n strokes</source>
        <translation>
            <numerusform>%n 本のストロークの削除</numerusform>
        </translation>
    </message>
    <message>
        <source>Use proxy from file</source>
        <translation>ファイルのプロキシを使用</translation>
    </message>
    <message>
        <source>Make proxy automatically</source>
        <translation>プロキシの自動生成</translation>
    </message>
    <message>
        <source>Change unit</source>
        <translation>単位の変更</translation>
    </message>
    <message>
        <source>Choose another surface</source>
        <translation>別のサーフェスを選択</translation>
    </message>
    <message>
        <source>Surface anew</source>
        <translation>サーフェスの作り直し</translation>
    </message>
    <message>
        <source>Paste strokes</source>
        <translation>ストロークの貼り付け</translation>
    </message>
</context>
<context>
    <name>ductus::SketchPresenter</name>
    <message>
        <source>Drawing the surface</source>
        <translation>サーフェスの描画</translation>
    </message>
    <message>
        <source>Strokes to surface</source>
        <translation>ストロークとサーフェスの距離</translation>
    </message>
</context>
<context>
    <name>ductus::SketchView</name>
    <message>
        <source>Canvas</source>
        <translation>キャンバス</translation>
    </message>
</context>
<context>
    <name>ductus::StrokePanel</name>
    <message>
        <source>on the surface</source>
        <translation>サーフェス上</translation>
    </message>
    <message>
        <source>border of the surface</source>
        <translation>サーフェスの縁</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>無視</translation>
    </message>
    <message>
        <source>inside, not used</source>
        <translation>内側 (使わない)</translation>
    </message>
    <message>
        <source>thin tube</source>
        <translation>細いチューブ</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>役割</translation>
    </message>
    <message>
        <source>With strokes chosen: what they are for. Otherwise: what the role brush paints.</source>
        <translation>ストロークを選択中はその役割、選択がなければ役割ブラシで塗る役割です。</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>削除(&amp;D)</translation>
    </message>
    <message>
        <source>Takes the chosen strokes out of the sketch (Del). Undo brings them back.</source>
        <translation>選択したストロークをスケッチから取り除きます (Del)。元に戻せます。</translation>
    </message>
    <message>
        <source>&amp;Role</source>
        <translation>役割(&amp;R)</translation>
    </message>
    <message>
        <source>Mark as &amp;border</source>
        <translation>縁として指定(&amp;B)</translation>
    </message>
    <message>
        <source>Nobody marked these strokes; the surface ends along them because nothing lies beyond. Marked, they stay its border whatever else is drawn.</source>
        <translation>これらのストロークは指定されていませんが、その先に何もないためサーフェスがここで終わります。指定すると、何を描き足しても縁のままになります。</translation>
    </message>
    <message numerus="yes">
        <source>Border found: the surface ends along %n strokes nobody marked.</source>
        <translation>
            <numerusform>縁を検出: 指定のない %n 本のストロークに沿ってサーフェスが終わります。</numerusform>
        </translation>
    </message>
    <message>
        <source>No stroke chosen</source>
        <translation>ストローク未選択</translation>
    </message>
    <message>
        <source>One stroke chosen</source>
        <translation>ストローク 1 本を選択</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes chosen</source>
        <translation>
            <numerusform>ストローク %n 本を選択</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::SurfaceButton</name>
    <message>
        <source>Progress</source>
        <translation>進行状況</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stops and keeps the last surface (Esc).</source>
        <translation>停止して直前のサーフェスを残します (Esc)。</translation>
    </message>
    <message>
        <source>&amp;Update</source>
        <translation>更新(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Surface it</source>
        <translation>サーフェス化(&amp;S)</translation>
    </message>
    <message>
        <source>Finds the surface the strokes describe (Ctrl+Enter).</source>
        <translation>ストロークが表すサーフェスを求めます (Ctrl+Enter)。</translation>
    </message>
    <message>
        <source>Open a sketch or draw strokes first.</source>
        <translation>先にスケッチを開くか、ストロークを描いてください。</translation>
    </message>
    <message numerus="yes">
        <source>Up to date: %n regions</source>
        <translation>
            <numerusform>最新: 領域 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 s</source>
        <translation>、%1 秒</translation>
    </message>
    <message>
        <source>The surface is older than the sketch.</source>
        <translation>サーフェスがスケッチより古くなっています。</translation>
    </message>
    <message numerus="yes">
        <source>%n points, not surfaced yet.</source>
        <translation>
            <numerusform>%n 点、未サーフェス化。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes, not surfaced yet.</source>
        <translation>
            <numerusform>ストローク %n 本、未サーフェス化。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::SurfacerWindow</name>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>編集</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>サーフェス</translation>
    </message>
    <message>
        <source>&amp;New sketch</source>
        <translation>新規スケッチ(&amp;N)</translation>
    </message>
    <message>
        <source>Begins with an empty canvas to draw on.</source>
        <translation>空のキャンバスから描き始めます。</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>開く(&amp;O)...</translation>
    </message>
    <message>
        <source>Opens a project, or a sketch of another program.</source>
        <translation>プロジェクトや、ほかのソフトのスケッチを開きます。</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>スタートページ(&amp;T)</translation>
    </message>
    <message>
        <source>Shows samples and recent files; the sketch stays open.</source>
        <translation>サンプルと最近のファイルを表示します。スケッチは開いたままです。</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Saves sketch, decisions and surface.</source>
        <translation>スケッチと指定した内容、サーフェスを保存します。</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>別名で保存(&amp;A)...</translation>
    </message>
    <message>
        <source>Saves under another name.</source>
        <translation>別の名前で保存します。</translation>
    </message>
    <message>
        <source>&amp;Export surface...</source>
        <translation>サーフェスの書き出し(&amp;E)...</translation>
    </message>
    <message>
        <source>Writes OBJ, PLY, STL, GLB or OFF for other programs.</source>
        <translation>ほかのソフト用に OBJ、PLY、STL、GLB、OFF を書き出します。</translation>
    </message>
    <message>
        <source>Send to &amp;LayerPainter</source>
        <translation>LayerPainter に送る(&amp;L)</translation>
    </message>
    <message>
        <source>Opens the project in LayerPainter, to paint on the surface.</source>
        <translation>LayerPainter でプロジェクトを開き、サーフェスに描きます。</translation>
    </message>
    <message>
        <source>Save p&amp;icture...</source>
        <translation>画像を保存(&amp;I)...</translation>
    </message>
    <message>
        <source>Writes what the canvas shows as a PNG file.</source>
        <translation>キャンバスの表示を PNG ファイルに書き出します。</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>画像を保存</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>Save t&amp;urntable...</source>
        <translation>ターンテーブルを保存(&amp;U)...</translation>
    </message>
    <message>
        <source>Writes a round of 72 pictures into a folder, to be made a film of.</source>
        <translation>1 周分 72 枚の画像をフォルダーに書き出します。動画作りに使えます。</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>画像のフォルダー</translation>
    </message>
    <message>
        <source>&amp;Paste sketch</source>
        <translation>スケッチを貼り付け(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Delete strokes</source>
        <translation>ストロークを削除(&amp;D)</translation>
    </message>
    <message>
        <source>Takes the chosen strokes out of the sketch.</source>
        <translation>選択したストロークをスケッチから取り除きます。</translation>
    </message>
    <message>
        <source>Choose &amp;all strokes</source>
        <translation>すべてのストロークを選択(&amp;A)</translation>
    </message>
    <message>
        <source>So that one act changes them all.</source>
        <translation>一度の操作で全部を変更できます。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Stops what runs, forgets what was begun, goes back to the arrow.</source>
        <translation>実行中の処理と途中の操作をやめ、選択ツールに戻ります。</translation>
    </message>
    <message>
        <source>&amp;Surface it</source>
        <translation>サーフェス化(&amp;U)</translation>
    </message>
    <message>
        <source>Finds the surface the strokes describe.</source>
        <translation>ストロークが表すサーフェスを求めます。</translation>
    </message>
    <message>
        <source>Surface a&amp;new</source>
        <translation>サーフェスを作り直す(&amp;N)</translation>
    </message>
    <message>
        <source>Forgets the way here: edited strokes are usually worked into the surface there is.</source>
        <translation>これまでの経緯を捨てます。通常、編集したストロークは今のサーフェスに組み込まれます。</translation>
    </message>
    <message>
        <source>&amp;Update by itself</source>
        <translation>自動で更新(&amp;P)</translation>
    </message>
    <message>
        <source>After a scribble or a moved slider the surface follows without a click.</source>
        <translation>スクリブルやスライダーの操作に、サーフェスが自動で追従します。</translation>
    </message>
    <message>
        <source>Remove all s&amp;cribbles</source>
        <translation>すべてのスクリブルを削除(&amp;C)</translation>
    </message>
    <message>
        <source>Back to the regions found automatically.</source>
        <translation>自動検出された領域に戻します。</translation>
    </message>
    <message>
        <source>Use &amp;proxy from file...</source>
        <translation>ファイルのプロキシを使う(&amp;E)...</translation>
    </message>
    <message>
        <source>Takes a mesh made elsewhere as the rough skin the strokes are read on.</source>
        <translation>ほかで作ったメッシュを、ストロークを読み取る大まかな皮として使います。</translation>
    </message>
    <message>
        <source>Make proxy &amp;automatically</source>
        <translation>プロキシを自動生成(&amp;A)</translation>
    </message>
    <message>
        <source>Forgets the mesh from a file.</source>
        <translation>ファイルのメッシュの使用をやめます。</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>選択(&amp;S)</translation>
    </message>
    <message>
        <source>Drag turns the view, a click chooses a stroke or region.</source>
        <translation>ドラッグで視点を回し、クリックでストロークや領域を選びます。</translation>
    </message>
    <message>
        <source>&amp;Role brush</source>
        <translation>役割ブラシ(&amp;R)</translation>
    </message>
    <message>
        <source>Paint over strokes to say what they are: border, ignored, ...</source>
        <translation>ストロークの上を塗って、縁や無視などの役割を付けます。</translation>
    </message>
    <message>
        <source>&amp;Draw stroke</source>
        <translation>ストロークを描く(&amp;D)</translation>
    </message>
    <message>
        <source>Add the stroke that was missing; the surface follows.</source>
        <translation>足りないストロークを加えると、サーフェスが追従します。</translation>
    </message>
    <message>
        <source>&amp;New region</source>
        <translation>新しい領域(&amp;N)</translation>
    </message>
    <message>
        <source>Yellow: what you scribble over becomes a surface of its own.</source>
        <translation>黄: なぞった部分が独立した面になります。</translation>
    </message>
    <message>
        <source>&amp;Merge regions</source>
        <translation>領域を結合(&amp;M)</translation>
    </message>
    <message>
        <source>Green: the regions you connect become one.</source>
        <translation>緑: つないだ領域が 1 つになります。</translation>
    </message>
    <message>
        <source>Red: a crease must run exactly here.</source>
        <translation>赤: ここに必ずクリースを通します。</translation>
    </message>
    <message>
        <source>S&amp;plit region</source>
        <translation>領域を分割(&amp;P)</translation>
    </message>
    <message>
        <source>Orange: cuts a region in two along your line.</source>
        <translation>橙: 線に沿って領域を 2 つに分けます。</translation>
    </message>
    <message>
        <source>&amp;Forbid seam</source>
        <translation>シームを禁止(&amp;F)</translation>
    </message>
    <message>
        <source>Blue: no crease may run here.</source>
        <translation>青: ここにはクリースを作りません。</translation>
    </message>
    <message>
        <source>&amp;Lock region</source>
        <translation>領域をロック(&amp;L)</translation>
    </message>
    <message>
        <source>A locked region stays as it is, whatever else changes.</source>
        <translation>ロックした領域は、ほかが変わってもそのままです。</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>計測(&amp;E)</translation>
    </message>
    <message>
        <source>The length between two points.</source>
        <translation>2 点間の長さを測ります。</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>前(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>後(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>右(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>左(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>上(&amp;T)</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>下(&amp;O)</translation>
    </message>
    <message>
        <source>Three-&amp;quarter</source>
        <translation>斜め(&amp;Q)</translation>
    </message>
    <message>
        <source>Looks from there.</source>
        <translation>その方向から見ます。</translation>
    </message>
    <message>
        <source>Fr&amp;ame all</source>
        <translation>全体を表示(&amp;A)</translation>
    </message>
    <message>
        <source>Brings the whole sketch into view.</source>
        <translation>スケッチ全体を画面に収めます。</translation>
    </message>
    <message>
        <source>Comes nearer.</source>
        <translation>近づきます。</translation>
    </message>
    <message>
        <source>Zoom o&amp;ut</source>
        <translation>縮小(&amp;U)</translation>
    </message>
    <message>
        <source>Steps back.</source>
        <translation>離れます。</translation>
    </message>
    <message>
        <source>Turn view (%1)</source>
        <translation>視点を回す (%1)</translation>
    </message>
    <message>
        <source>Turns the view without a mouse.</source>
        <translation>マウスを使わずに視点を回します。</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>透視投影(&amp;P)</translation>
    </message>
    <message>
        <source>Far things smaller; off for measuring by eye.</source>
        <translation>遠いものを小さく見せます。目で測るときはオフにします。</translation>
    </message>
    <message>
        <source>Shows the sketch on top of the surface.</source>
        <translation>サーフェスの上にスケッチを表示します。</translation>
    </message>
    <message>
        <source>Turns the view by itself, to look at it from all sides.</source>
        <translation>視点が自動で回り、全方向から眺められます。</translation>
    </message>
    <message>
        <source>&amp;Mirror drawn strokes</source>
        <translation>描いたストロークを鏡映(&amp;M)</translation>
    </message>
    <message>
        <source>Where the sketch is symmetric a stroke comes with its mirror image.</source>
        <translation>スケッチが対称なら、ストロークの鏡像も描かれます。</translation>
    </message>
    <message>
        <source>What the sketch leaves &amp;open</source>
        <translation>スケッチで決まらない部分(&amp;O)</translation>
    </message>
    <message>
        <source>Colours where the strokes allow more than one surface; a click there offers the others.</source>
        <translation>複数のサーフェスが考えられる箇所に色を付けます。クリックで別の候補を示します。</translation>
    </message>
    <message>
        <source>&amp;Compare with the sketch</source>
        <translation>スケッチと比較(&amp;C)</translation>
    </message>
    <message>
        <source>A line to drag: the sketch at its left, the surface at its right.</source>
        <translation>境界線をドラッグ: 左がスケッチ、右がサーフェスです。</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>サーフェス(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>ツール(&amp;T)</translation>
    </message>
    <message>
        <source>SketchSurfacer</source>
        <translation>SketchSurfacer</translation>
    </message>
    <message>
        <source>From a 3D sketch to a surface you can print, render or take into CAD.</source>
        <translation>3D スケッチから、印刷・レンダリング・CAD に使えるサーフェスへ。</translation>
    </message>
    <message>
        <source>New sketch</source>
        <translation>新規スケッチ</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>開く...</translation>
    </message>
    <message>
        <source>Drop a sketch (.curves, .obj, .txt), points (.xyz), a proxy mesh or a project anywhere.</source>
        <translation>スケッチ (.curves、.obj、.txt)、点群 (.xyz)、プロキシメッシュ、プロジェクトをどこにでもドロップできます。</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>無題</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Sketches and projects (*.ductus *.curves *.obj *.txt *.xyz *.crv);;Proxy meshes (*.ply *.stl *.off *.glb *.obj);;All files (*)</source>
        <translation>スケッチとプロジェクト (*.ductus *.curves *.obj *.txt *.xyz *.crv);;プロキシメッシュ (*.ply *.stl *.off *.glb *.obj);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 の読み込み</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 を開く</translation>
    </message>
    <message>
        <source>The clipboard holds neither strokes nor a path to a file.</source>
        <translation>クリップボードにストロークもファイルのパスもありません。</translation>
    </message>
    <message>
        <source>Reading the clipboard</source>
        <translation>クリップボードの読み込み</translation>
    </message>
    <message>
        <source>Pasted</source>
        <translation>貼り付け</translation>
    </message>
    <message numerus="yes">
        <source>These %n points do not follow one another: they are taken as points of the surface, and creases are found by its shape alone.</source>
        <translation>
            <numerusform>この %n 点は連続していないため、サーフェス上の点として扱い、クリースは形状だけから求めます。</numerusform>
        </translation>
    </message>
    <message>
        <source>A stroke looks like a cable and becomes a thin tube. If it is none, select it and set its role to “on the surface”.</source>
        <translation>ケーブルのようなストロークを細いチューブにしました。違う場合は、選択して役割を「サーフェス上」にしてください。</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes look like cables and become thin tubes. Where one is none, select it and set its role to “on the surface”.</source>
        <translation>
            <numerusform>ケーブルのような %n 本のストロークを細いチューブにしました。違うものは、選択して役割を「サーフェス上」にしてください。</numerusform>
        </translation>
    </message>
    <message>
        <source>Some of the sketch was skipped: %1</source>
        <translation>スケッチの一部を読み飛ばしました: %1</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>ほか %n 件。</numerusform>
        </translation>
    </message>
    <message>
        <source>A mesh serves as the proxy of a sketch. Open the sketch first, then the mesh.</source>
        <translation>メッシュはスケッチのプロキシになります。先にスケッチ、次にメッシュを開いてください。</translation>
    </message>
    <message>
        <source>Reading the proxy</source>
        <translation>プロキシの読み込み</translation>
    </message>
    <message>
        <source>%1 is the proxy now.</source>
        <translation>%1 をプロキシにしました。</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>別名で保存</translation>
    </message>
    <message>
        <source>Ductus projects (*.ductus)</source>
        <translation>Ductus プロジェクト (*.ductus)</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>別名で保存...</translation>
    </message>
    <message>
        <source>LayerPainter paints on the surface, and there is none yet.</source>
        <translation>LayerPainter はサーフェスに描きますが、まだサーフェスがありません。</translation>
    </message>
    <message>
        <source>Surface it</source>
        <translation>サーフェス化</translation>
    </message>
    <message>
        <source>LayerPainter opens %1.</source>
        <translation>LayerPainter で %1 を開きます。</translation>
    </message>
    <message>
        <source>LayerPainter reads the saved project, and this one has changes.</source>
        <translation>LayerPainter は保存済みのプロジェクトを読みますが、未保存の変更があります。</translation>
    </message>
    <message>
        <source>Save and send</source>
        <translation>保存して送る</translation>
    </message>
    <message>
        <source>Save as and send...</source>
        <translation>別名で保存して送る...</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>サーフェスの書き出し</translation>
    </message>
    <message>
        <source>Exporting the surface</source>
        <translation>サーフェスの書き出し</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>%1 に書き出しました。</translation>
    </message>
    <message>
        <source>Writing the picture</source>
        <translation>画像の書き込み</translation>
    </message>
    <message>
        <source>The picture is in %1.</source>
        <translation>画像を %1 に保存しました。</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures are in %1.</source>
        <translation>
            <numerusform>%n 枚の画像を %1 に保存しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>スケッチ</translation>
    </message>
    <message>
        <source>The strokes alone.</source>
        <translation>ストロークだけを表示します。</translation>
    </message>
    <message>
        <source>Proxy</source>
        <translation>プロキシ</translation>
    </message>
    <message>
        <source>The rough skin the strokes are read on.</source>
        <translation>ストロークを読み取るための大まかな皮です。</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>領域</translation>
    </message>
    <message>
        <source>Which parts are one smooth surface each.</source>
        <translation>それぞれがひと続きの滑らかな面になる部分です。</translation>
    </message>
    <message>
        <source>The finished surface in clay.</source>
        <translation>完成したサーフェスを粘土の質感で表示します。</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>ずれ</translation>
    </message>
    <message>
        <source>How far strokes and surface are apart.</source>
        <translation>ストロークとサーフェスの離れ具合です。</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Other readings</source>
        <translation>別の解釈</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>寸法</translation>
    </message>
    <message>
        <source>Print check</source>
        <translation>印刷チェック</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>再試行</translation>
    </message>
    <message>
        <source>Install a graphics driver, or the software one: libgl1-mesa-dri.</source>
        <translation>グラフィックドライバーか、ソフトウェア版の libgl1-mesa-dri をインストールしてください。</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>ロック</translation>
    </message>
    <message>
        <source>%1 % open</source>
        <translation>未確定 %1 %</translation>
    </message>
    <message>
        <source>stroke %1</source>
        <translation>ストローク %1</translation>
    </message>
    <message>
        <source>border found</source>
        <translation>縁を検出</translation>
    </message>
    <message>
        <source>at most %1 off</source>
        <translation>ずれ最大 %1</translation>
    </message>
    <message>
        <source>Surface the sketch first.</source>
        <translation>先にサーフェス化してください。</translation>
    </message>
    <message>
        <source>Nothing drawn yet. Press D and draw the first stroke, or drop a sketch here.</source>
        <translation>まだ何も描かれていません。D キーで最初のストロークを描くか、ここにスケッチをドロップしてください。</translation>
    </message>
    <message>
        <source>&amp;Copy strokes</source>
        <translation>ストロークをコピー(&amp;C)</translation>
    </message>
    <message>
        <source>Puts the chosen strokes, or all, on the clipboard, for the other apps of the suite as well.</source>
        <translation>選択した (またはすべての) ストロークをクリップボードに入れます。スイートのほかのアプリでも使えます。</translation>
    </message>
    <message>
        <source>Adds strokes copied in this or another app of the suite, or opens text or a file.</source>
        <translation>このアプリやスイートのほかのアプリでコピーしたストロークを加えるか、テキストやファイルを開きます。</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes pasted.</source>
        <translation>
            <numerusform>ストロークを %n 本貼り付けました。</numerusform>
        </translation>
    </message>
    <message>
        <source>There are no strokes to copy yet.</source>
        <translation>コピーするストロークがまだありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes copied.</source>
        <translation>
            <numerusform>ストロークを %n 本コピーしました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Se&amp;am</source>
        <translation>シーム(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Zoom in</source>
        <translation>拡大(&amp;Z)</translation>
    </message>
    <message>
        <source>St&amp;rokes on the surface</source>
        <translation>サーフェス上のストローク(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Turntable</source>
        <translation>ターンテーブル(&amp;T)</translation>
    </message>
    <message>
        <source>Loo&amp;k from</source>
        <translation>視点(&amp;K)</translation>
    </message>
</context>
<context>
    <name>ductus::SurfacingJobs</name>
    <message>
        <source>Surfacing the sketch</source>
        <translation>スケッチのサーフェス化</translation>
    </message>
</context>
<context>
    <name>ductus::ToolBox</name>
    <message>
        <source>There is no region here. Surface the sketch and click one of its regions.</source>
        <translation>ここに領域はありません。サーフェス化してから領域をクリックしてください。</translation>
    </message>
    <message>
        <source>Drag a handle to bend the stroke; with Ctrl it slides over the surface, the wheel widens the bend. Drag the stroke between handles to move it.</source>
        <translation>ハンドルをドラッグして曲げます。Ctrl でサーフェス上を滑り、ホイールで曲げる範囲が広がります。ハンドルの間をドラッグすると移動します。</translation>
    </message>
    <message>
        <source>Drag to turn, wheel to zoom. Click a stroke or region to choose it, Shift+drag around several; drag chosen strokes to move them.</source>
        <translation>ドラッグで回転、ホイールで拡大縮小。クリックでストロークや領域を選択、Shift+ドラッグで囲んで選択、選択したストロークはドラッグで移動できます。</translation>
    </message>
    <message>
        <source>Paint over strokes to tell what they mean; the role is chosen in the inspector.</source>
        <translation>ストロークの上を塗って意味を付けます。役割はインスペクターで選びます。</translation>
    </message>
    <message>
        <source>Draw on the surface, or in the air facing you; begin at a stroke to snap to it.</source>
        <translation>サーフェス上か、正面の空間に描きます。ストロークから始めるとそこに吸着します。</translation>
    </message>
    <message>
        <source>Scribble over what should be a surface of its own.</source>
        <translation>独立した面にしたい部分をなぞります。</translation>
    </message>
    <message>
        <source>Draw from one region into another: they become one smooth surface.</source>
        <translation>領域から領域へ線を引くと、1 つの滑らかな面になります。</translation>
    </message>
    <message>
        <source>Draw where two surfaces must meet in a crease.</source>
        <translation>2 つの面がクリースで接する所に線を引きます。</translation>
    </message>
    <message>
        <source>Draw across a region to cut it in two.</source>
        <translation>領域を横切るように線を引くと、2 つに分かれます。</translation>
    </message>
    <message>
        <source>Draw along a crease that should not be there.</source>
        <translation>不要なクリースに沿って線を引きます。</translation>
    </message>
    <message>
        <source>Click a region to keep it as it is; click again to free it.</source>
        <translation>領域をクリックするとそのまま保たれ、もう一度クリックすると解除されます。</translation>
    </message>
    <message>
        <source>Click two points to measure between them.</source>
        <translation>2 点をクリックして、その間を測ります。</translation>
    </message>
</context>
<context>
    <name>ductus::VtkWidget</name>
    <message>
        <source>This computer&apos;s graphics driver offers no OpenGL 3.2.</source>
        <translation>このコンピューターのグラフィックドライバーは OpenGL 3.2 に対応していません。</translation>
    </message>
</context>
</TS>
