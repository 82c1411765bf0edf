# Generated from wmtl.g4 by ANTLR 4.13.1
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
        4,1,44,205,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,2,19,7,19,2,20,
        7,20,1,0,1,0,3,0,45,8,0,1,0,1,0,1,0,1,0,1,0,3,0,52,8,0,3,0,54,8,
        0,1,1,1,1,1,1,1,1,1,1,3,1,61,8,1,1,1,1,1,3,1,65,8,1,1,2,1,2,3,2,
        69,8,2,1,2,1,2,1,2,3,2,74,8,2,1,3,1,3,1,3,1,3,1,3,1,3,1,3,1,3,1,
        3,5,3,85,8,3,10,3,12,3,88,9,3,1,3,1,3,3,3,92,8,3,1,4,3,4,95,8,4,
        1,4,1,4,1,5,1,5,1,5,1,5,5,5,103,8,5,10,5,12,5,106,9,5,1,6,1,6,1,
        6,1,6,3,6,112,8,6,1,7,3,7,115,8,7,1,7,1,7,3,7,119,8,7,1,8,1,8,3,
        8,123,8,8,1,9,1,9,1,9,1,9,1,9,3,9,130,8,9,1,9,1,9,1,10,1,10,1,10,
        1,10,3,10,138,8,10,1,11,1,11,1,11,5,11,143,8,11,10,11,12,11,146,
        9,11,1,11,1,11,1,12,1,12,1,12,1,12,5,12,154,8,12,10,12,12,12,157,
        9,12,1,13,5,13,160,8,13,10,13,12,13,163,9,13,1,13,1,13,3,13,167,
        8,13,1,14,1,14,1,14,1,14,1,14,5,14,174,8,14,10,14,12,14,177,9,14,
        1,14,1,14,3,14,181,8,14,1,15,1,15,1,15,1,15,1,15,1,15,1,16,3,16,
        190,8,16,1,16,1,16,1,17,1,17,1,18,1,18,1,19,1,19,1,19,3,19,201,8,
        19,1,20,1,20,1,20,1,161,0,21,0,2,4,6,8,10,12,14,16,18,20,22,24,26,
        28,30,32,34,36,38,40,0,8,1,0,5,6,1,0,22,23,2,0,10,11,20,21,1,0,25,
        26,1,0,2,4,1,0,12,17,1,0,18,19,1,0,20,26,218,0,53,1,0,0,0,2,64,1,
        0,0,0,4,73,1,0,0,0,6,91,1,0,0,0,8,94,1,0,0,0,10,98,1,0,0,0,12,111,
        1,0,0,0,14,114,1,0,0,0,16,122,1,0,0,0,18,124,1,0,0,0,20,137,1,0,
        0,0,22,139,1,0,0,0,24,149,1,0,0,0,26,161,1,0,0,0,28,180,1,0,0,0,
        30,182,1,0,0,0,32,189,1,0,0,0,34,193,1,0,0,0,36,195,1,0,0,0,38,200,
        1,0,0,0,40,202,1,0,0,0,42,44,7,0,0,0,43,45,3,6,3,0,44,43,1,0,0,0,
        44,45,1,0,0,0,45,54,1,0,0,0,46,54,5,8,0,0,47,54,5,9,0,0,48,49,7,
        1,0,0,49,51,3,30,15,0,50,52,3,6,3,0,51,50,1,0,0,0,51,52,1,0,0,0,
        52,54,1,0,0,0,53,42,1,0,0,0,53,46,1,0,0,0,53,47,1,0,0,0,53,48,1,
        0,0,0,54,1,1,0,0,0,55,65,5,7,0,0,56,65,5,24,0,0,57,58,7,2,0,0,58,
        60,3,30,15,0,59,61,3,6,3,0,60,59,1,0,0,0,60,61,1,0,0,0,61,65,1,0,
        0,0,62,63,7,3,0,0,63,65,3,30,15,0,64,55,1,0,0,0,64,56,1,0,0,0,64,
        57,1,0,0,0,64,62,1,0,0,0,65,3,1,0,0,0,66,68,7,0,0,0,67,69,3,6,3,
        0,68,67,1,0,0,0,68,69,1,0,0,0,69,70,1,0,0,0,70,74,3,28,14,0,71,72,
        7,3,0,0,72,74,3,28,14,0,73,66,1,0,0,0,73,71,1,0,0,0,74,5,1,0,0,0,
        75,76,5,1,0,0,76,92,3,38,19,0,77,78,5,1,0,0,78,92,3,8,4,0,79,80,
        5,1,0,0,80,81,5,35,0,0,81,86,3,8,4,0,82,83,5,34,0,0,83,85,3,8,4,
        0,84,82,1,0,0,0,85,88,1,0,0,0,86,84,1,0,0,0,86,87,1,0,0,0,87,89,
        1,0,0,0,88,86,1,0,0,0,89,90,5,36,0,0,90,92,1,0,0,0,91,75,1,0,0,0,
        91,77,1,0,0,0,91,79,1,0,0,0,92,7,1,0,0,0,93,95,5,30,0,0,94,93,1,
        0,0,0,94,95,1,0,0,0,95,96,1,0,0,0,96,97,5,39,0,0,97,9,1,0,0,0,98,
        104,3,12,6,0,99,100,3,34,17,0,100,101,3,12,6,0,101,103,1,0,0,0,102,
        99,1,0,0,0,103,106,1,0,0,0,104,102,1,0,0,0,104,105,1,0,0,0,105,11,
        1,0,0,0,106,104,1,0,0,0,107,112,3,36,18,0,108,112,3,14,7,0,109,112,
        3,16,8,0,110,112,3,28,14,0,111,107,1,0,0,0,111,108,1,0,0,0,111,109,
        1,0,0,0,111,110,1,0,0,0,112,13,1,0,0,0,113,115,5,30,0,0,114,113,
        1,0,0,0,114,115,1,0,0,0,115,116,1,0,0,0,116,118,5,39,0,0,117,119,
        5,33,0,0,118,117,1,0,0,0,118,119,1,0,0,0,119,15,1,0,0,0,120,123,
        3,18,9,0,121,123,3,38,19,0,122,120,1,0,0,0,122,121,1,0,0,0,123,17,
        1,0,0,0,124,125,7,4,0,0,125,126,5,27,0,0,126,129,3,38,19,0,127,128,
        5,34,0,0,128,130,3,38,19,0,129,127,1,0,0,0,129,130,1,0,0,0,130,131,
        1,0,0,0,131,132,5,28,0,0,132,19,1,0,0,0,133,138,3,40,20,0,134,138,
        5,2,0,0,135,138,5,3,0,0,136,138,5,4,0,0,137,133,1,0,0,0,137,134,
        1,0,0,0,137,135,1,0,0,0,137,136,1,0,0,0,138,21,1,0,0,0,139,144,3,
        24,12,0,140,141,5,34,0,0,141,143,3,24,12,0,142,140,1,0,0,0,143,146,
        1,0,0,0,144,142,1,0,0,0,144,145,1,0,0,0,145,147,1,0,0,0,146,144,
        1,0,0,0,147,148,5,0,0,1,148,23,1,0,0,0,149,155,3,26,13,0,150,151,
        3,0,0,0,151,152,3,26,13,0,152,154,1,0,0,0,153,150,1,0,0,0,154,157,
        1,0,0,0,155,153,1,0,0,0,155,156,1,0,0,0,156,25,1,0,0,0,157,155,1,
        0,0,0,158,160,3,2,1,0,159,158,1,0,0,0,160,163,1,0,0,0,161,162,1,
        0,0,0,161,159,1,0,0,0,162,166,1,0,0,0,163,161,1,0,0,0,164,167,3,
        10,5,0,165,167,3,4,2,0,166,164,1,0,0,0,166,165,1,0,0,0,167,27,1,
        0,0,0,168,181,5,44,0,0,169,170,5,27,0,0,170,175,3,24,12,0,171,172,
        5,34,0,0,172,174,3,24,12,0,173,171,1,0,0,0,174,177,1,0,0,0,175,173,
        1,0,0,0,175,176,1,0,0,0,176,178,1,0,0,0,177,175,1,0,0,0,178,179,
        5,28,0,0,179,181,1,0,0,0,180,168,1,0,0,0,180,169,1,0,0,0,181,29,
        1,0,0,0,182,183,5,35,0,0,183,184,3,32,16,0,184,185,5,34,0,0,185,
        186,3,32,16,0,186,187,5,36,0,0,187,31,1,0,0,0,188,190,5,30,0,0,189,
        188,1,0,0,0,189,190,1,0,0,0,190,191,1,0,0,0,191,192,5,39,0,0,192,
        33,1,0,0,0,193,194,7,5,0,0,194,35,1,0,0,0,195,196,7,6,0,0,196,37,
        1,0,0,0,197,201,5,40,0,0,198,201,5,41,0,0,199,201,3,20,10,0,200,
        197,1,0,0,0,200,198,1,0,0,0,200,199,1,0,0,0,201,39,1,0,0,0,202,203,
        7,7,0,0,203,41,1,0,0,0,25,44,51,53,60,64,68,73,86,91,94,104,111,
        114,118,122,129,137,144,155,161,166,175,180,189,200
    ]

