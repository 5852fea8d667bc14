"""The dynamics in closed form: the one recursion run on symbols, and printed as a program."""
