"""Pictures of results.  They compute nothing; matplotlib is loaded when one is drawn."""
