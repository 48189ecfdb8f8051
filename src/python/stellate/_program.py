"""The console script `stellate`: the same command line as that of the program."""

import sys

from . import _native


def main() -> int:
    """Runs the program with the arguments of this process and returns its exit code."""
    return _native.main(["stellate", *sys.argv[1:]])
