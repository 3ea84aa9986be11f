#!/usr/bin/env bash
# painting_pictures.sh LAYERPAINTER FOLDER: ID.png for the gallery, of every painting FOLDER/paintings.json names.
set -euo pipefail
[ $# -eq 2 ] || { echo "usage: painting_pictures.sh LAYERPAINTER FOLDER" >&2; exit 2; }
sed -n 's/^ *"id": "\([a-z-]*\)",$/\1/p' "$2/paintings.json" | while read -r id; do
    "$1" thumbnail "$2/$id.ductus" -o "$2/$id.png" --size 480 --quiet </dev/null
done
