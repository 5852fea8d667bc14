"""The command `ur5check`: one file per subcommand, each imported only when it is chosen."""
