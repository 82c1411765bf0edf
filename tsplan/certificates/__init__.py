"""Certificates: proofs that others can check, as files, and a checker that believes nothing."""
