// Capability temporal logic: MTL over counts, with tasks T(d, A, {(c,m)}) and limits L(A, {(c,m)}).
grammar catl;

import mtl;

atom : count | known | task | limit | name ;

task : TASK '(' number ',' name ',' pairs (',' pairs)? ')' ;

limit : LIMIT '(' name ',' pairs ')' ;

pairs : '{' (pair (',' pair)*)? '}' ;

pair : '(' name ',' number ')' ;

reserved : word | SUM | MIN | MAX | KNOWN | TASK | LIMIT ;

TASK  : 'T' ;
LIMIT : 'L' ;
