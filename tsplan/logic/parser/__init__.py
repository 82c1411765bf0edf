"""From text to formulas: tokens, generated parsers, and readers that build the nodes.

Nothing here recurses on the nesting of a text. Parentheses that nest deeply are cut out and parsed
on their own, innermost first (`streams`); prefixes and joined operands are loops in the grammars.
"""
