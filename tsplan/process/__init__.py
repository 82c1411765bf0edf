"""Processes, threads and signals: child processes, watchdogs, Ctrl-C, grace periods, output."""
