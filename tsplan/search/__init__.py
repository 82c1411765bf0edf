"""Searching an encoded problem: linear programs, dives, branch and bound, one objective each."""
