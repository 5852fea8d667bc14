"""One file per engine: its class, its registry entry and its known issues (see `registry`)."""
