"""How results are shown.  Nothing is computed here: values are picked, put in order and written."""
