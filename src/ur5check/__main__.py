"""`python -m ur5check` is the command `ur5check`."""

from ._cli.main import main

if __name__ == "__main__":
    raise SystemExit(main())
