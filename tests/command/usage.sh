#!/bin/sh
# Help, version, and what is refused on the command line.
. tests/command/common
cd "$work" || exit 1
"$PYTHON" "$TESTS/volumes.py" in_12x10x8_uint8.raw
IN=in_12x10x8_uint8.raw

for command in "" render info compare classify pyramid freevoxel splat advise "vectors check" "vectors show"; do
    # shellcheck disable=SC2086
    check "--help $command" sh -c "\"$QVOL\" $command --help | grep -q '^Usage: qvol'"
    # shellcheck disable=SC2086
    check "--version $command" sh -c "\"$QVOL\" $command --version | grep -q '^qvol [0-9]'"
    # shellcheck disable=SC2086
    "$QVOL" $command --help 2>&1 >/dev/null | grep -q .
    outcome $((1 - $?)) "--help $command is silent on standard error"
done
sed -n 's/^ *{"\([a-z-]*\)", [^,]*, \("[^"]*"\|NULL\), "..*/\1/p' "$TESTS/../../port/host/settings.c" >options
check "options are found in the source" test "$(wc -l <options)" -gt 25
missing=
while read -r option; do
    { "$QVOL" render --help; "$QVOL" classify --help; "$QVOL" compare --help; "$QVOL" pyramid --help; "$QVOL" freevoxel --help; "$QVOL" splat --help; "$QVOL" advise --help; "$QVOL" vectors show --help; } |
        grep -q -e "--$option" || missing="$missing $option"
done <options
check "every option is in the help:$missing" test -z "$missing"

refuses "no command" 2 "none given" "$QVOL"
refuses "unknown command" 2 "unknown command" "$QVOL" draw
refuses "unknown option" 2 "--colour: unknown" "$QVOL" render $IN -o a.pam --colour
refuses "unknown letter" 2 ": -x: unknown" "$QVOL" render $IN -o a.pam -x
refuses "unknown letter after another" 2 ": -x: unknown" "$QVOL" render $IN -o a.pam -qx
refuses "option of another command" 2 "unknown" "$QVOL" info $IN --zoom 2
refuses "palette without a file" 2 "needs a file" "$QVOL" classify $IN -o -
refuses "no value" 2 "needs a value" "$QVOL" render $IN -o a.pam --zoom
refuses "no input" 2 "0 given" "$QVOL" render -o a.pam
refuses "two inputs" 2 "2 given" "$QVOL" render $IN $IN -o a.pam
for option in --output --json --tf --mask --mask-tf --palette; do
    refuses "empty name: $option" 2 ": $option: the name is empty" "$QVOL" render $IN -o a.pam $option=
done
refuses "empty name: -o" 2 ": --output: the name is empty" "$QVOL" classify $IN -o ""
refuses "empty name of the input" 2 "number 1 is empty" "$QVOL" render "" -o a.pam
refuses "empty name of a picture" 2 "number 2 is empty" "$QVOL" compare a.pam ""
refuses "no output" 2 "missing" "$QVOL" render $IN
refuses "no output of classify" 2 "missing" "$QVOL" classify $IN
refuses "unknown ending" 2 "does not end in" "$QVOL" render $IN -o a.gif
refuses "report and picture in one file" 2 "cannot both" "$QVOL" render $IN -o - --json

refused() { # refused OPTION VALUE PATTERN
    refuses "$1 $2" 2 "$3" "$QVOL" render $IN -o a.pam "$1" "$2"
}
refused --storage rgba9 "rgba8, rgba16, indexed8, rgbt8, rgbt16"
refused --extinction 0 "not a number from 1.5.*e-05 to 65535"
refused --extinction -1 "not a number from"
refused --extinction 65536 "not a number from"
refused --extinction much "not a number from"
refused --extinction 5 ": --extinction: needs --storage rgbt8, rgbt16 or indexed8"
refused --extinction auto ": --extinction: needs --storage rgbt8"
refused --unit-distance 0 "not a number from 0.00390625 to 4096"
refused --unit-distance -1 "not a number from"
refused --unit-distance 4097 "not a number from"
refused --unit-distance auto "not a number from"
refused --level -1 "not a number from 0 to 12"
refused --level 13 "not a number from 0 to 12"
refused --level deep "not a number from 0 to 12"
refused --filter box3 "box2, box4, quad4"
refused --domain colour "extinction, opacity"
refused --filter box2 ": --filter: needs --level"
refused --domain opacity ": --domain: needs --level"
refused --palette-bits 12 "neither 8 nor 16"
refused --palette-bits 16 "only indexed8"
refused --sampling linear "nearest, separate, weighted, preweighted, extinction, bspline-weighted, bspline-extinction"
refused --order sideways "front-to-back"
refused --tf nosuch "neither a preset nor a file"
refused --window 5 "LOW:HIGH"
refused --window 9:9 "LOW below HIGH"
refused --window 9:3 "LOW below HIGH"
refused --window 0.5:9 "whole number"
refused --window 0:999999 ": 999999 is not a whole number"
refused --window 5:5.0000001 ": 5.0000001 is not a whole number from .*; 8- and 16-bit data"
refused --window 0:0.5 ": 0.5 is not a whole number from .*; 8- and 16-bit data"
refused --window 1:1.0000000000000002 ": 1.0000000000000002 is not"
check "--help tells that windows are whole" sh -c \
    '"$1" render --help | grep -q "window of 8- and 16-bit values is in whole numbers"' - "$QVOL"
