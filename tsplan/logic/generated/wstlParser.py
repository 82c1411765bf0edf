# Generated from wstl.g4 by ANTLR 4.13.1
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
        4,1,39,200,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,2,19,7,19,2,20,
        7,20,1,0,1,0,3,0,45,8,0,1,0,1,0,1,0,1,0,1,0,3,0,52,8,0,3,0,54,8,
        0,1,1,5,1,57,8,1,10,1,12,1,60,9,1,1,1,1,1,3,1,64,8,1,1,2,1,2,1,2,
        1,2,1,2,3,2,71,8,2,3,2,73,8,2,1,3,1,3,3,3,77,8,3,1,3,1,3,1,4,1,4,
        1,4,1,4,1,4,1,4,1,4,1,4,1,4,5,4,90,8,4,10,4,12,4,93,9,4,1,4,1,4,
        3,4,97,8,4,1,5,3,5,100,8,5,1,5,1,5,1,6,1,6,1,6,1,6,5,6,108,8,6,10,
        6,12,6,111,9,6,1,7,1,7,1,7,5,7,116,8,7,10,7,12,7,119,9,7,1,8,1,8,
        1,8,5,8,124,8,8,10,8,12,8,127,9,8,1,9,5,9,130,8,9,10,9,12,9,133,
        9,9,1,9,1,9,1,10,1,10,1,10,1,10,3,10,141,8,10,1,11,1,11,1,12,1,12,
        1,12,5,12,148,8,12,10,12,12,12,151,9,12,1,12,1,12,1,13,1,13,1,13,
        1,13,5,13,159,8,13,10,13,12,13,162,9,13,1,14,1,14,1,14,1,14,1,14,
        5,14,169,8,14,10,14,12,14,172,9,14,1,14,1,14,3,14,176,8,14,1,15,
        1,15,1,15,1,15,1,15,1,15,1,16,3,16,185,8,16,1,16,1,16,1,17,1,17,
        1,18,1,18,1,19,1,19,1,19,3,19,196,8,19,1,20,1,20,1,20,1,58,0,21,
        0,2,4,6,8,10,12,14,16,18,20,22,24,26,28,30,32,34,36,38,40,0,8,1,
        0,2,3,1,0,19,20,2,0,7,8,17,18,1,0,24,25,1,0,26,27,1,0,9,14,1,0,15,
        16,1,0,17,21,207,0,53,1,0,0,0,2,58,1,0,0,0,4,72,1,0,0,0,6,74,1,0,
        0,0,8,96,1,0,0,0,10,99,1,0,0,0,12,103,1,0,0,0,14,112,1,0,0,0,16,
        120,1,0,0,0,18,131,1,0,0,0,20,140,1,0,0,0,22,142,1,0,0,0,24,144,
        1,0,0,0,26,154,1,0,0,0,28,175,1,0,0,0,30,177,1,0,0,0,32,184,1,0,
        0,0,34,188,1,0,0,0,36,190,1,0,0,0,38,195,1,0,0,0,40,197,1,0,0,0,
        42,44,7,0,0,0,43,45,3,8,4,0,44,43,1,0,0,0,44,45,1,0,0,0,45,54,1,
        0,0,0,46,54,5,5,0,0,47,54,5,6,0,0,48,49,7,1,0,0,49,51,3,30,15,0,
        50,52,3,8,4,0,51,50,1,0,0,0,51,52,1,0,0,0,52,54,1,0,0,0,53,42,1,
        0,0,0,53,46,1,0,0,0,53,47,1,0,0,0,53,48,1,0,0,0,54,1,1,0,0,0,55,
        57,3,4,2,0,56,55,1,0,0,0,57,60,1,0,0,0,58,59,1,0,0,0,58,56,1,0,0,
        0,59,63,1,0,0,0,60,58,1,0,0,0,61,64,3,12,6,0,62,64,3,6,3,0,63,61,
        1,0,0,0,63,62,1,0,0,0,64,3,1,0,0,0,65,73,5,4,0,0,66,73,5,21,0,0,
        67,68,7,2,0,0,68,70,3,30,15,0,69,71,3,8,4,0,70,69,1,0,0,0,70,71,
        1,0,0,0,71,73,1,0,0,0,72,65,1,0,0,0,72,66,1,0,0,0,72,67,1,0,0,0,
        73,5,1,0,0,0,74,76,7,0,0,0,75,77,3,8,4,0,76,75,1,0,0,0,76,77,1,0,
        0,0,77,78,1,0,0,0,78,79,3,28,14,0,79,7,1,0,0,0,80,81,5,1,0,0,81,
        97,3,38,19,0,82,83,5,1,0,0,83,97,3,10,5,0,84,85,5,1,0,0,85,86,5,
        30,0,0,86,91,3,10,5,0,87,88,5,29,0,0,88,90,3,10,5,0,89,87,1,0,0,
        0,90,93,1,0,0,0,91,89,1,0,0,0,91,92,1,0,0,0,92,94,1,0,0,0,93,91,
        1,0,0,0,94,95,5,31,0,0,95,97,1,0,0,0,96,80,1,0,0,0,96,82,1,0,0,0,
        96,84,1,0,0,0,97,9,1,0,0,0,98,100,5,25,0,0,99,98,1,0,0,0,99,100,
        1,0,0,0,100,101,1,0,0,0,101,102,5,34,0,0,102,11,1,0,0,0,103,109,
        3,14,7,0,104,105,3,34,17,0,105,106,3,14,7,0,106,108,1,0,0,0,107,
        104,1,0,0,0,108,111,1,0,0,0,109,107,1,0,0,0,109,110,1,0,0,0,110,
        13,1,0,0,0,111,109,1,0,0,0,112,117,3,16,8,0,113,114,7,3,0,0,114,
        116,3,16,8,0,115,113,1,0,0,0,116,119,1,0,0,0,117,115,1,0,0,0,117,
        118,1,0,0,0,118,15,1,0,0,0,119,117,1,0,0,0,120,125,3,18,9,0,121,
        122,7,4,0,0,122,124,3,18,9,0,123,121,1,0,0,0,124,127,1,0,0,0,125,
        123,1,0,0,0,125,126,1,0,0,0,126,17,1,0,0,0,127,125,1,0,0,0,128,130,
        7,3,0,0,129,128,1,0,0,0,130,133,1,0,0,0,131,129,1,0,0,0,131,132,
        1,0,0,0,132,134,1,0,0,0,133,131,1,0,0,0,134,135,3,20,10,0,135,19,
        1,0,0,0,136,141,3,36,18,0,137,141,5,34,0,0,138,141,3,38,19,0,139,
        141,3,28,14,0,140,136,1,0,0,0,140,137,1,0,0,0,140,138,1,0,0,0,140,
        139,1,0,0,0,141,21,1,0,0,0,142,143,3,40,20,0,143,23,1,0,0,0,144,
        149,3,26,13,0,145,146,5,29,0,0,146,148,3,26,13,0,147,145,1,0,0,0,
        148,151,1,0,0,0,149,147,1,0,0,0,149,150,1,0,0,0,150,152,1,0,0,0,
        151,149,1,0,0,0,152,153,5,0,0,1,153,25,1,0,0,0,154,160,3,2,1,0,155,
        156,3,0,0,0,156,157,3,2,1,0,157,159,1,0,0,0,158,155,1,0,0,0,159,
        162,1,0,0,0,160,158,1,0,0,0,160,161,1,0,0,0,161,27,1,0,0,0,162,160,
        1,0,0,0,163,176,5,39,0,0,164,165,5,22,0,0,165,170,3,26,13,0,166,
        167,5,29,0,0,167,169,3,26,13,0,168,166,1,0,0,0,169,172,1,0,0,0,170,
        168,1,0,0,0,170,171,1,0,0,0,171,173,1,0,0,0,172,170,1,0,0,0,173,
        174,5,23,0,0,174,176,1,0,0,0,175,163,1,0,0,0,175,164,1,0,0,0,176,
        29,1,0,0,0,177,178,5,30,0,0,178,179,3,32,16,0,179,180,5,29,0,0,180,
        181,3,32,16,0,181,182,5,31,0,0,182,31,1,0,0,0,183,185,5,25,0,0,184,
        183,1,0,0,0,184,185,1,0,0,0,185,186,1,0,0,0,186,187,5,34,0,0,187,
        33,1,0,0,0,188,189,7,5,0,0,189,35,1,0,0,0,190,191,7,6,0,0,191,37,
        1,0,0,0,192,196,5,35,0,0,193,196,5,36,0,0,194,196,3,22,11,0,195,
        192,1,0,0,0,195,193,1,0,0,0,195,194,1,0,0,0,196,39,1,0,0,0,197,198,
        7,7,0,0,198,41,1,0,0,0,22,44,51,53,58,63,70,72,76,91,96,99,109,117,
        125,131,140,149,160,170,175,184,195
    ]

