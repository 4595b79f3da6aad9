#!/bin/sh
# The page's lines for pkg-config; what `make install` puts where, tests/static/install.sh tells.
set -eu
. tests/packages/common
check "the example draws here" expected
check "port/README.md has lines for pkg-config" lines pkg-config
check "they build the example" follow
check "it draws the picture" runs_here "$site/ball"
check "the library is whole" holds_everything nm "$site/sdk/lib/libqvol.a"
finish
