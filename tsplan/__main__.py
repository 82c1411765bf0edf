"""`python -m tsplan` is the command `tsplan`."""

import sys

from tsplan.cli import main

if __name__ == "__main__":
    sys.exit(main())