class wstlParser ( Parser ):

    grammarFileName = "wstl.g4"

    atn = ATNDeserializer().deserialize(serializedATN())

    decisionsToDFA = [ DFA(ds, i) for i, ds in enumerate(atn.decisionToState) ]

    sharedContextCache = PredictionContextCache()

    literalNames = [ "<INVALID>", "'^'", "<INVALID>", "<INVALID>", "<INVALID>", 
                     "<INVALID>", "<INVALID>", "'<>'", "'[]'", "'>='", "'<='", 
                     "'>'", "'<'", "<INVALID>", "'!='", "<INVALID>", "<INVALID>", 
                     "'F'", "'G'", "'U'", "'R'", "'X'", "'('", "')'", "'+'", 
                     "'-'", "'*'", "'/'", "'%'", "','", "'['", "']'", "'{'", 
                     "'}'" ]

    symbolicNames = [ "<INVALID>", "HAT", "AND", "OR", "NOT", "IMPLIES", 
                      "IFF", "DIAMOND", "BOX", "GE", "LE", "GT", "LT", "EQ", 
                      "NE", "TRUE", "FALSE", "EVENTUALLY", "ALWAYS", "UNTIL", 
                      "RELEASE", "NEXT", "OPEN", "CLOSE", "PLUS", "MINUS", 
                      "STAR", "SLASH", "PERCENT", "COMMA", "LBRACKET", "RBRACKET", 
                      "LBRACE", "RBRACE", "NUMBER", "NAME", "STRING", "SPACE", 
                      "STRAY", "GROUP" ]

    RULE_connective = 0
    RULE_unary = 1
    RULE_prefix = 2
    RULE_joined = 3
    RULE_weight = 4
    RULE_value = 5
    RULE_comparison = 6
    RULE_total = 7
    RULE_term = 8
    RULE_factor = 9
    RULE_operand = 10
    RULE_reserved = 11
    RULE_formula = 12
    RULE_level = 13
    RULE_parts = 14
    RULE_interval = 15
    RULE_bound = 16
    RULE_relation = 17
    RULE_constant = 18
    RULE_name = 19
    RULE_letter = 20

    ruleNames =  [ "connective", "unary", "prefix", "joined", "weight", 
                   "value", "comparison", "total", "term", "factor", "operand", 
                   "reserved", "formula", "level", "parts", "interval", 
                   "bound", "relation", "constant", "name", "letter" ]

    EOF = Token.EOF
    HAT=1
    AND=2
    OR=3
    NOT=4
    IMPLIES=5
    IFF=6
    DIAMOND=7
    BOX=8
    GE=9
    LE=10
    GT=11
    LT=12
    EQ=13
    NE=14
    TRUE=15
    FALSE=16
    EVENTUALLY=17
    ALWAYS=18
    UNTIL=19
    RELEASE=20
    NEXT=21
    OPEN=22
    CLOSE=23
    PLUS=24
    MINUS=25
    STAR=26
    SLASH=27
    PERCENT=28
    COMMA=29
    LBRACKET=30
    RBRACKET=31
    LBRACE=32
    RBRACE=33
    NUMBER=34
    NAME=35
    STRING=36
    SPACE=37
    STRAY=38
    GROUP=39

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
            return self.getToken(wstlParser.AND, 0)

        def OR(self):
            return self.getToken(wstlParser.OR, 0)

        def weight(self):
            return self.getTypedRuleContext(wstlParser.WeightContext,0)


        def IMPLIES(self):
            return self.getToken(wstlParser.IMPLIES, 0)

        def IFF(self):
            return self.getToken(wstlParser.IFF, 0)

        def interval(self):
            return self.getTypedRuleContext(wstlParser.IntervalContext,0)


        def UNTIL(self):
            return self.getToken(wstlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(wstlParser.RELEASE, 0)

        def getRuleIndex(self):
            return wstlParser.RULE_connective




    def connective(self):

        localctx = wstlParser.ConnectiveContext(self, self._ctx, self.state)
        self.enterRule(localctx, 0, self.RULE_connective)
        self._la = 0 # Token type
        try:
            self.state = 53
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [2, 3]:
                self.enterOuterAlt(localctx, 1)
                self.state = 42
                _la = self._input.LA(1)
                if not(_la==2 or _la==3):
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
            elif token in [5]:
                self.enterOuterAlt(localctx, 2)
                self.state = 46
                self.match(wstlParser.IMPLIES)
                pass
            elif token in [6]:
                self.enterOuterAlt(localctx, 3)
                self.state = 47
                self.match(wstlParser.IFF)
                pass
            elif token in [19, 20]:
                self.enterOuterAlt(localctx, 4)
                self.state = 48
                _la = self._input.LA(1)
                if not(_la==19 or _la==20):
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


    class UnaryContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def comparison(self):
            return self.getTypedRuleContext(wstlParser.ComparisonContext,0)


        def joined(self):
            return self.getTypedRuleContext(wstlParser.JoinedContext,0)


        def prefix(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wstlParser.PrefixContext)
            else:
                return self.getTypedRuleContext(wstlParser.PrefixContext,i)


        def getRuleIndex(self):
            return wstlParser.RULE_unary




    def unary(self):

        localctx = wstlParser.UnaryContext(self, self._ctx, self.state)
        self.enterRule(localctx, 2, self.RULE_unary)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 58
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,3,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 55
                    self.prefix() 
                self.state = 60
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,3,self._ctx)

            self.state = 63
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [15, 16, 17, 18, 19, 20, 21, 22, 24, 25, 34, 35, 36, 39]:
                self.state = 61
                self.comparison()
                pass
            elif token in [2, 3]:
                self.state = 62
                self.joined()
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
            return self.getToken(wstlParser.NOT, 0)

        def NEXT(self):
            return self.getToken(wstlParser.NEXT, 0)

        def interval(self):
            return self.getTypedRuleContext(wstlParser.IntervalContext,0)


        def EVENTUALLY(self):
            return self.getToken(wstlParser.EVENTUALLY, 0)

        def DIAMOND(self):
            return self.getToken(wstlParser.DIAMOND, 0)

        def ALWAYS(self):
            return self.getToken(wstlParser.ALWAYS, 0)

        def BOX(self):
            return self.getToken(wstlParser.BOX, 0)

        def weight(self):
            return self.getTypedRuleContext(wstlParser.WeightContext,0)


        def getRuleIndex(self):
            return wstlParser.RULE_prefix




    def prefix(self):

        localctx = wstlParser.PrefixContext(self, self._ctx, self.state)
        self.enterRule(localctx, 4, self.RULE_prefix)
        self._la = 0 # Token type
        try:
            self.state = 72
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [4]:
                self.enterOuterAlt(localctx, 1)
                self.state = 65
                self.match(wstlParser.NOT)
                pass
            elif token in [21]:
                self.enterOuterAlt(localctx, 2)
                self.state = 66
                self.match(wstlParser.NEXT)
                pass
            elif token in [7, 8, 17, 18]:
                self.enterOuterAlt(localctx, 3)
                self.state = 67
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 393600) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 68
                self.interval()
                self.state = 70
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                if _la==1:
                    self.state = 69
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


    class JoinedContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def parts(self):
            return self.getTypedRuleContext(wstlParser.PartsContext,0)


        def AND(self):
            return self.getToken(wstlParser.AND, 0)

        def OR(self):
            return self.getToken(wstlParser.OR, 0)

        def weight(self):
            return self.getTypedRuleContext(wstlParser.WeightContext,0)


        def getRuleIndex(self):
            return wstlParser.RULE_joined




    def joined(self):

        localctx = wstlParser.JoinedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 6, self.RULE_joined)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 74
            _la = self._input.LA(1)
            if not(_la==2 or _la==3):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 76
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==1:
                self.state = 75
                self.weight()


            self.state = 78
            self.parts()
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
            return self.getToken(wstlParser.HAT, 0)

        def name(self):
            return self.getTypedRuleContext(wstlParser.NameContext,0)


        def value(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wstlParser.ValueContext)
            else:
                return self.getTypedRuleContext(wstlParser.ValueContext,i)


        def LBRACKET(self):
            return self.getToken(wstlParser.LBRACKET, 0)

        def RBRACKET(self):
            return self.getToken(wstlParser.RBRACKET, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(wstlParser.COMMA)
            else:
                return self.getToken(wstlParser.COMMA, i)

        def getRuleIndex(self):
            return wstlParser.RULE_weight




    def weight(self):

        localctx = wstlParser.WeightContext(self, self._ctx, self.state)
        self.enterRule(localctx, 8, self.RULE_weight)
        self._la = 0 # Token type
        try:
            self.state = 96
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,9,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 80
                self.match(wstlParser.HAT)
                self.state = 81
                self.name()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 82
                self.match(wstlParser.HAT)
                self.state = 83
                self.value()
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 84
                self.match(wstlParser.HAT)
                self.state = 85
                self.match(wstlParser.LBRACKET)
                self.state = 86
                self.value()
                self.state = 91
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==29:
                    self.state = 87
                    self.match(wstlParser.COMMA)
                    self.state = 88
                    self.value()
                    self.state = 93
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 94
                self.match(wstlParser.RBRACKET)
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
            return self.getToken(wstlParser.NUMBER, 0)

        def MINUS(self):
            return self.getToken(wstlParser.MINUS, 0)

        def getRuleIndex(self):
            return wstlParser.RULE_value




    def value(self):

        localctx = wstlParser.ValueContext(self, self._ctx, self.state)
        self.enterRule(localctx, 10, self.RULE_value)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 99
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==25:
                self.state = 98
                self.match(wstlParser.MINUS)


            self.state = 101
            self.match(wstlParser.NUMBER)
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

        def total(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wstlParser.TotalContext)
            else:
                return self.getTypedRuleContext(wstlParser.TotalContext,i)


        def relation(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wstlParser.RelationContext)
            else:
                return self.getTypedRuleContext(wstlParser.RelationContext,i)


        def getRuleIndex(self):
            return wstlParser.RULE_comparison




    def comparison(self):

        localctx = wstlParser.ComparisonContext(self, self._ctx, self.state)
        self.enterRule(localctx, 12, self.RULE_comparison)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 103
            self.total()
            self.state = 109
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 32256) != 0):
                self.state = 104
                self.relation()
                self.state = 105
                self.total()
                self.state = 111
                self._errHandler.sync(self)
                _la = self._input.LA(1)

        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class TotalContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def term(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wstlParser.TermContext)
            else:
                return self.getTypedRuleContext(wstlParser.TermContext,i)


        def PLUS(self, i:int=None):
            if i is None:
                return self.getTokens(wstlParser.PLUS)
            else:
                return self.getToken(wstlParser.PLUS, i)

        def MINUS(self, i:int=None):
            if i is None:
                return self.getTokens(wstlParser.MINUS)
            else:
                return self.getToken(wstlParser.MINUS, i)

        def getRuleIndex(self):
            return wstlParser.RULE_total




    def total(self):

        localctx = wstlParser.TotalContext(self, self._ctx, self.state)
        self.enterRule(localctx, 14, self.RULE_total)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 112
            self.term()
            self.state = 117
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==24 or _la==25:
                self.state = 113
                _la = self._input.LA(1)
                if not(_la==24 or _la==25):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 114
                self.term()
                self.state = 119
                self._errHandler.sync(self)
                _la = self._input.LA(1)

        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class TermContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def factor(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wstlParser.FactorContext)
            else:
                return self.getTypedRuleContext(wstlParser.FactorContext,i)


        def STAR(self, i:int=None):
            if i is None:
                return self.getTokens(wstlParser.STAR)
            else:
                return self.getToken(wstlParser.STAR, i)

        def SLASH(self, i:int=None):
            if i is None:
                return self.getTokens(wstlParser.SLASH)
            else:
                return self.getToken(wstlParser.SLASH, i)

        def getRuleIndex(self):
            return wstlParser.RULE_term




    def term(self):

        localctx = wstlParser.TermContext(self, self._ctx, self.state)
        self.enterRule(localctx, 16, self.RULE_term)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 120
            self.factor()
            self.state = 125
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==26 or _la==27:
                self.state = 121
                _la = self._input.LA(1)
                if not(_la==26 or _la==27):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 122
                self.factor()
                self.state = 127
                self._errHandler.sync(self)
                _la = self._input.LA(1)

        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class FactorContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def operand(self):
            return self.getTypedRuleContext(wstlParser.OperandContext,0)


        def PLUS(self, i:int=None):
            if i is None:
                return self.getTokens(wstlParser.PLUS)
            else:
                return self.getToken(wstlParser.PLUS, i)

        def MINUS(self, i:int=None):
            if i is None:
                return self.getTokens(wstlParser.MINUS)
            else:
                return self.getToken(wstlParser.MINUS, i)

        def getRuleIndex(self):
            return wstlParser.RULE_factor




    def factor(self):

        localctx = wstlParser.FactorContext(self, self._ctx, self.state)
        self.enterRule(localctx, 18, self.RULE_factor)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 131
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==24 or _la==25:
                self.state = 128
                _la = self._input.LA(1)
                if not(_la==24 or _la==25):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 133
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 134
            self.operand()
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
            return self.getTypedRuleContext(wstlParser.ConstantContext,0)


        def NUMBER(self):
            return self.getToken(wstlParser.NUMBER, 0)

        def name(self):
            return self.getTypedRuleContext(wstlParser.NameContext,0)


        def parts(self):
            return self.getTypedRuleContext(wstlParser.PartsContext,0)


        def getRuleIndex(self):
            return wstlParser.RULE_operand




    def operand(self):

        localctx = wstlParser.OperandContext(self, self._ctx, self.state)
        self.enterRule(localctx, 20, self.RULE_operand)
        try:
            self.state = 140
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [15, 16]:
                self.enterOuterAlt(localctx, 1)
                self.state = 136
                self.constant()
                pass
            elif token in [34]:
                self.enterOuterAlt(localctx, 2)
                self.state = 137
                self.match(wstlParser.NUMBER)
                pass
            elif token in [17, 18, 19, 20, 21, 35, 36]:
                self.enterOuterAlt(localctx, 3)
                self.state = 138
                self.name()
                pass
            elif token in [22, 39]:
                self.enterOuterAlt(localctx, 4)
                self.state = 139
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


    class ReservedContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def letter(self):
            return self.getTypedRuleContext(wstlParser.LetterContext,0)


        def getRuleIndex(self):
            return wstlParser.RULE_reserved




    def reserved(self):

        localctx = wstlParser.ReservedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 22, self.RULE_reserved)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 142
            self.letter()
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
                return self.getTypedRuleContexts(wstlParser.LevelContext)
            else:
                return self.getTypedRuleContext(wstlParser.LevelContext,i)


        def EOF(self):
            return self.getToken(wstlParser.EOF, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(wstlParser.COMMA)
            else:
                return self.getToken(wstlParser.COMMA, i)

        def getRuleIndex(self):
            return wstlParser.RULE_formula




    def formula(self):

        localctx = wstlParser.FormulaContext(self, self._ctx, self.state)
        self.enterRule(localctx, 24, self.RULE_formula)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 144
            self.level()
            self.state = 149
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==29:
                self.state = 145
                self.match(wstlParser.COMMA)
                self.state = 146
                self.level()
                self.state = 151
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 152
            self.match(wstlParser.EOF)
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
                return self.getTypedRuleContexts(wstlParser.UnaryContext)
            else:
                return self.getTypedRuleContext(wstlParser.UnaryContext,i)


        def connective(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wstlParser.ConnectiveContext)
            else:
                return self.getTypedRuleContext(wstlParser.ConnectiveContext,i)


        def getRuleIndex(self):
            return wstlParser.RULE_level




    def level(self):

        localctx = wstlParser.LevelContext(self, self._ctx, self.state)
        self.enterRule(localctx, 26, self.RULE_level)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 154
            self.unary()
            self.state = 160
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 1572972) != 0):
                self.state = 155
                self.connective()
                self.state = 156
                self.unary()
                self.state = 162
                self._errHandler.sync(self)
                _la = self._input.LA(1)

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
            return self.getToken(wstlParser.GROUP, 0)

        def OPEN(self):
            return self.getToken(wstlParser.OPEN, 0)

        def level(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wstlParser.LevelContext)
            else:
                return self.getTypedRuleContext(wstlParser.LevelContext,i)


        def CLOSE(self):
            return self.getToken(wstlParser.CLOSE, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(wstlParser.COMMA)
            else:
                return self.getToken(wstlParser.COMMA, i)

        def getRuleIndex(self):
            return wstlParser.RULE_parts




    def parts(self):

        localctx = wstlParser.PartsContext(self, self._ctx, self.state)
        self.enterRule(localctx, 28, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 175
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [39]:
                self.enterOuterAlt(localctx, 1)
                self.state = 163
                self.match(wstlParser.GROUP)
                pass
            elif token in [22]:
                self.enterOuterAlt(localctx, 2)
                self.state = 164
                self.match(wstlParser.OPEN)
                self.state = 165
                self.level()
                self.state = 170
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==29:
                    self.state = 166
                    self.match(wstlParser.COMMA)
                    self.state = 167
                    self.level()
                    self.state = 172
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 173
                self.match(wstlParser.CLOSE)
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
            return self.getToken(wstlParser.LBRACKET, 0)

        def bound(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wstlParser.BoundContext)
            else:
                return self.getTypedRuleContext(wstlParser.BoundContext,i)


        def COMMA(self):
            return self.getToken(wstlParser.COMMA, 0)

        def RBRACKET(self):
            return self.getToken(wstlParser.RBRACKET, 0)

        def getRuleIndex(self):
            return wstlParser.RULE_interval




    def interval(self):

        localctx = wstlParser.IntervalContext(self, self._ctx, self.state)
        self.enterRule(localctx, 30, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 177
            self.match(wstlParser.LBRACKET)
            self.state = 178
            self.bound()
            self.state = 179
            self.match(wstlParser.COMMA)
            self.state = 180
            self.bound()
            self.state = 181
            self.match(wstlParser.RBRACKET)
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
            return self.getToken(wstlParser.NUMBER, 0)

        def MINUS(self):
            return self.getToken(wstlParser.MINUS, 0)

        def getRuleIndex(self):
            return wstlParser.RULE_bound




    def bound(self):

        localctx = wstlParser.BoundContext(self, self._ctx, self.state)
        self.enterRule(localctx, 32, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 184
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==25:
                self.state = 183
                self.match(wstlParser.MINUS)


            self.state = 186
            self.match(wstlParser.NUMBER)
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
            return self.getToken(wstlParser.GE, 0)

        def LE(self):
            return self.getToken(wstlParser.LE, 0)

        def GT(self):
            return self.getToken(wstlParser.GT, 0)

        def LT(self):
            return self.getToken(wstlParser.LT, 0)

        def EQ(self):
            return self.getToken(wstlParser.EQ, 0)

        def NE(self):
            return self.getToken(wstlParser.NE, 0)

        def getRuleIndex(self):
            return wstlParser.RULE_relation




    def relation(self):

        localctx = wstlParser.RelationContext(self, self._ctx, self.state)
        self.enterRule(localctx, 34, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 188
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 32256) != 0)):
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
            return self.getToken(wstlParser.TRUE, 0)

        def FALSE(self):
            return self.getToken(wstlParser.FALSE, 0)

        def getRuleIndex(self):
            return wstlParser.RULE_constant




    def constant(self):

        localctx = wstlParser.ConstantContext(self, self._ctx, self.state)
        self.enterRule(localctx, 36, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 190
            _la = self._input.LA(1)
            if not(_la==15 or _la==16):
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
            return self.getToken(wstlParser.NAME, 0)

        def STRING(self):
            return self.getToken(wstlParser.STRING, 0)

        def reserved(self):
            return self.getTypedRuleContext(wstlParser.ReservedContext,0)


        def getRuleIndex(self):
            return wstlParser.RULE_name




    def name(self):

        localctx = wstlParser.NameContext(self, self._ctx, self.state)
        self.enterRule(localctx, 38, self.RULE_name)
        try:
            self.state = 195
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [35]:
                self.enterOuterAlt(localctx, 1)
                self.state = 192
                self.match(wstlParser.NAME)
                pass
            elif token in [36]:
                self.enterOuterAlt(localctx, 2)
                self.state = 193
                self.match(wstlParser.STRING)
                pass
            elif token in [17, 18, 19, 20, 21]:
                self.enterOuterAlt(localctx, 3)
                self.state = 194
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
            return self.getToken(wstlParser.EVENTUALLY, 0)

        def ALWAYS(self):
            return self.getToken(wstlParser.ALWAYS, 0)

        def UNTIL(self):
            return self.getToken(wstlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(wstlParser.RELEASE, 0)

        def NEXT(self):
            return self.getToken(wstlParser.NEXT, 0)

        def getRuleIndex(self):
            return wstlParser.RULE_letter




    def letter(self):

        localctx = wstlParser.LetterContext(self, self._ctx, self.state)
        self.enterRule(localctx, 40, self.RULE_letter)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 197
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 4063232) != 0)):
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





