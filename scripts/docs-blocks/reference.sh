#!/usr/bin/env bash
# Inputs, options and results of all operations.
exec "$LOBER" schema --markdown
