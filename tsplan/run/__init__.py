"""One planning run: from a mission to a verified plan, its events and its child process."""
