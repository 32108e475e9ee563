#!/usr/bin/env bash
# All formats of curve files, from the table of the engine.
"$LOBER" --generate formats
