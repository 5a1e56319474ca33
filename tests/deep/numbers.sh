#!/bin/sh
# The printer of numbers: 1e8 random bit patterns read back as they were.
. "$(dirname "$0")/../tap.sh"
runs 0 '1e8 numbers' env SEILWERK_NUMBERS=100000000 "$SEILWERK_BUILD/tests/number_test"
finish