refused --window nan:3 "LOW:HIGH"
refused --size 0x5 "WxH"
refused --size 5 "WxH"
refused --size 5x5x5 "WxH"
refused --size 32768x1 "32767"
refused --size 99999999999999999999x1 "WxH"
refused --size -5x5 "WxH"
refused --azimuth ten "not a number"
refused --azimuth inf "not a number"
refused --elevation 1e300 "not a number from"
refused --roll 0x10 "not a number"
refused --zoom 0 "not a number from"
refused --zoom -1 "not a number from"
refused --perspective 0 "from 1 to 150"
refused --perspective 151 "from 1 to 150"
refused --step 0 "from 0.0625 to 16"
refused --step -1 "from 0.0625 to 16"
refused --step 17 "from 0.0625 to 16"
refused --phase 1 "not a number from 0"
refused --phase -0.1 "not a number from 0"
refused --background 12345 "RRGGBB"
refused --background 12345g "RRGGBB"
refused --termination 2 "from 0 to 1"
refused --format rgb332 "rgb565le"
refused --as gif "png, pam, raw"
refused --strip 0 "from 1"
refused --threads 0 "from 1 to 256"
refused --threads 257 "from 1 to 256"
refused --dims 12x10 "XxYxZ"
refused --dims 0x10x8 "XxYxZ"
refused --dims 4097x10x8 "4096"
refused --type u12 "u16le"
refused --skip -1 "not a whole number"
refused --spacing 1x0x1 "above 0"
refused --spacing 1x2 "XxYxZ"
refused --palette no.palette "only data of --type indexed8"
refused --light 5 "RIGHT,UP"
refused --mask $IN "needs --mask-tf"
refused --mask-tf skin "needs --mask"
refused --light 10,20 "needs --shade"
needs() { # needs OPTION PATTERN COMMAND ARGUMENT...: one that would change nothing
    option=$1 pattern=$2
    shift 2
    refuses "$option without what it needs: $*" 2 ": $option: needs $pattern" "$QVOL" "$@"
}
needs --light --shade classify $IN -o a.raw --light 10,20
needs --termination "--order front" render $IN -o a.pam --termination 0 --order back-to-front
for mode in nearest separate; do
    needs --unit-distance "another --sampling" render $IN -o a.pam --sampling $mode --unit-distance 2
    needs --level "another --sampling" render $IN -o a.pam --sampling $mode --level 1
done
needs --level "--order front-to-back" render $IN -o a.pam --level 1 --order back-to-front
needs --unit-distance "--storage rgbt8 or rgbt16" classify $IN -o a.raw --unit-distance 2
needs --unit-distance "--storage rgbt8 or rgbt16" pyramid $IN -o a.raw --unit-distance 2 --storage rgba8
for mode in nearest separate weighted bspline-weighted; do
    refuses "--sampling $mode of extinction" 2 ": --sampling: $mode takes opacities" "$QVOL" render $IN \
        -o a.pam --storage rgbt8 --sampling $mode
done
refuses "a unit distance of too many steps" 2 ": --unit-distance: unit distance" "$QVOL" render $IN -o a.pam \
    --unit-distance 4096 --step 0.5
refuses "an extinction that is too much for a step" 2 ": --extinction: extinction" "$QVOL" render $IN -o a.pam \
    --extinction 65535 --storage rgbt16 --level 4 --step 16
refuses "an option of another command: --level" 2 "unknown" "$QVOL" classify $IN -o a.raw --level 1
refuses "an option of another command: --reduce" 2 "unknown" "$QVOL" pyramid $IN -o a.raw --reduce 2
needs --gain --output compare a b --gain 2
needs --name "an output" classify $IN -o a.raw --name head
needs --name "an output" classify $IN -o - --name head
needs --endian "raw output" classify $IN -o a.c --endian little
needs --endian "raw output" classify $IN -o a.h --storage rgba16 --endian big
check "classify --help tells the byte order of C arrays" sh -c \
    '"$1" classify --help | grep -q "C arrays are in the compiler.s own byte"' - "$QVOL"
refuses "--shade with a palette" 2 "rgba8 or rgba16" "$QVOL" render $IN -o a.pam --storage indexed8 --shade
refuses "--mask with a palette" 2 "rgba8 or rgba16" "$QVOL" render $IN -o a.pam --storage indexed8 \
    --mask $IN --mask-tf grey
refuses "--strip between the rows of a byte" 2 "multiple" "$QVOL" render $IN -o a.pam --strip 5 \
    --format mono-vertical
refuses "--fit with --reduce" 2 "chooses the factors" "$QVOL" classify $IN -o a.raw --fit 5 --reduce 2
refuses "--reduce 65" 2 "1 to 64" "$QVOL" classify $IN -o a.raw --reduce 65
refuses "--reduce 0" 2 "1 to 64" "$QVOL" classify $IN -o a.raw --reduce 0
refuses "--name 1a" 2 "not a name" "$QVOL" classify $IN -o a.c --name 1a
refuses "--endian middle" 2 "little, big" "$QVOL" classify $IN -o a.raw --endian middle
refuses "--tolerance -1" 2 "not a number from" "$QVOL" compare a b --tolerance -1
refuses "raw without --type" 2 "need both" "$QVOL" info --dims 12x10x8 "$TESTS/common"
refuses "raw without --dims" 2 "need both" "$QVOL" info --type u8 "$TESTS/common"
refuses "--skip of no raw file" 2 "only raw data" "$QVOL" info --skip 3 "$TESTS/common"
refuses "a frame wider than the camera's world" 2 "view" "$QVOL" render $IN -o a.pam \
    --zoom 0.001 --size 1x1
refuses "a line break in a name stays one line" 1 "?b" "$QVOL" info "a
b"
check "no file is left" sh -c '! ls | grep -e "^a\." -e "\.tmp$"'
finish
