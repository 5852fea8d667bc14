"""What `paper` shows, a section a file."""
