#!/usr/bin/env bash
# Inputs, options and results of all operations, then the commands of the program with their options.
set -e
"$LOBER" schema --markdown
echo
"$LOBER" --generate markdown
