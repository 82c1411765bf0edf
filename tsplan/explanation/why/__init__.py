"""Why a plan satisfies its formula, and what is tight about it."""
