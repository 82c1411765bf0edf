// Capability temporal logic: MTL over counts, with tasks T(d, A, {(c,m)}), limits L(A, {(c,m)}),
// and tasks of which some steps are over: begun(T(d, A, {(c,m)}), s).
grammar catl;

import mtl;

atom : count | known | task | begun | limit | name ;

task : TASK '(' number ',' name ',' pairs (',' pairs)? ')' ;

begun : BEGUN '(' task ',' number ')' ;

limit : LIMIT '(' name ',' pairs ')' ;

pairs : '{' (pair (',' pair)*)? '}' ;

pair : '(' name ',' number ')' ;

reserved : word | SUM | MIN | MAX | KNOWN | TASK | BEGUN | LIMIT ;

TASK  : 'T' ;
BEGUN : 'begun' ;
LIMIT : 'L' ;
