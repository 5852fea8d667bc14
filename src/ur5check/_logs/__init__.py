"""Recordings of real robots: read, filtered, and compared with a model."""
