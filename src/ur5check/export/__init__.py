"""An arm as text that others read: the way back from `sources`.  Writes strings, opens no file."""
