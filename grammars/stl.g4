// Signal temporal logic: linear predicates over real signals, 2*x - y + 1 >= 3.
grammar stl;

import common;

// One relation at most makes sense; more are taken so that the reader can refuse them in words.
comparison : total (relation total)* ;

total : term (('+' | '-') term)* ;

term : factor (('*' | '/') factor)* ;

factor : ('+' | '-')* operand ;

operand
    : constant
    | NUMBER
    | name
    | parts
    ;

reserved : letter ;
