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
        4,1,43,187,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,2,19,7,19,2,20,
        7,20,1,0,1,0,1,0,1,0,3,0,47,8,0,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,
        1,1,3,1,58,8,1,1,1,1,1,1,2,1,2,1,2,1,2,1,2,1,2,1,2,1,3,1,3,1,3,1,
        3,5,3,73,8,3,10,3,12,3,76,9,3,3,3,78,8,3,1,3,1,3,1,4,1,4,1,4,1,4,
        1,4,1,4,1,5,1,5,1,5,1,5,1,5,1,5,3,5,94,8,5,1,6,1,6,1,6,1,6,5,6,100,
        8,6,10,6,12,6,103,9,6,1,7,1,7,1,7,1,7,1,7,1,7,1,7,1,7,3,7,113,8,
        7,1,8,3,8,116,8,8,1,8,1,8,3,8,120,8,8,1,9,1,9,1,9,1,9,1,9,3,9,127,
        8,9,1,9,1,9,1,10,1,10,1,10,1,11,1,11,1,11,1,11,5,11,138,8,11,10,
        11,12,11,141,9,11,1,12,1,12,1,12,1,12,1,12,1,12,3,12,149,8,12,1,
        13,5,13,152,8,13,10,13,12,13,155,9,13,1,13,1,13,1,14,1,14,1,14,1,
        14,3,14,163,8,14,1,15,1,15,1,15,1,15,1,15,1,15,1,16,3,16,172,8,16,
        1,16,1,16,1,17,1,17,1,18,1,18,1,19,1,19,1,19,3,19,183,8,19,1,20,
        1,20,1,20,1,153,0,21,0,2,4,6,8,10,12,14,16,18,20,22,24,26,28,30,
        32,34,36,38,40,0,6,1,0,3,5,1,0,23,24,2,0,11,12,21,22,1,0,13,18,1,
        0,19,20,1,0,21,25,195,0,46,1,0,0,0,2,48,1,0,0,0,4,61,1,0,0,0,6,68,
        1,0,0,0,8,81,1,0,0,0,10,93,1,0,0,0,12,95,1,0,0,0,14,112,1,0,0,0,
        16,115,1,0,0,0,18,121,1,0,0,0,20,130,1,0,0,0,22,133,1,0,0,0,24,148,
        1,0,0,0,26,153,1,0,0,0,28,162,1,0,0,0,30,164,1,0,0,0,32,171,1,0,
        0,0,34,175,1,0,0,0,36,177,1,0,0,0,38,182,1,0,0,0,40,184,1,0,0,0,
        42,47,3,18,9,0,43,47,3,2,1,0,44,47,3,4,2,0,45,47,3,38,19,0,46,42,
        1,0,0,0,46,43,1,0,0,0,46,44,1,0,0,0,46,45,1,0,0,0,47,1,1,0,0,0,48,
        49,5,1,0,0,49,50,5,26,0,0,50,51,3,16,8,0,51,52,5,33,0,0,52,53,3,
        38,19,0,53,54,5,33,0,0,54,57,3,6,3,0,55,56,5,33,0,0,56,58,3,6,3,
        0,57,55,1,0,0,0,57,58,1,0,0,0,58,59,1,0,0,0,59,60,5,27,0,0,60,3,
        1,0,0,0,61,62,5,2,0,0,62,63,5,26,0,0,63,64,3,38,19,0,64,65,5,33,
        0,0,65,66,3,6,3,0,66,67,5,27,0,0,67,5,1,0,0,0,68,77,5,36,0,0,69,
        74,3,8,4,0,70,71,5,33,0,0,71,73,3,8,4,0,72,70,1,0,0,0,73,76,1,0,
        0,0,74,72,1,0,0,0,74,75,1,0,0,0,75,78,1,0,0,0,76,74,1,0,0,0,77,69,
        1,0,0,0,77,78,1,0,0,0,78,79,1,0,0,0,79,80,5,37,0,0,80,7,1,0,0,0,
        81,82,5,26,0,0,82,83,3,38,19,0,83,84,5,33,0,0,84,85,3,16,8,0,85,
        86,5,27,0,0,86,9,1,0,0,0,87,94,3,40,20,0,88,94,5,3,0,0,89,94,5,4,
        0,0,90,94,5,5,0,0,91,94,5,1,0,0,92,94,5,2,0,0,93,87,1,0,0,0,93,88,
        1,0,0,0,93,89,1,0,0,0,93,90,1,0,0,0,93,91,1,0,0,0,93,92,1,0,0,0,
        94,11,1,0,0,0,95,101,3,14,7,0,96,97,3,34,17,0,97,98,3,14,7,0,98,
        100,1,0,0,0,99,96,1,0,0,0,100,103,1,0,0,0,101,99,1,0,0,0,101,102,
        1,0,0,0,102,13,1,0,0,0,103,101,1,0,0,0,104,113,3,36,18,0,105,113,
        3,16,8,0,106,113,3,0,0,0,107,113,5,43,0,0,108,109,5,26,0,0,109,110,
        3,22,11,0,110,111,5,27,0,0,111,113,1,0,0,0,112,104,1,0,0,0,112,105,
        1,0,0,0,112,106,1,0,0,0,112,107,1,0,0,0,112,108,1,0,0,0,113,15,1,
        0,0,0,114,116,5,29,0,0,115,114,1,0,0,0,115,116,1,0,0,0,116,117,1,
        0,0,0,117,119,5,38,0,0,118,120,5,32,0,0,119,118,1,0,0,0,119,120,
        1,0,0,0,120,17,1,0,0,0,121,122,7,0,0,0,122,123,5,26,0,0,123,126,
        3,38,19,0,124,125,5,33,0,0,125,127,3,38,19,0,126,124,1,0,0,0,126,
        127,1,0,0,0,127,128,1,0,0,0,128,129,5,27,0,0,129,19,1,0,0,0,130,
        131,3,22,11,0,131,132,5,0,0,1,132,21,1,0,0,0,133,139,3,26,13,0,134,
        135,3,24,12,0,135,136,3,26,13,0,136,138,1,0,0,0,137,134,1,0,0,0,
        138,141,1,0,0,0,139,137,1,0,0,0,139,140,1,0,0,0,140,23,1,0,0,0,141,
        139,1,0,0,0,142,149,5,6,0,0,143,149,5,7,0,0,144,149,5,9,0,0,145,
        149,5,10,0,0,146,147,7,1,0,0,147,149,3,30,15,0,148,142,1,0,0,0,148,
        143,1,0,0,0,148,144,1,0,0,0,148,145,1,0,0,0,148,146,1,0,0,0,149,
        25,1,0,0,0,150,152,3,28,14,0,151,150,1,0,0,0,152,155,1,0,0,0,153,
        154,1,0,0,0,153,151,1,0,0,0,154,156,1,0,0,0,155,153,1,0,0,0,156,
        157,3,12,6,0,157,27,1,0,0,0,158,163,5,8,0,0,159,163,5,25,0,0,160,
        161,7,2,0,0,161,163,3,30,15,0,162,158,1,0,0,0,162,159,1,0,0,0,162,
        160,1,0,0,0,163,29,1,0,0,0,164,165,5,34,0,0,165,166,3,32,16,0,166,
        167,5,33,0,0,167,168,3,32,16,0,168,169,5,35,0,0,169,31,1,0,0,0,170,
        172,5,29,0,0,171,170,1,0,0,0,171,172,1,0,0,0,172,173,1,0,0,0,173,
        174,5,38,0,0,174,33,1,0,0,0,175,176,7,3,0,0,176,35,1,0,0,0,177,178,
        7,4,0,0,178,37,1,0,0,0,179,183,5,39,0,0,180,183,5,40,0,0,181,183,
        3,10,5,0,182,179,1,0,0,0,182,180,1,0,0,0,182,181,1,0,0,0,183,39,
        1,0,0,0,184,185,7,5,0,0,185,41,1,0,0,0,16,46,57,74,77,93,101,112,
        115,119,126,139,148,153,162,171,182
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
    RULE_interval = 15
    RULE_bound = 16
    RULE_relation = 17
    RULE_constant = 18
    RULE_name = 19
    RULE_letter = 20

    ruleNames =  [ "atom", "task", "limit", "pairs", "pair", "reserved", 
                   "comparison", "operand", "number", "count", "formula", 
                   "level", "connective", "unary", "prefix", "interval", 
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
            self.state = 46
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,0,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 42
                self.count()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 43
                self.task()
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 44
                self.limit()
                pass

            elif la_ == 4:
                self.enterOuterAlt(localctx, 4)
                self.state = 45
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
            self.state = 48
            self.match(catlParser.TASK)
            self.state = 49
            self.match(catlParser.OPEN)
            self.state = 50
            self.number()
            self.state = 51
            self.match(catlParser.COMMA)
            self.state = 52
            self.name()
            self.state = 53
            self.match(catlParser.COMMA)
            self.state = 54
            self.pairs()
            self.state = 57
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==33:
                self.state = 55
                self.match(catlParser.COMMA)
                self.state = 56
                self.pairs()


            self.state = 59
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
            self.state = 61
            self.match(catlParser.LIMIT)
            self.state = 62
            self.match(catlParser.OPEN)
            self.state = 63
            self.name()
            self.state = 64
            self.match(catlParser.COMMA)
            self.state = 65
            self.pairs()
            self.state = 66
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
            self.state = 68
            self.match(catlParser.LBRACE)
            self.state = 77
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==26:
                self.state = 69
                self.pair()
                self.state = 74
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==33:
                    self.state = 70
                    self.match(catlParser.COMMA)
                    self.state = 71
                    self.pair()
                    self.state = 76
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)



            self.state = 79
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
            self.state = 81
            self.match(catlParser.OPEN)
            self.state = 82
            self.name()
            self.state = 83
            self.match(catlParser.COMMA)
            self.state = 84
            self.number()
            self.state = 85
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
            self.state = 93
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [21, 22, 23, 24, 25]:
                self.enterOuterAlt(localctx, 1)
                self.state = 87
                self.letter()
                pass
            elif token in [3]:
                self.enterOuterAlt(localctx, 2)
                self.state = 88
                self.match(catlParser.SUM)
                pass
            elif token in [4]:
                self.enterOuterAlt(localctx, 3)
                self.state = 89
                self.match(catlParser.MIN)
                pass
            elif token in [5]:
                self.enterOuterAlt(localctx, 4)
                self.state = 90
                self.match(catlParser.MAX)
                pass
            elif token in [1]:
                self.enterOuterAlt(localctx, 5)
                self.state = 91
                self.match(catlParser.TASK)
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 6)
                self.state = 92
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
            self.state = 95
            self.operand()
            self.state = 101
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 516096) != 0):
                self.state = 96
                self.relation()
                self.state = 97
                self.operand()
                self.state = 103
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


        def GROUP(self):
            return self.getToken(catlParser.GROUP, 0)

        def OPEN(self):
            return self.getToken(catlParser.OPEN, 0)

        def level(self):
            return self.getTypedRuleContext(catlParser.LevelContext,0)


        def CLOSE(self):
            return self.getToken(catlParser.CLOSE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_operand




    def operand(self):

        localctx = catlParser.OperandContext(self, self._ctx, self.state)
        self.enterRule(localctx, 14, self.RULE_operand)
        try:
            self.state = 112
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [19, 20]:
                self.enterOuterAlt(localctx, 1)
                self.state = 104
                self.constant()
                pass
            elif token in [29, 38]:
                self.enterOuterAlt(localctx, 2)
                self.state = 105
                self.number()
                pass
            elif token in [1, 2, 3, 4, 5, 21, 22, 23, 24, 25, 39, 40]:
                self.enterOuterAlt(localctx, 3)
                self.state = 106
                self.atom()
                pass
            elif token in [43]:
                self.enterOuterAlt(localctx, 4)
                self.state = 107
                self.match(catlParser.GROUP)
                pass
            elif token in [26]:
                self.enterOuterAlt(localctx, 5)
                self.state = 108
                self.match(catlParser.OPEN)
                self.state = 109
                self.level()
                self.state = 110
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
            self.state = 115
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==29:
                self.state = 114
                self.match(catlParser.MINUS)


            self.state = 117
            self.match(catlParser.NUMBER)
            self.state = 119
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==32:
                self.state = 118
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
            self.state = 121
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 56) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 122
            self.match(catlParser.OPEN)
            self.state = 123
            self.name()
            self.state = 126
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==33:
                self.state = 124
                self.match(catlParser.COMMA)
                self.state = 125
                self.name()


            self.state = 128
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

        def level(self):
            return self.getTypedRuleContext(catlParser.LevelContext,0)


        def EOF(self):
            return self.getToken(catlParser.EOF, 0)

        def getRuleIndex(self):
            return catlParser.RULE_formula




    def formula(self):

        localctx = catlParser.FormulaContext(self, self._ctx, self.state)
        self.enterRule(localctx, 20, self.RULE_formula)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 130
            self.level()
            self.state = 131
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
            self.state = 133
            self.unary()
            self.state = 139
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 25167552) != 0):
                self.state = 134
                self.connective()
                self.state = 135
                self.unary()
                self.state = 141
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
            self.state = 148
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [6]:
                self.enterOuterAlt(localctx, 1)
                self.state = 142
                self.match(catlParser.AND)
                pass
            elif token in [7]:
                self.enterOuterAlt(localctx, 2)
                self.state = 143
                self.match(catlParser.OR)
                pass
            elif token in [9]:
                self.enterOuterAlt(localctx, 3)
                self.state = 144
                self.match(catlParser.IMPLIES)
                pass
            elif token in [10]:
                self.enterOuterAlt(localctx, 4)
                self.state = 145
                self.match(catlParser.IFF)
                pass
            elif token in [23, 24]:
                self.enterOuterAlt(localctx, 5)
                self.state = 146
                _la = self._input.LA(1)
                if not(_la==23 or _la==24):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 147
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
            self.state = 153
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,12,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 150
                    self.prefix() 
                self.state = 155
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,12,self._ctx)

            self.state = 156
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
            self.state = 162
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [8]:
                self.enterOuterAlt(localctx, 1)
                self.state = 158
                self.match(catlParser.NOT)
                pass
            elif token in [25]:
                self.enterOuterAlt(localctx, 2)
                self.state = 159
                self.match(catlParser.NEXT)
                pass
            elif token in [11, 12, 21, 22]:
                self.enterOuterAlt(localctx, 3)
                self.state = 160
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 6297600) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 161
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
        self.enterRule(localctx, 30, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 164
            self.match(catlParser.LBRACKET)
            self.state = 165
            self.bound()
            self.state = 166
            self.match(catlParser.COMMA)
            self.state = 167
            self.bound()
            self.state = 168
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
        self.enterRule(localctx, 32, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 171
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==29:
                self.state = 170
                self.match(catlParser.MINUS)


            self.state = 173
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
        self.enterRule(localctx, 34, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 175
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
        self.enterRule(localctx, 36, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 177
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
        self.enterRule(localctx, 38, self.RULE_name)
        try:
            self.state = 182
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [39]:
                self.enterOuterAlt(localctx, 1)
                self.state = 179
                self.match(catlParser.NAME)
                pass
            elif token in [40]:
                self.enterOuterAlt(localctx, 2)
                self.state = 180
                self.match(catlParser.STRING)
                pass
            elif token in [1, 2, 3, 4, 5, 21, 22, 23, 24, 25]:
                self.enterOuterAlt(localctx, 3)
                self.state = 181
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
        self.enterRule(localctx, 40, self.RULE_letter)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 184
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





