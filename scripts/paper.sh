#!/usr/bin/env bash
# The figures and tables of Naik, Lekien & Ross (2017) that docs/paper.md lists, made anew from the program into docs/paper:
# the same bytes each time. `paper.sh check` makes them elsewhere, and fails where a committed one differs; make test does
# so for those that take seconds.
exec "$(dirname "$0")/docs.sh" "${1:-make}" paper
