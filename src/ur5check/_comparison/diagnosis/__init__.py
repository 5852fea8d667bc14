"""Which known mistake explains a difference: a list of mistakes, and a search that can also say
"none"."""
