"""An arm handed over to somebody else's simulator: whole packages, as values; `folder` writes them.

`templates/` holds each file as it will stand in a package, blanks written @{so}.
"""
