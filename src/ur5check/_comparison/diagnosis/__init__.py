"""Which known mistake explains a difference: a catalogue, and a search that can also say "none"."""
