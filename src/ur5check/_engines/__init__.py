"""The reference engines: other people's dynamics, asked the same questions; imported only when
used."""
