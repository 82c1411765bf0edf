// Signal temporal logic: linear predicates over real signals, 2*x - y + 1 >= 3, in(goal).
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
    | region
    | parts
    ;

// in(goal), or in(robot, goal) where several robots have the same signals.
region : (IN | OUT | CLEAR) '(' name (',' name)? ')' ;

reserved : word | IN | OUT | CLEAR ;

IN    : 'in' ;
OUT   : 'out' ;
CLEAR : 'clear' ;
