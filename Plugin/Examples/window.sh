#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Take the picture of ParaView's window for README.md: window.sh FOLDER_OF_THE_PLUGIN PICTURE.png
#
# Needs Xvfb, ImageMagick, xdotool, and libqt5svg5 for the icons; run it in the root of the repository.
set -euo pipefail
export PV_PLUGIN_PATH=$1
picture=$2

folder=$(mktemp -d)
mkdir "$folder/ParaView"
cat > "$folder/ParaView/ParaView5.11.0.ini" << END
[General]
GeneralSettings.ShowWelcomeDialog=false
[MainWindow]
Size=@Size(1152 1010)
Position=@Point(0 0)
END

Xvfb -displayfd 3 -screen 0 1152x1010x24 3> "$folder/display" 2> /dev/null &
server=$!
trap 'kill "$client" "$server"; rm -r "$folder"' EXIT
sleep 2
DISPLAY=":$(< "$folder/display")"
export DISPLAY
XDG_CONFIG_HOME=$folder paraview --script=Plugin/Examples/window.py &> /dev/null &
client=$!
sleep 30 # until everything is drawn
# The panel of properties higher, and its section of the filter folded.
xdotool mousemove 146 439 mousedown 1 mousemove 146 410 sleep 1 mousemove 146 320 sleep 1 mouseup 1 \
  sleep 3 mousemove 105 456 click 1 sleep 10
import -window root +dither -colors 128 "png8:$picture"
