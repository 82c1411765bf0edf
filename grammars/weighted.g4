// What the weighted languages have besides: weights after operators, a &&^w b, F[0,5]^[3, 2, 1] a,
// and && and || before a list of parts, &&^w (a, b, c).
//
// A weighted language imports this grammar first, so that its rules replace those of `common`.
grammar weighted;

connective
    : (AND | OR) weight?
    | IMPLIES
    | IFF
    | (UNTIL | RELEASE) interval weight?
    ;

prefix
    : NOT
    | NEXT
    | (EVENTUALLY | DIAMOND | ALWAYS | BOX) interval weight?
    | (ONE | ALL) interval
    ;

joined
    : (AND | OR) weight? parts
    | (ONE | ALL) parts
    ;

weight
    : HAT name
    | HAT value
    | HAT '[' value (',' value)* ']'
    ;

value : '-'? NUMBER ;

HAT : '^' ;
