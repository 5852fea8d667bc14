"""The referees: other people's dynamics, asked the same questions.  Each is imported only when used."""
