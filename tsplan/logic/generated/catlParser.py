# Generated from catl.g4 by ANTLR 4.13.1
# encoding: utf-8
from antlr4 import *
from io import StringIO
import sys
if sys.version_info[1] > 5:
	from typing import TextIO
else:
	from typing.io import TextIO

def serializedATN():
    return [
        4,1,43,206,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,2,19,7,19,2,20,
        7,20,2,21,7,21,1,0,1,0,1,0,1,0,3,0,49,8,0,1,1,1,1,1,1,1,1,1,1,1,
        1,1,1,1,1,1,1,3,1,60,8,1,1,1,1,1,1,2,1,2,1,2,1,2,1,2,1,2,1,2,1,3,
        1,3,1,3,1,3,5,3,75,8,3,10,3,12,3,78,9,3,3,3,80,8,3,1,3,1,3,1,4,1,
        4,1,4,1,4,1,4,1,4,1,5,1,5,1,5,1,5,1,5,1,5,3,5,96,8,5,1,6,1,6,1,6,
        1,6,5,6,102,8,6,10,6,12,6,105,9,6,1,7,1,7,1,7,1,7,3,7,111,8,7,1,
        8,3,8,114,8,8,1,8,1,8,3,8,118,8,8,1,9,1,9,1,9,1,9,1,9,3,9,125,8,
        9,1,9,1,9,1,10,1,10,1,10,5,10,132,8,10,10,10,12,10,135,9,10,1,10,
        1,10,1,11,1,11,1,11,1,11,5,11,143,8,11,10,11,12,11,146,9,11,1,12,
        1,12,1,12,1,12,1,12,1,12,3,12,154,8,12,1,13,5,13,157,8,13,10,13,
        12,13,160,9,13,1,13,1,13,1,14,1,14,1,14,1,14,3,14,168,8,14,1,15,
        1,15,1,15,1,15,1,15,5,15,175,8,15,10,15,12,15,178,9,15,1,15,1,15,
        3,15,182,8,15,1,16,1,16,1,16,1,16,1,16,1,16,1,17,3,17,191,8,17,1,
        17,1,17,1,18,1,18,1,19,1,19,1,20,1,20,1,20,3,20,202,8,20,1,21,1,
        21,1,21,1,158,0,22,0,2,4,6,8,10,12,14,16,18,20,22,24,26,28,30,32,
        34,36,38,40,42,0,6,1,0,3,5,1,0,23,24,2,0,11,12,21,22,1,0,13,18,1,
        0,19,20,1,0,21,25,215,0,48,1,0,0,0,2,50,1,0,0,0,4,63,1,0,0,0,6,70,
        1,0,0,0,8,83,1,0,0,0,10,95,1,0,0,0,12,97,1,0,0,0,14,110,1,0,0,0,
        16,113,1,0,0,0,18,119,1,0,0,0,20,128,1,0,0,0,22,138,1,0,0,0,24,153,
        1,0,0,0,26,158,1,0,0,0,28,167,1,0,0,0,30,181,1,0,0,0,32,183,1,0,
        0,0,34,190,1,0,0,0,36,194,1,0,0,0,38,196,1,0,0,0,40,201,1,0,0,0,
        42,203,1,0,0,0,44,49,3,18,9,0,45,49,3,2,1,0,46,49,3,4,2,0,47,49,
        3,40,20,0,48,44,1,0,0,0,48,45,1,0,0,0,48,46,1,0,0,0,48,47,1,0,0,
        0,49,1,1,0,0,0,50,51,5,1,0,0,51,52,5,26,0,0,52,53,3,16,8,0,53,54,
        5,33,0,0,54,55,3,40,20,0,55,56,5,33,0,0,56,59,3,6,3,0,57,58,5,33,
        0,0,58,60,3,6,3,0,59,57,1,0,0,0,59,60,1,0,0,0,60,61,1,0,0,0,61,62,
        5,27,0,0,62,3,1,0,0,0,63,64,5,2,0,0,64,65,5,26,0,0,65,66,3,40,20,
        0,66,67,5,33,0,0,67,68,3,6,3,0,68,69,5,27,0,0,69,5,1,0,0,0,70,79,
        5,36,0,0,71,76,3,8,4,0,72,73,5,33,0,0,73,75,3,8,4,0,74,72,1,0,0,
        0,75,78,1,0,0,0,76,74,1,0,0,0,76,77,1,0,0,0,77,80,1,0,0,0,78,76,
        1,0,0,0,79,71,1,0,0,0,79,80,1,0,0,0,80,81,1,0,0,0,81,82,5,37,0,0,
        82,7,1,0,0,0,83,84,5,26,0,0,84,85,3,40,20,0,85,86,5,33,0,0,86,87,
        3,16,8,0,87,88,5,27,0,0,88,9,1,0,0,0,89,96,3,42,21,0,90,96,5,3,0,
        0,91,96,5,4,0,0,92,96,5,5,0,0,93,96,5,1,0,0,94,96,5,2,0,0,95,89,
        1,0,0,0,95,90,1,0,0,0,95,91,1,0,0,0,95,92,1,0,0,0,95,93,1,0,0,0,
        95,94,1,0,0,0,96,11,1,0,0,0,97,103,3,14,7,0,98,99,3,36,18,0,99,100,
        3,14,7,0,100,102,1,0,0,0,101,98,1,0,0,0,102,105,1,0,0,0,103,101,
        1,0,0,0,103,104,1,0,0,0,104,13,1,0,0,0,105,103,1,0,0,0,106,111,3,
        38,19,0,107,111,3,16,8,0,108,111,3,0,0,0,109,111,3,30,15,0,110,106,
        1,0,0,0,110,107,1,0,0,0,110,108,1,0,0,0,110,109,1,0,0,0,111,15,1,
        0,0,0,112,114,5,29,0,0,113,112,1,0,0,0,113,114,1,0,0,0,114,115,1,
        0,0,0,115,117,5,38,0,0,116,118,5,32,0,0,117,116,1,0,0,0,117,118,
        1,0,0,0,118,17,1,0,0,0,119,120,7,0,0,0,120,121,5,26,0,0,121,124,
        3,40,20,0,122,123,5,33,0,0,123,125,3,40,20,0,124,122,1,0,0,0,124,
        125,1,0,0,0,125,126,1,0,0,0,126,127,5,27,0,0,127,19,1,0,0,0,128,
        133,3,22,11,0,129,130,5,33,0,0,130,132,3,22,11,0,131,129,1,0,0,0,
        132,135,1,0,0,0,133,131,1,0,0,0,133,134,1,0,0,0,134,136,1,0,0,0,
        135,133,1,0,0,0,136,137,5,0,0,1,137,21,1,0,0,0,138,144,3,26,13,0,
        139,140,3,24,12,0,140,141,3,26,13,0,141,143,1,0,0,0,142,139,1,0,
        0,0,143,146,1,0,0,0,144,142,1,0,0,0,144,145,1,0,0,0,145,23,1,0,0,
        0,146,144,1,0,0,0,147,154,5,6,0,0,148,154,5,7,0,0,149,154,5,9,0,
        0,150,154,5,10,0,0,151,152,7,1,0,0,152,154,3,32,16,0,153,147,1,0,
        0,0,153,148,1,0,0,0,153,149,1,0,0,0,153,150,1,0,0,0,153,151,1,0,
        0,0,154,25,1,0,0,0,155,157,3,28,14,0,156,155,1,0,0,0,157,160,1,0,
        0,0,158,159,1,0,0,0,158,156,1,0,0,0,159,161,1,0,0,0,160,158,1,0,
        0,0,161,162,3,12,6,0,162,27,1,0,0,0,163,168,5,8,0,0,164,168,5,25,
        0,0,165,166,7,2,0,0,166,168,3,32,16,0,167,163,1,0,0,0,167,164,1,
        0,0,0,167,165,1,0,0,0,168,29,1,0,0,0,169,182,5,43,0,0,170,171,5,
        26,0,0,171,176,3,22,11,0,172,173,5,33,0,0,173,175,3,22,11,0,174,
        172,1,0,0,0,175,178,1,0,0,0,176,174,1,0,0,0,176,177,1,0,0,0,177,
        179,1,0,0,0,178,176,1,0,0,0,179,180,5,27,0,0,180,182,1,0,0,0,181,
        169,1,0,0,0,181,170,1,0,0,0,182,31,1,0,0,0,183,184,5,34,0,0,184,
        185,3,34,17,0,185,186,5,33,0,0,186,187,3,34,17,0,187,188,5,35,0,
        0,188,33,1,0,0,0,189,191,5,29,0,0,190,189,1,0,0,0,190,191,1,0,0,
        0,191,192,1,0,0,0,192,193,5,38,0,0,193,35,1,0,0,0,194,195,7,3,0,
        0,195,37,1,0,0,0,196,197,7,4,0,0,197,39,1,0,0,0,198,202,5,39,0,0,
        199,202,5,40,0,0,200,202,3,10,5,0,201,198,1,0,0,0,201,199,1,0,0,
        0,201,200,1,0,0,0,202,41,1,0,0,0,203,204,7,5,0,0,204,43,1,0,0,0,
        19,48,59,76,79,95,103,110,113,117,124,133,144,153,158,167,176,181,
        190,201
    ]