class wmtlParser ( Parser ):

    grammarFileName = "wmtl.g4"

    atn = ATNDeserializer().deserialize(serializedATN())

    decisionsToDFA = [ DFA(ds, i) for i, ds in enumerate(atn.decisionToState) ]

    sharedContextCache = PredictionContextCache()

    literalNames = [ "<INVALID>", "'^'", "'sum'", "'min'", "'max'", "<INVALID>", 
                     "<INVALID>", "<INVALID>", "<INVALID>", "<INVALID>", 
                     "'<>'", "'[]'", "'>='", "'<='", "'>'", "'<'", "<INVALID>", 
                     "'!='", "<INVALID>", "<INVALID>", "'F'", "'G'", "'U'", 
                     "'R'", "'X'", "'one'", "'all'", "'('", "')'", "'+'", 
                     "'-'", "'*'", "'/'", "'%'", "','", "'['", "']'", "'{'", 
                     "'}'" ]

    symbolicNames = [ "<INVALID>", "HAT", "SUM", "MIN", "MAX", "AND", "OR", 
                      "NOT", "IMPLIES", "IFF", "DIAMOND", "BOX", "GE", "LE", 
                      "GT", "LT", "EQ", "NE", "TRUE", "FALSE", "EVENTUALLY", 
                      "ALWAYS", "UNTIL", "RELEASE", "NEXT", "ONE", "ALL", 
                      "OPEN", "CLOSE", "PLUS", "MINUS", "STAR", "SLASH", 
                      "PERCENT", "COMMA", "LBRACKET", "RBRACKET", "LBRACE", 
                      "RBRACE", "NUMBER", "NAME", "STRING", "SPACE", "STRAY", 
                      "GROUP" ]

    RULE_connective = 0
    RULE_prefix = 1
    RULE_joined = 2
    RULE_weight = 3
    RULE_value = 4
    RULE_comparison = 5
    RULE_operand = 6
    RULE_number = 7
    RULE_atom = 8
    RULE_count = 9
    RULE_reserved = 10
    RULE_formula = 11
    RULE_level = 12
    RULE_unary = 13
    RULE_parts = 14
    RULE_interval = 15
    RULE_bound = 16
    RULE_relation = 17
    RULE_constant = 18
    RULE_name = 19
    RULE_word = 20

    ruleNames =  [ "connective", "prefix", "joined", "weight", "value", 
                   "comparison", "operand", "number", "atom", "count", "reserved", 
                   "formula", "level", "unary", "parts", "interval", "bound", 
                   "relation", "constant", "name", "word" ]

    EOF = Token.EOF
    HAT=1
    SUM=2
    MIN=3
    MAX=4
    AND=5
    OR=6
    NOT=7
    IMPLIES=8
    IFF=9
    DIAMOND=10
    BOX=11
    GE=12
    LE=13
    GT=14
    LT=15
    EQ=16
    NE=17
    TRUE=18
    FALSE=19
    EVENTUALLY=20
    ALWAYS=21
    UNTIL=22
    RELEASE=23
    NEXT=24
    ONE=25
    ALL=26
    OPEN=27
    CLOSE=28
    PLUS=29
    MINUS=30
    STAR=31
    SLASH=32
    PERCENT=33
    COMMA=34
    LBRACKET=35
    RBRACKET=36
    LBRACE=37
    RBRACE=38
    NUMBER=39
    NAME=40
    STRING=41
    SPACE=42
    STRAY=43
    GROUP=44

    def __init__(self, input:TokenStream, output:TextIO = sys.stdout):
        super().__init__(input, output)
        self.checkVersion("4.13.1")
        self._interp = ParserATNSimulator(self, self.atn, self.decisionsToDFA, self.sharedContextCache)
        self._predicates = None




    class ConnectiveContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def AND(self):
            return self.getToken(wmtlParser.AND, 0)

        def OR(self):
            return self.getToken(wmtlParser.OR, 0)

        def weight(self):
            return self.getTypedRuleContext(wmtlParser.WeightContext,0)


        def IMPLIES(self):
            return self.getToken(wmtlParser.IMPLIES, 0)

        def IFF(self):
            return self.getToken(wmtlParser.IFF, 0)

        def interval(self):
            return self.getTypedRuleContext(wmtlParser.IntervalContext,0)


        def UNTIL(self):
            return self.getToken(wmtlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(wmtlParser.RELEASE, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_connective




    def connective(self):

        localctx = wmtlParser.ConnectiveContext(self, self._ctx, self.state)
        self.enterRule(localctx, 0, self.RULE_connective)
        self._la = 0 # Token type
        try:
            self.state = 53
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [5, 6]:
                self.enterOuterAlt(localctx, 1)
                self.state = 42
                _la = self._input.LA(1)
                if not(_la==5 or _la==6):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 44
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                if _la==1:
                    self.state = 43
                    self.weight()


                pass
            elif token in [8]:
                self.enterOuterAlt(localctx, 2)
                self.state = 46
                self.match(wmtlParser.IMPLIES)
                pass
            elif token in [9]:
                self.enterOuterAlt(localctx, 3)
                self.state = 47
                self.match(wmtlParser.IFF)
                pass
            elif token in [22, 23]:
                self.enterOuterAlt(localctx, 4)
                self.state = 48
                _la = self._input.LA(1)
                if not(_la==22 or _la==23):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 49
                self.interval()
                self.state = 51
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                if _la==1:
                    self.state = 50
                    self.weight()


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


    class PrefixContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def NOT(self):
            return self.getToken(wmtlParser.NOT, 0)

        def NEXT(self):
            return self.getToken(wmtlParser.NEXT, 0)

        def interval(self):
            return self.getTypedRuleContext(wmtlParser.IntervalContext,0)


        def EVENTUALLY(self):
            return self.getToken(wmtlParser.EVENTUALLY, 0)

        def DIAMOND(self):
            return self.getToken(wmtlParser.DIAMOND, 0)

        def ALWAYS(self):
            return self.getToken(wmtlParser.ALWAYS, 0)

        def BOX(self):
            return self.getToken(wmtlParser.BOX, 0)

        def weight(self):
            return self.getTypedRuleContext(wmtlParser.WeightContext,0)


        def ONE(self):
            return self.getToken(wmtlParser.ONE, 0)

        def ALL(self):
            return self.getToken(wmtlParser.ALL, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_prefix




    def prefix(self):

        localctx = wmtlParser.PrefixContext(self, self._ctx, self.state)
        self.enterRule(localctx, 2, self.RULE_prefix)
        self._la = 0 # Token type
        try:
            self.state = 64
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [7]:
                self.enterOuterAlt(localctx, 1)
                self.state = 55
                self.match(wmtlParser.NOT)
                pass
            elif token in [24]:
                self.enterOuterAlt(localctx, 2)
                self.state = 56
                self.match(wmtlParser.NEXT)
                pass
            elif token in [10, 11, 20, 21]:
                self.enterOuterAlt(localctx, 3)
                self.state = 57
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 3148800) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 58
                self.interval()
                self.state = 60
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                if _la==1:
                    self.state = 59
                    self.weight()


                pass
            elif token in [25, 26]:
                self.enterOuterAlt(localctx, 4)
                self.state = 62
                _la = self._input.LA(1)
                if not(_la==25 or _la==26):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 63
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


    class JoinedContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def parts(self):
            return self.getTypedRuleContext(wmtlParser.PartsContext,0)


        def AND(self):
            return self.getToken(wmtlParser.AND, 0)

        def OR(self):
            return self.getToken(wmtlParser.OR, 0)

        def weight(self):
            return self.getTypedRuleContext(wmtlParser.WeightContext,0)


        def ONE(self):
            return self.getToken(wmtlParser.ONE, 0)

        def ALL(self):
            return self.getToken(wmtlParser.ALL, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_joined




    def joined(self):

        localctx = wmtlParser.JoinedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 4, self.RULE_joined)
        self._la = 0 # Token type
        try:
            self.state = 73
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [5, 6]:
                self.enterOuterAlt(localctx, 1)
                self.state = 66
                _la = self._input.LA(1)
                if not(_la==5 or _la==6):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 68
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                if _la==1:
                    self.state = 67
                    self.weight()


                self.state = 70
                self.parts()
                pass
            elif token in [25, 26]:
                self.enterOuterAlt(localctx, 2)
                self.state = 71
                _la = self._input.LA(1)
                if not(_la==25 or _la==26):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 72
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


    class WeightContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def HAT(self):
            return self.getToken(wmtlParser.HAT, 0)

        def name(self):
            return self.getTypedRuleContext(wmtlParser.NameContext,0)


        def value(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wmtlParser.ValueContext)
            else:
                return self.getTypedRuleContext(wmtlParser.ValueContext,i)


        def LBRACKET(self):
            return self.getToken(wmtlParser.LBRACKET, 0)

        def RBRACKET(self):
            return self.getToken(wmtlParser.RBRACKET, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(wmtlParser.COMMA)
            else:
                return self.getToken(wmtlParser.COMMA, i)

        def getRuleIndex(self):
            return wmtlParser.RULE_weight




    def weight(self):

        localctx = wmtlParser.WeightContext(self, self._ctx, self.state)
        self.enterRule(localctx, 6, self.RULE_weight)
        self._la = 0 # Token type
        try:
            self.state = 91
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,8,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 75
                self.match(wmtlParser.HAT)
                self.state = 76
                self.name()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 77
                self.match(wmtlParser.HAT)
                self.state = 78
                self.value()
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 79
                self.match(wmtlParser.HAT)
                self.state = 80
                self.match(wmtlParser.LBRACKET)
                self.state = 81
                self.value()
                self.state = 86
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==34:
                    self.state = 82
                    self.match(wmtlParser.COMMA)
                    self.state = 83
                    self.value()
                    self.state = 88
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 89
                self.match(wmtlParser.RBRACKET)
                pass


        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class ValueContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def NUMBER(self):
            return self.getToken(wmtlParser.NUMBER, 0)

        def MINUS(self):
            return self.getToken(wmtlParser.MINUS, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_value




    def value(self):

        localctx = wmtlParser.ValueContext(self, self._ctx, self.state)
        self.enterRule(localctx, 8, self.RULE_value)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 94
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==30:
                self.state = 93
                self.match(wmtlParser.MINUS)


            self.state = 96
            self.match(wmtlParser.NUMBER)
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
                return self.getTypedRuleContexts(wmtlParser.OperandContext)
            else:
                return self.getTypedRuleContext(wmtlParser.OperandContext,i)


        def relation(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wmtlParser.RelationContext)
            else:
                return self.getTypedRuleContext(wmtlParser.RelationContext,i)


        def getRuleIndex(self):
            return wmtlParser.RULE_comparison




    def comparison(self):

        localctx = wmtlParser.ComparisonContext(self, self._ctx, self.state)
        self.enterRule(localctx, 10, self.RULE_comparison)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 98
            self.operand()
            self.state = 104
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 258048) != 0):
                self.state = 99
                self.relation()
                self.state = 100
                self.operand()
                self.state = 106
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
            return self.getTypedRuleContext(wmtlParser.ConstantContext,0)


        def number(self):
            return self.getTypedRuleContext(wmtlParser.NumberContext,0)


        def atom(self):
            return self.getTypedRuleContext(wmtlParser.AtomContext,0)


        def parts(self):
            return self.getTypedRuleContext(wmtlParser.PartsContext,0)


        def getRuleIndex(self):
            return wmtlParser.RULE_operand




    def operand(self):

        localctx = wmtlParser.OperandContext(self, self._ctx, self.state)
        self.enterRule(localctx, 12, self.RULE_operand)
        try:
            self.state = 111
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [18, 19]:
                self.enterOuterAlt(localctx, 1)
                self.state = 107
                self.constant()
                pass
            elif token in [30, 39]:
                self.enterOuterAlt(localctx, 2)
                self.state = 108
                self.number()
                pass
            elif token in [2, 3, 4, 20, 21, 22, 23, 24, 25, 26, 40, 41]:
                self.enterOuterAlt(localctx, 3)
                self.state = 109
                self.atom()
                pass
            elif token in [27, 44]:
                self.enterOuterAlt(localctx, 4)
                self.state = 110
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
            return self.getToken(wmtlParser.NUMBER, 0)

        def MINUS(self):
            return self.getToken(wmtlParser.MINUS, 0)

        def PERCENT(self):
            return self.getToken(wmtlParser.PERCENT, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_number




    def number(self):

        localctx = wmtlParser.NumberContext(self, self._ctx, self.state)
        self.enterRule(localctx, 14, self.RULE_number)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 114
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==30:
                self.state = 113
                self.match(wmtlParser.MINUS)


            self.state = 116
            self.match(wmtlParser.NUMBER)
            self.state = 118
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==33:
                self.state = 117
                self.match(wmtlParser.PERCENT)


        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class AtomContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def count(self):
            return self.getTypedRuleContext(wmtlParser.CountContext,0)


        def name(self):
            return self.getTypedRuleContext(wmtlParser.NameContext,0)


        def getRuleIndex(self):
            return wmtlParser.RULE_atom




    def atom(self):

        localctx = wmtlParser.AtomContext(self, self._ctx, self.state)
        self.enterRule(localctx, 16, self.RULE_atom)
        try:
            self.state = 122
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,14,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 120
                self.count()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 121
                self.name()
                pass


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
            return self.getToken(wmtlParser.OPEN, 0)

        def name(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wmtlParser.NameContext)
            else:
                return self.getTypedRuleContext(wmtlParser.NameContext,i)


        def CLOSE(self):
            return self.getToken(wmtlParser.CLOSE, 0)

        def SUM(self):
            return self.getToken(wmtlParser.SUM, 0)

        def MIN(self):
            return self.getToken(wmtlParser.MIN, 0)

        def MAX(self):
            return self.getToken(wmtlParser.MAX, 0)

        def COMMA(self):
            return self.getToken(wmtlParser.COMMA, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_count




    def count(self):

        localctx = wmtlParser.CountContext(self, self._ctx, self.state)
        self.enterRule(localctx, 18, self.RULE_count)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 124
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 28) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 125
            self.match(wmtlParser.OPEN)
            self.state = 126
            self.name()
            self.state = 129
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==34:
                self.state = 127
                self.match(wmtlParser.COMMA)
                self.state = 128
                self.name()


            self.state = 131
            self.match(wmtlParser.CLOSE)
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

        def word(self):
            return self.getTypedRuleContext(wmtlParser.WordContext,0)


        def SUM(self):
            return self.getToken(wmtlParser.SUM, 0)

        def MIN(self):
            return self.getToken(wmtlParser.MIN, 0)

        def MAX(self):
            return self.getToken(wmtlParser.MAX, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_reserved




    def reserved(self):

        localctx = wmtlParser.ReservedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 20, self.RULE_reserved)
        try:
            self.state = 137
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [20, 21, 22, 23, 24, 25, 26]:
                self.enterOuterAlt(localctx, 1)
                self.state = 133
                self.word()
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 2)
                self.state = 134
                self.match(wmtlParser.SUM)
                pass
            elif token in [3]:
                self.enterOuterAlt(localctx, 3)
                self.state = 135
                self.match(wmtlParser.MIN)
                pass
            elif token in [4]:
                self.enterOuterAlt(localctx, 4)
                self.state = 136
                self.match(wmtlParser.MAX)
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


    class FormulaContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def level(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wmtlParser.LevelContext)
            else:
                return self.getTypedRuleContext(wmtlParser.LevelContext,i)


        def EOF(self):
            return self.getToken(wmtlParser.EOF, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(wmtlParser.COMMA)
            else:
                return self.getToken(wmtlParser.COMMA, i)

        def getRuleIndex(self):
            return wmtlParser.RULE_formula




    def formula(self):

        localctx = wmtlParser.FormulaContext(self, self._ctx, self.state)
        self.enterRule(localctx, 22, self.RULE_formula)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 139
            self.level()
            self.state = 144
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==34:
                self.state = 140
                self.match(wmtlParser.COMMA)
                self.state = 141
                self.level()
                self.state = 146
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 147
            self.match(wmtlParser.EOF)
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
                return self.getTypedRuleContexts(wmtlParser.UnaryContext)
            else:
                return self.getTypedRuleContext(wmtlParser.UnaryContext,i)


        def connective(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wmtlParser.ConnectiveContext)
            else:
                return self.getTypedRuleContext(wmtlParser.ConnectiveContext,i)


        def getRuleIndex(self):
            return wmtlParser.RULE_level




    def level(self):

        localctx = wmtlParser.LevelContext(self, self._ctx, self.state)
        self.enterRule(localctx, 24, self.RULE_level)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 149
            self.unary()
            self.state = 155
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 12583776) != 0):
                self.state = 150
                self.connective()
                self.state = 151
                self.unary()
                self.state = 157
                self._errHandler.sync(self)
                _la = self._input.LA(1)

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
            return self.getTypedRuleContext(wmtlParser.ComparisonContext,0)


        def joined(self):
            return self.getTypedRuleContext(wmtlParser.JoinedContext,0)


        def prefix(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wmtlParser.PrefixContext)
            else:
                return self.getTypedRuleContext(wmtlParser.PrefixContext,i)


        def getRuleIndex(self):
            return wmtlParser.RULE_unary




    def unary(self):

        localctx = wmtlParser.UnaryContext(self, self._ctx, self.state)
        self.enterRule(localctx, 26, self.RULE_unary)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 161
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,19,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 158
                    self.prefix() 
                self.state = 163
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,19,self._ctx)

            self.state = 166
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,20,self._ctx)
            if la_ == 1:
                self.state = 164
                self.comparison()
                pass

            elif la_ == 2:
                self.state = 165
                self.joined()
                pass


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
            return self.getToken(wmtlParser.GROUP, 0)

        def OPEN(self):
            return self.getToken(wmtlParser.OPEN, 0)

        def level(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wmtlParser.LevelContext)
            else:
                return self.getTypedRuleContext(wmtlParser.LevelContext,i)


        def CLOSE(self):
            return self.getToken(wmtlParser.CLOSE, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(wmtlParser.COMMA)
            else:
                return self.getToken(wmtlParser.COMMA, i)

        def getRuleIndex(self):
            return wmtlParser.RULE_parts




    def parts(self):

        localctx = wmtlParser.PartsContext(self, self._ctx, self.state)
        self.enterRule(localctx, 28, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 180
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [44]:
                self.enterOuterAlt(localctx, 1)
                self.state = 168
                self.match(wmtlParser.GROUP)
                pass
            elif token in [27]:
                self.enterOuterAlt(localctx, 2)
                self.state = 169
                self.match(wmtlParser.OPEN)
                self.state = 170
                self.level()
                self.state = 175
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==34:
                    self.state = 171
                    self.match(wmtlParser.COMMA)
                    self.state = 172
                    self.level()
                    self.state = 177
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 178
                self.match(wmtlParser.CLOSE)
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
            return self.getToken(wmtlParser.LBRACKET, 0)

        def bound(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wmtlParser.BoundContext)
            else:
                return self.getTypedRuleContext(wmtlParser.BoundContext,i)


        def COMMA(self):
            return self.getToken(wmtlParser.COMMA, 0)

        def RBRACKET(self):
            return self.getToken(wmtlParser.RBRACKET, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_interval




    def interval(self):

        localctx = wmtlParser.IntervalContext(self, self._ctx, self.state)
        self.enterRule(localctx, 30, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 182
            self.match(wmtlParser.LBRACKET)
            self.state = 183
            self.bound()
            self.state = 184
            self.match(wmtlParser.COMMA)
            self.state = 185
            self.bound()
            self.state = 186
            self.match(wmtlParser.RBRACKET)
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
            return self.getToken(wmtlParser.NUMBER, 0)

        def MINUS(self):
            return self.getToken(wmtlParser.MINUS, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_bound




    def bound(self):

        localctx = wmtlParser.BoundContext(self, self._ctx, self.state)
        self.enterRule(localctx, 32, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 189
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==30:
                self.state = 188
                self.match(wmtlParser.MINUS)


            self.state = 191
            self.match(wmtlParser.NUMBER)
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
            return self.getToken(wmtlParser.GE, 0)

        def LE(self):
            return self.getToken(wmtlParser.LE, 0)

        def GT(self):
            return self.getToken(wmtlParser.GT, 0)

        def LT(self):
            return self.getToken(wmtlParser.LT, 0)

        def EQ(self):
            return self.getToken(wmtlParser.EQ, 0)

        def NE(self):
            return self.getToken(wmtlParser.NE, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_relation




    def relation(self):

        localctx = wmtlParser.RelationContext(self, self._ctx, self.state)
        self.enterRule(localctx, 34, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 193
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 258048) != 0)):
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
            return self.getToken(wmtlParser.TRUE, 0)

        def FALSE(self):
            return self.getToken(wmtlParser.FALSE, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_constant




    def constant(self):

        localctx = wmtlParser.ConstantContext(self, self._ctx, self.state)
        self.enterRule(localctx, 36, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 195
            _la = self._input.LA(1)
            if not(_la==18 or _la==19):
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
            return self.getToken(wmtlParser.NAME, 0)

        def STRING(self):
            return self.getToken(wmtlParser.STRING, 0)

        def reserved(self):
            return self.getTypedRuleContext(wmtlParser.ReservedContext,0)


        def getRuleIndex(self):
            return wmtlParser.RULE_name




    def name(self):

        localctx = wmtlParser.NameContext(self, self._ctx, self.state)
        self.enterRule(localctx, 38, self.RULE_name)
        try:
            self.state = 200
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [40]:
                self.enterOuterAlt(localctx, 1)
                self.state = 197
                self.match(wmtlParser.NAME)
                pass
            elif token in [41]:
                self.enterOuterAlt(localctx, 2)
                self.state = 198
                self.match(wmtlParser.STRING)
                pass
            elif token in [2, 3, 4, 20, 21, 22, 23, 24, 25, 26]:
                self.enterOuterAlt(localctx, 3)
                self.state = 199
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


    class WordContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def EVENTUALLY(self):
            return self.getToken(wmtlParser.EVENTUALLY, 0)

        def ALWAYS(self):
            return self.getToken(wmtlParser.ALWAYS, 0)

        def UNTIL(self):
            return self.getToken(wmtlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(wmtlParser.RELEASE, 0)

        def NEXT(self):
            return self.getToken(wmtlParser.NEXT, 0)

        def ONE(self):
            return self.getToken(wmtlParser.ONE, 0)

        def ALL(self):
            return self.getToken(wmtlParser.ALL, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_word




    def word(self):

        localctx = wmtlParser.WordContext(self, self._ctx, self.state)
        self.enterRule(localctx, 40, self.RULE_word)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 202
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 133169152) != 0)):
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





