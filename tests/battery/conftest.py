"""Let the battery decide statuses with the independent reference solvers next door."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))
