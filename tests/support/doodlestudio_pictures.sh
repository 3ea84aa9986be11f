#!/bin/bash
# The pictures of DoodleStudio's manual, taken from the real program on its bundled sample:
#     tests/support/doodlestudio_pictures.sh BUILD/apps/doodlestudio/doodlestudio OUTDIR
# Needs xvfb-run, openbox, xdotool and ImageMagick.
set -e
program=$(realpath "$1") out=$(realpath "$2") samples=$(realpath "$(dirname "$0")/../../resources/samples")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$samples"/passing-box.{ductus,mp4} "$work" # a lock is put beside what is opened
cat > "$work/inside" <<'INSIDE'
openbox > /dev/null 2>&1 &
manager=$!
"$program" "$work/passing-box.ductus" > "$work/log" 2>&1 &
app=$!
for i in $(seq 120); do
    window=$(xdotool search --onlyvisible --name 'passing-box' 2> /dev/null | head -1) || true
    [ -n "$window" ] && break
    sleep 0.5
done
xdotool windowsize "$window" 1264 740
xdotool windowmove "$window" 0 22
sleep 8 # the first frames are painted
take() { sleep 3; import -window "$window" -colors 255 "PNG8:$out/doodlestudio-$1.png"; }
key() { xdotool key --window "$window" "$1"; sleep 1; }
take start
# The face, a little later, with its way.
xdotool mousemove 1050 154 click 1
key 2
for i in $(seq 8); do key Right; done
take pin
key 3
key o
take draw
key ctrl+e
sleep 2
import -window root -colors 255 "PNG8:$out/doodlestudio-export.png"
kill "$app" "$manager"
INSIDE
export program out work HOME="$work" XDG_RUNTIME_DIR="$work"
chmod 700 "$work"
xvfb-run -a -s "-screen 0 1264x768x24" bash "$work/inside"
ls -la "$out"/doodlestudio-*.png
