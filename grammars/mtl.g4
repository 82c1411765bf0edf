// Metric temporal logic over counts of agents: sum(A,c) >= 2, min(A) > 0, A, known(-1).
grammar mtl;

import common;

// One relation at most makes sense; more are taken so that the reader can refuse them in words.
comparison : operand (relation operand)* ;

operand
    : constant
    | number
    | atom
    | parts
    ;

number : '-'? NUMBER '%'? ;

atom : count | known | name ;

count : (SUM | MIN | MAX) '(' name (',' name)? ')' ;

known : KNOWN '(' number ')' ;

reserved : word | SUM | MIN | MAX | KNOWN ;

SUM   : 'sum' ;
MIN   : 'min' ;
MAX   : 'max' ;
KNOWN : 'known' ;
