#!/usr/bin/env bash
# check_package.sh PACKAGE.deb ROOT [PICTURES]: installs the package in a clean Debian 12 below ROOT (made by debootstrap
# if it is not there), uses every app there as people do, removes it and looks for what it left. As root. With the
# folder PICTURES screenshots are kept. Ends with "All N checks passed." and 0, or tells what failed and ends with 1.
set -uo pipefail

fail() { printf 'check_package: %s\n' "$*" >&2; exit 2; }
[ $# -ge 2 ] || fail "usage: check_package.sh PACKAGE.deb ROOT [PICTURES]"
[ "$(id -u)" -eq 0 ] || fail "a root in a folder needs root"
deb=$(realpath "$1") || exit 2
mkdir -p "$2" && root=$(realpath "$2") || exit 2
[ "$root" != / ] || fail "not in the system itself"
pictures=${3:-}
[ -z "$pictures" ] || { mkdir -p "$pictures" && pictures=$(realpath "$pictures"); }

readonly MIRROR=${DUCTUS_MIRROR:-http://deb.debian.org/debian}
# To look with, besides what the package itself asks for.
readonly TOOLS="xvfb xauth xdg-utils imagemagick libglib2.0-bin file procps ca-certificates man-db"

checks=0 failures=0
scratch=$(mktemp -d) # what a check says, and lists of files
# check WORDS COMMAND...
check() {
    local words=$1
    shift
    checks=$((checks + 1))
    if "$@" >"$scratch/said" 2>&1; then
        printf 'ok      %s\n' "$words"
    else
        failures=$((failures + 1))
        printf 'FAILED  %s\n' "$words"
        sed 's/^/        /' "$scratch/said" | tail -n 20
    fi
}
inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/home/tester LANG=C.UTF-8 \
    XDG_RUNTIME_DIR=/run/tester DEBIAN_FRONTEND=noninteractive "$@"; }
says() { local wanted=$1; shift; local told; told=$("$@" 2>&1); printf '%s\n' "$told"; [[ $told == *"$wanted"* ]]; }
isnt_empty() { [ -s "$root$1" ]; }
isnt_there() { [ ! -e "$root$1" ]; }

# ---- a clean system --------------------------------------------------------------------------------------------

if [ ! -x "$root/usr/bin/apt-get" ]; then
    command -v debootstrap >/dev/null || fail "debootstrap is missing; install it: apt-get install debootstrap"
    debootstrap --variant=minbase bookworm "$root" "$MIRROR" >&2 || fail "debootstrap failed"
fi
cp /etc/resolv.conf "$root/etc/resolv.conf"
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc" || fail "cannot mount proc in $root"
mountpoint -q "$root/dev" || mount --rbind /dev "$root/dev" || fail "cannot mount dev in $root"
mount --make-rslave "$root/dev"
trap 'umount -l "$root/dev" "$root/proc"; rm -rf "$scratch"' EXIT
mkdir -p "$root/home/tester" "$root/run/tester" && chmod 700 "$root/run/tester"
cp "$deb" "$root/home/tester/ductus.deb"

inside dpkg --purge ductus >/dev/null 2>&1
needs=$(dpkg-deb -f "$deb" Depends)
recommends=$(dpkg-deb -f "$deb" Recommends | tr ',' ' ')
inside apt-get -q update >&2 || fail "apt-get update failed in $root"
# shellcheck disable=SC2086  # one word a package
inside apt-get -y -q install --no-install-recommends $TOOLS $recommends >&2 || fail "cannot install $TOOLS $recommends"
inside apt-get -y -q satisfy --no-install-recommends "$needs" >&2 || fail "what the package depends on is not to be had"

# Files of the system, without what changes by itself. Caches of types and menus are compared by content, so that a
# trace of the package in them is found.
files_of_system() {
    (cd "$root" && find . -xdev \( -path ./proc -o -path ./dev -o -path ./run -o -path ./tmp -o -path ./home \
        -o -path ./var/log -o -path ./var/cache/apt -o -path ./var/lib/apt -o -path ./var/lib/dpkg -o -path ./root \
        -o -path ./var/cache/man -o -path ./var/cache/fontconfig -o -path ./var/cache/ldconfig \) -prune \
        -o -print | sort)
}
caches_of_system() {
    (cd "$root" && find usr/share/mime usr/share/applications -type f -print0 | sort -z | xargs -0 sha256sum)
}
before=$scratch/before after=$scratch/after caches=$scratch/caches
files_of_system >"$before"
caches_of_system >"$caches"

# ---- installed -------------------------------------------------------------------------------------------------

check "the package installs" inside dpkg -i /home/tester/ductus.deb
inside dpkg -L ductus >"$scratch/files"
check "its programs are in PATH" inside sh -c 'for p in sketchsurfacer layerpainter doodlestudio ductus; do
    command -v $p && $p --version || exit 1; done'
for program in sketchsurfacer layerpainter doodlestudio ductus; do
    check "$program finds all its libraries" inside sh -c "! ldd /usr/bin/$program | grep 'not found'"
    check "$program is without Qt 5" inside sh -c "! ldd /usr/bin/$program | grep libQt5"
    check "man $program" says "NAME" inside man -P cat "$program"
done
check "no path of the machine it was built on is in the programs" sh -c \
    "! grep -aoE '(^|[^a-z])/(work|root|home)/[a-z]+/|build/(release|package)' $root/usr/bin/sketchsurfacer $root/usr/bin/layerpainter \
    $root/usr/bin/doodlestudio $root/usr/bin/ductus"

samples=/usr/share/ductus/samples home=/home/tester
check "a sketch becomes a surface" inside sketchsurfacer surface $samples/bent-leaf.curves -o $home/leaf.obj \
    --boundary=0,1,10,11 --quiet
check "the surface is there" isnt_empty $home/leaf.obj
check "a sketch becomes a project" inside sketchsurfacer surface $samples/bevelled-box.curves -o $home/box.ductus --quiet
check "a painting becomes a picture" inside xvfb-run -a layerpainter render $samples/desk-diorama.ductus \
    -o $home/desk.png --look Night --size 640x400 --quiet
check "and without a display" inside layerpainter render $samples/desk-diorama.ductus -o $home/desk2.png \
    --size 320x200 --quiet
check "a clip becomes a film" inside doodlestudio export $samples/passing-box.ductus -o $home/box.mp4 --quiet
check "the film is there" isnt_empty $home/box.mp4

# Without its name: the type is told from the content.
cp "$root$samples/forest-path.ductus" "$root$home/nameless"
cp "$root$samples/forest-path.ductus" "$root$home/named.ductus"
kind=application/vnd.ductus.project+zip
# Outside of any desktop xdg-mime asks file(1), which knows no types of others.
check "xdg-mime knows a project by its name" says $kind inside env XDG_CURRENT_DESKTOP=GNOME xdg-mime query filetype $home/named.ductus
check "gio knows it by its content" says $kind inside gio info -a standard::content-type $home/nameless
check "a click opens the app the project belongs to" says org.ductus.AnyProject.desktop \
    inside xdg-mime query default $kind
check "the menu names three apps for it" inside sh -c "gio mime $kind | grep -c 'org.ductus.*desktop' | grep -qE '[4-9]'"
# The command of the thumbnailer entry, as a file manager fills it in.
for project in named.ductus box.ductus; do
    command=$(sed -n 's/^Exec=//p' "$root/usr/share/thumbnailers/ductus.thumbnailer" |
        sed "s|%s|256|; s|%o|$home/$project.png|; s|%i|$home/$project|")
    # shellcheck disable=SC2086
    check "the thumbnailer draws $project" inside $command
    check "its picture is a PNG" says "PNG image" inside file $home/$project.png
done
for icon in apps/org.ductus.SketchSurfacer apps/org.ductus.LayerPainter apps/org.ductus.DoodleStudio \
    mimetypes/application-vnd.ductus.project+zip; do
    check "icon $icon" isnt_empty "/usr/share/icons/hicolor/48x48/$icon.png"
done

# window APP FILE: a window of it comes up on the file; its picture is not one flat colour.
window() {
    inside xvfb-run -a -s "-screen 0 1366x768x24 +extension GLX" sh -c "
        $1 $2 >/home/tester/$1.log 2>&1 & app=\$!
        for i in \$(seq 120); do
            sleep 0.5
            kill -0 \$app 2>/dev/null || { cat /home/tester/$1.log; exit 1; }
            import -window root /home/tester/$1.png
            colours=\$(identify -format %k /home/tester/$1.png)
            if [ \$colours -gt 300 ]; then
                sleep ${DUCTUS_SETTLE_SECONDS:-6}
                import -window root /home/tester/$1.png
                kill \$app
                exit 0
            fi
        done
        kill \$app
        echo \"no window in a minute: \$colours colours on the screen\"
        exit 1"
}
for app in "sketchsurfacer $samples/car.curves" "layerpainter $samples/desk-diorama.ductus" \
    "doodlestudio $samples/passing-box.ductus"; do
    # shellcheck disable=SC2086
    check "the window of ${app%% *}" window $app
    [ -z "$pictures" ] || cp "$root/home/tester/${app%% *}.png" "$pictures/"
done
[ -z "$pictures" ] || cp "$root$home"/desk.png "$root$home"/*.ductus.png "$pictures/"
check "opening samples leaves nothing beside them" sh -c \
    "! find $root/usr/share/ductus \\( -name '*~' -o -name '.*' \\) -type f | grep ."

# ---- removed ---------------------------------------------------------------------------------------------------

check "the package is removed" inside dpkg --purge ductus
files_of_system >"$after"
check "no file is left or lost" diff "$before" "$after"
check "the caches are as before" sh -c "cd $root && sha256sum --quiet -c $caches"
check "the type is unknown again" says application/zip inside gio info -a standard::content-type $home/nameless

[ "$failures" -eq 0 ] || { printf '%d of %d checks failed.\n' "$failures" "$checks"; exit 1; }
printf 'All %d checks passed.\n' "$checks"
