// What the languages share: the temporal and Boolean operators, names, intervals and all tokens.
//
// A language imports this grammar and defines `comparison` (what stands below the operators) and
// `reserved` (its own words that may still be names). Every decision is taken on one or two tokens;
// prefixes and joined operands are loops, so only parentheses nest.
grammar common;

tokens { GROUP }    // a parenthesised part that has been read already: see the reader of tokens

// Several levels are such parts that were cut out.
formula : level (',' level)* EOF ;

// U, R, => and <=> never share a level with another operator. The grammar takes them, so that the
// reader can refuse them with both readings.
level : unary (connective unary)* ;

connective
    : AND
    | OR
    | IMPLIES
    | IFF
    | (UNTIL | RELEASE) interval
    ;

// Not greedy: where 'X' could be a name as well as the operator, it is a name.
unary : prefix*? (comparison | joined) ;

prefix
    : NOT
    | NEXT
    | (EVENTUALLY | DIAMOND | ALWAYS | BOX | ONE | ALL) interval
    ;

joined : (ONE | ALL) parts ;

// One level is a formula or number in parentheses; several are the parts of an operator before them.
parts
    : GROUP
    | '(' level (',' level)* ')'
    ;

interval : '[' bound ',' bound ']' ;
bound : '-'? NUMBER ;

relation : GE | LE | GT | LT | EQ | NE ;

constant : TRUE | FALSE ;

name : NAME | STRING | reserved ;
word : EVENTUALLY | ALWAYS | UNTIL | RELEASE | NEXT | ONE | ALL ;

// --- tokens ---

AND     : '&&' | '&' | '/\\' ;
OR      : '||' | '|' | '\\/' ;
NOT     : '!' | '~' | 'not' ;
IMPLIES : '=>' | '->' ;
IFF     : '<=>' | '<->' ;
DIAMOND : '<>' ;
BOX     : '[]' ;

GE : '>=' ;
LE : '<=' ;
GT : '>' ;
LT : '<' ;
EQ : '=' | '==' ;
NE : '!=' ;

TRUE  : 'true' | 'True' ;
FALSE : 'false' | 'False' ;

EVENTUALLY : 'F' ;
ALWAYS     : 'G' ;
UNTIL      : 'U' ;
RELEASE    : 'R' ;
NEXT       : 'X' ;
ONE        : 'one' ;
ALL        : 'all' ;

OPEN    : '(' ;
CLOSE   : ')' ;
PLUS    : '+' ;
MINUS   : '-' ;
STAR    : '*' ;
SLASH   : '/' ;
PERCENT : '%' ;
COMMA   : ',' ;
LBRACKET : '[' ;
RBRACKET : ']' ;
LBRACE   : '{' ;
RBRACE   : '}' ;

NUMBER : (DIGIT+ ('.' DIGIT*)? | '.' DIGIT+) ([eE] [+-]? DIGIT+)? ;
NAME   : [A-Za-z_] [A-Za-z0-9_]* ;
STRING : '"' (~["\\] | '\\' ["\\])* '"' ;
SPACE  : [ \t\r\n\f]+ -> skip ;
STRAY  : . ;    // every other character, so that it is reported with its place

fragment DIGIT : [0-9] ;
