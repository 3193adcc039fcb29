"""``python -m varistiff.cli`` is the ``varistiff`` command."""

import sys

from varistiff.cli.main import main

sys.exit(main())
