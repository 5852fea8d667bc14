"""Where the repository's files are, wherever a test stands."""

from pathlib import Path

REPOSITORY = Path(__file__).parents[1]