class catlParser ( Parser ):

    grammarFileName = "catl.g4"

    atn = ATNDeserializer().deserialize(serializedATN())

    decisionsToDFA = [ DFA(ds, i) for i, ds in enumerate(atn.decisionToState) ]

    sharedContextCache = PredictionContextCache()

    literalNames = [ "<INVALID>", "'T'", "'L'", "'sum'", "'min'", "'max'", 
                     "<INVALID>", "<INVALID>", "<INVALID>", "<INVALID>", 
                     "<INVALID>", "'<>'", "'[]'", "'>='", "'<='", "'>'", 
                     "'<'", "<INVALID>", "'!='", "<INVALID>", "<INVALID>", 
                     "'F'", "'G'", "'U'", "'R'", "'X'", "'('", "')'", "'+'", 
                     "'-'", "'*'", "'/'", "'%'", "','", "'['", "']'", "'{'", 
                     "'}'" ]

    symbolicNames = [ "<INVALID>", "TASK", "LIMIT", "SUM", "MIN", "MAX", 
                      "AND", "OR", "NOT", "IMPLIES", "IFF", "DIAMOND", "BOX", 
                      "GE", "LE", "GT", "LT", "EQ", "NE", "TRUE", "FALSE", 
                      "EVENTUALLY", "ALWAYS", "UNTIL", "RELEASE", "NEXT", 
                      "OPEN", "CLOSE", "PLUS", "MINUS", "STAR", "SLASH", 
                      "PERCENT", "COMMA", "LBRACKET", "RBRACKET", "LBRACE", 
                      "RBRACE", "NUMBER", "NAME", "STRING", "SPACE", "STRAY", 
                      "GROUP" ]

    RULE_atom = 0
    RULE_task = 1
    RULE_limit = 2
    RULE_pairs = 3
    RULE_pair = 4
    RULE_reserved = 5
    RULE_comparison = 6
    RULE_operand = 7
    RULE_number = 8
    RULE_count = 9
    RULE_formula = 10
    RULE_level = 11
    RULE_connective = 12
    RULE_unary = 13
    RULE_prefix = 14
    RULE_parts = 15
    RULE_interval = 16
    RULE_bound = 17
    RULE_relation = 18
    RULE_constant = 19
    RULE_name = 20
    RULE_letter = 21

    ruleNames =  [ "atom", "task", "limit", "pairs", "pair", "reserved", 
                   "comparison", "operand", "number", "count", "formula", 
                   "level", "connective", "unary", "prefix", "parts", "interval", 
                   "bound", "relation", "constant", "name", "letter" ]

    EOF = Token.EOF
    TASK=1
    LIMIT=2
    SUM=3
    MIN=4
    MAX=5
    AND=6
    OR=7
    NOT=8
    IMPLIES=9
    IFF=10
    DIAMOND=11
    BOX=12
    GE=13
    LE=14
    GT=15
    LT=16
    EQ=17
    NE=18
    TRUE=19
    FALSE=20
    EVENTUALLY=21
    ALWAYS=22
    UNTIL=23
    RELEASE=24
    NEXT=25
    OPEN=26
    CLOSE=27
    PLUS=28
    MINUS=29
    STAR=30
    SLASH=31
    PERCENT=32
    COMMA=33
    LBRACKET=34
    RBRACKET=35
    LBRACE=36
    RBRACE=37
    NUMBER=38
    NAME=39
    STRING=40
    SPACE=41
    STRAY=42
    GROUP=43

    def __init__(self, input:TokenStream, output:TextIO = sys.stdout):
        super().__init__(input, output)
        self.checkVersion("4.13.1")
        self._interp = ParserATNSimulator(self, self.atn, self.decisionsToDFA, self.sharedContextCache)
        self._predicates = None




    class AtomContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def count(self):
            return self.getTypedRuleContext(catlParser.CountContext,0)


        def task(self):
            return self.getTypedRuleContext(catlParser.TaskContext,0)


        def limit(self):
            return self.getTypedRuleContext(catlParser.LimitContext,0)


        def name(self):
            return self.getTypedRuleContext(catlParser.NameContext,0)


        def getRuleIndex(self):
            return catlParser.RULE_atom




    def atom(self):

        localctx = catlParser.AtomContext(self, self._ctx, self.state)
        self.enterRule(localctx, 0, self.RULE_atom)
        try:
            self.state = 48
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,0,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 44
                self.count()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 45
                self.task()
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 46
                self.limit()
                pass

            elif la_ == 4:
                self.enterOuterAlt(localctx, 4)
                self.state = 47
                self.name()
                pass


        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class TaskContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def TASK(self):
            return self.getToken(catlParser.TASK, 0)

        def OPEN(self):
            return self.getToken(catlParser.OPEN, 0)

        def number(self):
            return self.getTypedRuleContext(catlParser.NumberContext,0)


        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(catlParser.COMMA)
            else:
                return self.getToken(catlParser.COMMA, i)

        def name(self):
            return self.getTypedRuleContext(catlParser.NameContext,0)


        def pairs(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.PairsContext)
            else:
                return self.getTypedRuleContext(catlParser.PairsContext,i)


        def CLOSE(self):
            return self.getToken(catlParser.CLOSE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_task




    def task(self):

        localctx = catlParser.TaskContext(self, self._ctx, self.state)
        self.enterRule(localctx, 2, self.RULE_task)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 50
            self.match(catlParser.TASK)
            self.state = 51
            self.match(catlParser.OPEN)
            self.state = 52
            self.number()
            self.state = 53
            self.match(catlParser.COMMA)
            self.state = 54
            self.name()
            self.state = 55
            self.match(catlParser.COMMA)
            self.state = 56
            self.pairs()
            self.state = 59
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==33:
                self.state = 57
                self.match(catlParser.COMMA)
                self.state = 58
                self.pairs()


            self.state = 61
            self.match(catlParser.CLOSE)
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class LimitContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def LIMIT(self):
            return self.getToken(catlParser.LIMIT, 0)

        def OPEN(self):
            return self.getToken(catlParser.OPEN, 0)

        def name(self):
            return self.getTypedRuleContext(catlParser.NameContext,0)


        def COMMA(self):
            return self.getToken(catlParser.COMMA, 0)

        def pairs(self):
            return self.getTypedRuleContext(catlParser.PairsContext,0)


        def CLOSE(self):
            return self.getToken(catlParser.CLOSE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_limit




    def limit(self):

        localctx = catlParser.LimitContext(self, self._ctx, self.state)
        self.enterRule(localctx, 4, self.RULE_limit)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 63
            self.match(catlParser.LIMIT)
            self.state = 64
            self.match(catlParser.OPEN)
            self.state = 65
            self.name()
            self.state = 66
            self.match(catlParser.COMMA)
            self.state = 67
            self.pairs()
            self.state = 68
            self.match(catlParser.CLOSE)
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class PairsContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def LBRACE(self):
            return self.getToken(catlParser.LBRACE, 0)

        def RBRACE(self):
            return self.getToken(catlParser.RBRACE, 0)

        def pair(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.PairContext)
            else:
                return self.getTypedRuleContext(catlParser.PairContext,i)


        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(catlParser.COMMA)
            else:
                return self.getToken(catlParser.COMMA, i)

        def getRuleIndex(self):
            return catlParser.RULE_pairs




    def pairs(self):

        localctx = catlParser.PairsContext(self, self._ctx, self.state)
        self.enterRule(localctx, 6, self.RULE_pairs)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 70
            self.match(catlParser.LBRACE)
            self.state = 79
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==26:
                self.state = 71
                self.pair()
                self.state = 76
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==33:
                    self.state = 72
                    self.match(catlParser.COMMA)
                    self.state = 73
                    self.pair()
                    self.state = 78
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)



            self.state = 81
            self.match(catlParser.RBRACE)
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class PairContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def OPEN(self):
            return self.getToken(catlParser.OPEN, 0)

        def name(self):
            return self.getTypedRuleContext(catlParser.NameContext,0)


        def COMMA(self):
            return self.getToken(catlParser.COMMA, 0)

        def number(self):
            return self.getTypedRuleContext(catlParser.NumberContext,0)


        def CLOSE(self):
            return self.getToken(catlParser.CLOSE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_pair




    def pair(self):

        localctx = catlParser.PairContext(self, self._ctx, self.state)
        self.enterRule(localctx, 8, self.RULE_pair)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 83
            self.match(catlParser.OPEN)
            self.state = 84
            self.name()
            self.state = 85
            self.match(catlParser.COMMA)
            self.state = 86
            self.number()
            self.state = 87
            self.match(catlParser.CLOSE)
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class ReservedContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def letter(self):
            return self.getTypedRuleContext(catlParser.LetterContext,0)


        def SUM(self):
            return self.getToken(catlParser.SUM, 0)

        def MIN(self):
            return self.getToken(catlParser.MIN, 0)

        def MAX(self):
            return self.getToken(catlParser.MAX, 0)

        def TASK(self):
            return self.getToken(catlParser.TASK, 0)

        def LIMIT(self):
            return self.getToken(catlParser.LIMIT, 0)

        def getRuleIndex(self):
            return catlParser.RULE_reserved




    def reserved(self):

        localctx = catlParser.ReservedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 10, self.RULE_reserved)
        try:
            self.state = 95
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [21, 22, 23, 24, 25]:
                self.enterOuterAlt(localctx, 1)
                self.state = 89
                self.letter()
                pass
            elif token in [3]:
                self.enterOuterAlt(localctx, 2)
                self.state = 90
                self.match(catlParser.SUM)
                pass
            elif token in [4]:
                self.enterOuterAlt(localctx, 3)
                self.state = 91
                self.match(catlParser.MIN)
                pass
            elif token in [5]:
                self.enterOuterAlt(localctx, 4)
                self.state = 92
                self.match(catlParser.MAX)
                pass
            elif token in [1]:
                self.enterOuterAlt(localctx, 5)
                self.state = 93
                self.match(catlParser.TASK)
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 6)
                self.state = 94
                self.match(catlParser.LIMIT)
                pass
            else:
                raise NoViableAltException(self)

        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class ComparisonContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def operand(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.OperandContext)
            else:
                return self.getTypedRuleContext(catlParser.OperandContext,i)


        def relation(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.RelationContext)
            else:
                return self.getTypedRuleContext(catlParser.RelationContext,i)


        def getRuleIndex(self):
            return catlParser.RULE_comparison




    def comparison(self):

        localctx = catlParser.ComparisonContext(self, self._ctx, self.state)
        self.enterRule(localctx, 12, self.RULE_comparison)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 97
            self.operand()
            self.state = 103
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 516096) != 0):
                self.state = 98
                self.relation()
                self.state = 99
                self.operand()
                self.state = 105
                self._errHandler.sync(self)
                _la = self._input.LA(1)

        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class OperandContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def constant(self):
            return self.getTypedRuleContext(catlParser.ConstantContext,0)


        def number(self):
            return self.getTypedRuleContext(catlParser.NumberContext,0)


        def atom(self):
            return self.getTypedRuleContext(catlParser.AtomContext,0)


        def parts(self):
            return self.getTypedRuleContext(catlParser.PartsContext,0)


        def getRuleIndex(self):
            return catlParser.RULE_operand




    def operand(self):

        localctx = catlParser.OperandContext(self, self._ctx, self.state)
        self.enterRule(localctx, 14, self.RULE_operand)
        try:
            self.state = 110
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [19, 20]:
                self.enterOuterAlt(localctx, 1)
                self.state = 106
                self.constant()
                pass
            elif token in [29, 38]:
                self.enterOuterAlt(localctx, 2)
                self.state = 107
                self.number()
                pass
            elif token in [1, 2, 3, 4, 5, 21, 22, 23, 24, 25, 39, 40]:
                self.enterOuterAlt(localctx, 3)
                self.state = 108
                self.atom()
                pass
            elif token in [26, 43]:
                self.enterOuterAlt(localctx, 4)
                self.state = 109
                self.parts()
                pass
            else:
                raise NoViableAltException(self)

        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class NumberContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def NUMBER(self):
            return self.getToken(catlParser.NUMBER, 0)

        def MINUS(self):
            return self.getToken(catlParser.MINUS, 0)

        def PERCENT(self):
            return self.getToken(catlParser.PERCENT, 0)

        def getRuleIndex(self):
            return catlParser.RULE_number




    def number(self):

        localctx = catlParser.NumberContext(self, self._ctx, self.state)
        self.enterRule(localctx, 16, self.RULE_number)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 113
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==29:
                self.state = 112
                self.match(catlParser.MINUS)


            self.state = 115
            self.match(catlParser.NUMBER)
            self.state = 117
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==32:
                self.state = 116
                self.match(catlParser.PERCENT)


        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class CountContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def OPEN(self):
            return self.getToken(catlParser.OPEN, 0)

        def name(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.NameContext)
            else:
                return self.getTypedRuleContext(catlParser.NameContext,i)


        def CLOSE(self):
            return self.getToken(catlParser.CLOSE, 0)

        def SUM(self):
            return self.getToken(catlParser.SUM, 0)

        def MIN(self):
            return self.getToken(catlParser.MIN, 0)

        def MAX(self):
            return self.getToken(catlParser.MAX, 0)

        def COMMA(self):
            return self.getToken(catlParser.COMMA, 0)

        def getRuleIndex(self):
            return catlParser.RULE_count




    def count(self):

        localctx = catlParser.CountContext(self, self._ctx, self.state)
        self.enterRule(localctx, 18, self.RULE_count)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 119
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 56) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 120
            self.match(catlParser.OPEN)
            self.state = 121
            self.name()
            self.state = 124
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==33:
                self.state = 122
                self.match(catlParser.COMMA)
                self.state = 123
                self.name()


            self.state = 126
            self.match(catlParser.CLOSE)
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class FormulaContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def level(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.LevelContext)
            else:
                return self.getTypedRuleContext(catlParser.LevelContext,i)


        def EOF(self):
            return self.getToken(catlParser.EOF, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(catlParser.COMMA)
            else:
                return self.getToken(catlParser.COMMA, i)

        def getRuleIndex(self):
            return catlParser.RULE_formula




    def formula(self):

        localctx = catlParser.FormulaContext(self, self._ctx, self.state)
        self.enterRule(localctx, 20, self.RULE_formula)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 128
            self.level()
            self.state = 133
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==33:
                self.state = 129
                self.match(catlParser.COMMA)
                self.state = 130
                self.level()
                self.state = 135
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 136
            self.match(catlParser.EOF)
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class LevelContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def unary(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.UnaryContext)
            else:
                return self.getTypedRuleContext(catlParser.UnaryContext,i)


        def connective(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.ConnectiveContext)
            else:
                return self.getTypedRuleContext(catlParser.ConnectiveContext,i)


        def getRuleIndex(self):
            return catlParser.RULE_level




    def level(self):

        localctx = catlParser.LevelContext(self, self._ctx, self.state)
        self.enterRule(localctx, 22, self.RULE_level)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 138
            self.unary()
            self.state = 144
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 25167552) != 0):
                self.state = 139
                self.connective()
                self.state = 140
                self.unary()
                self.state = 146
                self._errHandler.sync(self)
                _la = self._input.LA(1)

        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class ConnectiveContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def AND(self):
            return self.getToken(catlParser.AND, 0)

        def OR(self):
            return self.getToken(catlParser.OR, 0)

        def IMPLIES(self):
            return self.getToken(catlParser.IMPLIES, 0)

        def IFF(self):
            return self.getToken(catlParser.IFF, 0)

        def interval(self):
            return self.getTypedRuleContext(catlParser.IntervalContext,0)


        def UNTIL(self):
            return self.getToken(catlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(catlParser.RELEASE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_connective




    def connective(self):

        localctx = catlParser.ConnectiveContext(self, self._ctx, self.state)
        self.enterRule(localctx, 24, self.RULE_connective)
        self._la = 0 # Token type
        try:
            self.state = 153
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [6]:
                self.enterOuterAlt(localctx, 1)
                self.state = 147
                self.match(catlParser.AND)
                pass
            elif token in [7]:
                self.enterOuterAlt(localctx, 2)
                self.state = 148
                self.match(catlParser.OR)
                pass
            elif token in [9]:
                self.enterOuterAlt(localctx, 3)
                self.state = 149
                self.match(catlParser.IMPLIES)
                pass
            elif token in [10]:
                self.enterOuterAlt(localctx, 4)
                self.state = 150
                self.match(catlParser.IFF)
                pass
            elif token in [23, 24]:
                self.enterOuterAlt(localctx, 5)
                self.state = 151
                _la = self._input.LA(1)
                if not(_la==23 or _la==24):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 152
                self.interval()
                pass
            else:
                raise NoViableAltException(self)

        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class UnaryContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def comparison(self):
            return self.getTypedRuleContext(catlParser.ComparisonContext,0)


        def prefix(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.PrefixContext)
            else:
                return self.getTypedRuleContext(catlParser.PrefixContext,i)


        def getRuleIndex(self):
            return catlParser.RULE_unary




    def unary(self):

        localctx = catlParser.UnaryContext(self, self._ctx, self.state)
        self.enterRule(localctx, 26, self.RULE_unary)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 158
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,13,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 155
                    self.prefix() 
                self.state = 160
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,13,self._ctx)

            self.state = 161
            self.comparison()
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class PrefixContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def NOT(self):
            return self.getToken(catlParser.NOT, 0)

        def NEXT(self):
            return self.getToken(catlParser.NEXT, 0)

        def interval(self):
            return self.getTypedRuleContext(catlParser.IntervalContext,0)


        def EVENTUALLY(self):
            return self.getToken(catlParser.EVENTUALLY, 0)

        def DIAMOND(self):
            return self.getToken(catlParser.DIAMOND, 0)

        def ALWAYS(self):
            return self.getToken(catlParser.ALWAYS, 0)

        def BOX(self):
            return self.getToken(catlParser.BOX, 0)

        def getRuleIndex(self):
            return catlParser.RULE_prefix




    def prefix(self):

        localctx = catlParser.PrefixContext(self, self._ctx, self.state)
        self.enterRule(localctx, 28, self.RULE_prefix)
        self._la = 0 # Token type
        try:
            self.state = 167
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [8]:
                self.enterOuterAlt(localctx, 1)
                self.state = 163
                self.match(catlParser.NOT)
                pass
            elif token in [25]:
                self.enterOuterAlt(localctx, 2)
                self.state = 164
                self.match(catlParser.NEXT)
                pass
            elif token in [11, 12, 21, 22]:
                self.enterOuterAlt(localctx, 3)
                self.state = 165
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 6297600) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 166
                self.interval()
                pass
            else:
                raise NoViableAltException(self)

        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class PartsContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def GROUP(self):
            return self.getToken(catlParser.GROUP, 0)

        def OPEN(self):
            return self.getToken(catlParser.OPEN, 0)

        def level(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.LevelContext)
            else:
                return self.getTypedRuleContext(catlParser.LevelContext,i)


        def CLOSE(self):
            return self.getToken(catlParser.CLOSE, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(catlParser.COMMA)
            else:
                return self.getToken(catlParser.COMMA, i)

        def getRuleIndex(self):
            return catlParser.RULE_parts




    def parts(self):

        localctx = catlParser.PartsContext(self, self._ctx, self.state)
        self.enterRule(localctx, 30, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 181
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [43]:
                self.enterOuterAlt(localctx, 1)
                self.state = 169
                self.match(catlParser.GROUP)
                pass
            elif token in [26]:
                self.enterOuterAlt(localctx, 2)
                self.state = 170
                self.match(catlParser.OPEN)
                self.state = 171
                self.level()
                self.state = 176
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==33:
                    self.state = 172
                    self.match(catlParser.COMMA)
                    self.state = 173
                    self.level()
                    self.state = 178
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 179
                self.match(catlParser.CLOSE)
                pass
            else:
                raise NoViableAltException(self)

        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class IntervalContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def LBRACKET(self):
            return self.getToken(catlParser.LBRACKET, 0)

        def bound(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.BoundContext)
            else:
                return self.getTypedRuleContext(catlParser.BoundContext,i)


        def COMMA(self):
            return self.getToken(catlParser.COMMA, 0)

        def RBRACKET(self):
            return self.getToken(catlParser.RBRACKET, 0)

        def getRuleIndex(self):
            return catlParser.RULE_interval




    def interval(self):

        localctx = catlParser.IntervalContext(self, self._ctx, self.state)
        self.enterRule(localctx, 32, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 183
            self.match(catlParser.LBRACKET)
            self.state = 184
            self.bound()
            self.state = 185
            self.match(catlParser.COMMA)
            self.state = 186
            self.bound()
            self.state = 187
            self.match(catlParser.RBRACKET)
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class BoundContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def NUMBER(self):
            return self.getToken(catlParser.NUMBER, 0)

        def MINUS(self):
            return self.getToken(catlParser.MINUS, 0)

        def getRuleIndex(self):
            return catlParser.RULE_bound




    def bound(self):

        localctx = catlParser.BoundContext(self, self._ctx, self.state)
        self.enterRule(localctx, 34, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 190
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==29:
                self.state = 189
                self.match(catlParser.MINUS)


            self.state = 192
            self.match(catlParser.NUMBER)
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class RelationContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def GE(self):
            return self.getToken(catlParser.GE, 0)

        def LE(self):
            return self.getToken(catlParser.LE, 0)

        def GT(self):
            return self.getToken(catlParser.GT, 0)

        def LT(self):
            return self.getToken(catlParser.LT, 0)

        def EQ(self):
            return self.getToken(catlParser.EQ, 0)

        def NE(self):
            return self.getToken(catlParser.NE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_relation




    def relation(self):

        localctx = catlParser.RelationContext(self, self._ctx, self.state)
        self.enterRule(localctx, 36, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 194
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 516096) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class ConstantContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def TRUE(self):
            return self.getToken(catlParser.TRUE, 0)

        def FALSE(self):
            return self.getToken(catlParser.FALSE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_constant




    def constant(self):

        localctx = catlParser.ConstantContext(self, self._ctx, self.state)
        self.enterRule(localctx, 38, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 196
            _la = self._input.LA(1)
            if not(_la==19 or _la==20):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class NameContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def NAME(self):
            return self.getToken(catlParser.NAME, 0)

        def STRING(self):
            return self.getToken(catlParser.STRING, 0)

        def reserved(self):
            return self.getTypedRuleContext(catlParser.ReservedContext,0)


        def getRuleIndex(self):
            return catlParser.RULE_name




    def name(self):

        localctx = catlParser.NameContext(self, self._ctx, self.state)
        self.enterRule(localctx, 40, self.RULE_name)
        try:
            self.state = 201
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [39]:
                self.enterOuterAlt(localctx, 1)
                self.state = 198
                self.match(catlParser.NAME)
                pass
            elif token in [40]:
                self.enterOuterAlt(localctx, 2)
                self.state = 199
                self.match(catlParser.STRING)
                pass
            elif token in [1, 2, 3, 4, 5, 21, 22, 23, 24, 25]:
                self.enterOuterAlt(localctx, 3)
                self.state = 200
                self.reserved()
                pass
            else:
                raise NoViableAltException(self)

        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class LetterContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def EVENTUALLY(self):
            return self.getToken(catlParser.EVENTUALLY, 0)

        def ALWAYS(self):
            return self.getToken(catlParser.ALWAYS, 0)

        def UNTIL(self):
            return self.getToken(catlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(catlParser.RELEASE, 0)

        def NEXT(self):
            return self.getToken(catlParser.NEXT, 0)

        def getRuleIndex(self):
            return catlParser.RULE_letter




    def letter(self):

        localctx = catlParser.LetterContext(self, self._ctx, self.state)
        self.enterRule(localctx, 42, self.RULE_letter)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 203
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 65011712) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx





