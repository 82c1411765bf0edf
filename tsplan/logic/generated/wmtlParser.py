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
        4,1,45,214,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,2,19,7,19,2,20,
        7,20,2,21,7,21,1,0,1,0,3,0,47,8,0,1,0,1,0,1,0,1,0,1,0,3,0,54,8,0,
        3,0,56,8,0,1,1,1,1,1,1,1,1,1,1,3,1,63,8,1,1,1,1,1,3,1,67,8,1,1,2,
        1,2,3,2,71,8,2,1,2,1,2,1,2,3,2,76,8,2,1,3,1,3,1,3,1,3,1,3,1,3,1,
        3,1,3,1,3,5,3,87,8,3,10,3,12,3,90,9,3,1,3,1,3,3,3,94,8,3,1,4,3,4,
        97,8,4,1,4,1,4,1,5,1,5,1,5,1,5,5,5,105,8,5,10,5,12,5,108,9,5,1,6,
        1,6,1,6,1,6,3,6,114,8,6,1,7,3,7,117,8,7,1,7,1,7,3,7,121,8,7,1,8,
        1,8,1,8,3,8,126,8,8,1,9,1,9,1,9,1,9,1,9,3,9,133,8,9,1,9,1,9,1,10,
        1,10,1,10,1,10,1,10,1,11,1,11,1,11,1,11,1,11,3,11,147,8,11,1,12,
        1,12,1,12,5,12,152,8,12,10,12,12,12,155,9,12,1,12,1,12,1,13,1,13,
        1,13,1,13,5,13,163,8,13,10,13,12,13,166,9,13,1,14,5,14,169,8,14,
        10,14,12,14,172,9,14,1,14,1,14,3,14,176,8,14,1,15,1,15,1,15,1,15,
        1,15,5,15,183,8,15,10,15,12,15,186,9,15,1,15,1,15,3,15,190,8,15,
        1,16,1,16,1,16,1,16,1,16,1,16,1,17,3,17,199,8,17,1,17,1,17,1,18,
        1,18,1,19,1,19,1,20,1,20,1,20,3,20,210,8,20,1,21,1,21,1,21,1,170,
        0,22,0,2,4,6,8,10,12,14,16,18,20,22,24,26,28,30,32,34,36,38,40,42,
        0,8,1,0,6,7,1,0,23,24,2,0,11,12,21,22,1,0,26,27,1,0,2,4,1,0,13,18,
        1,0,19,20,1,0,21,27,228,0,55,1,0,0,0,2,66,1,0,0,0,4,75,1,0,0,0,6,
        93,1,0,0,0,8,96,1,0,0,0,10,100,1,0,0,0,12,113,1,0,0,0,14,116,1,0,
        0,0,16,125,1,0,0,0,18,127,1,0,0,0,20,136,1,0,0,0,22,146,1,0,0,0,
        24,148,1,0,0,0,26,158,1,0,0,0,28,170,1,0,0,0,30,189,1,0,0,0,32,191,
        1,0,0,0,34,198,1,0,0,0,36,202,1,0,0,0,38,204,1,0,0,0,40,209,1,0,
        0,0,42,211,1,0,0,0,44,46,7,0,0,0,45,47,3,6,3,0,46,45,1,0,0,0,46,
        47,1,0,0,0,47,56,1,0,0,0,48,56,5,9,0,0,49,56,5,10,0,0,50,51,7,1,
        0,0,51,53,3,32,16,0,52,54,3,6,3,0,53,52,1,0,0,0,53,54,1,0,0,0,54,
        56,1,0,0,0,55,44,1,0,0,0,55,48,1,0,0,0,55,49,1,0,0,0,55,50,1,0,0,
        0,56,1,1,0,0,0,57,67,5,8,0,0,58,67,5,25,0,0,59,60,7,2,0,0,60,62,
        3,32,16,0,61,63,3,6,3,0,62,61,1,0,0,0,62,63,1,0,0,0,63,67,1,0,0,
        0,64,65,7,3,0,0,65,67,3,32,16,0,66,57,1,0,0,0,66,58,1,0,0,0,66,59,
        1,0,0,0,66,64,1,0,0,0,67,3,1,0,0,0,68,70,7,0,0,0,69,71,3,6,3,0,70,
        69,1,0,0,0,70,71,1,0,0,0,71,72,1,0,0,0,72,76,3,30,15,0,73,74,7,3,
        0,0,74,76,3,30,15,0,75,68,1,0,0,0,75,73,1,0,0,0,76,5,1,0,0,0,77,
        78,5,1,0,0,78,94,3,40,20,0,79,80,5,1,0,0,80,94,3,8,4,0,81,82,5,1,
        0,0,82,83,5,36,0,0,83,88,3,8,4,0,84,85,5,35,0,0,85,87,3,8,4,0,86,
        84,1,0,0,0,87,90,1,0,0,0,88,86,1,0,0,0,88,89,1,0,0,0,89,91,1,0,0,
        0,90,88,1,0,0,0,91,92,5,37,0,0,92,94,1,0,0,0,93,77,1,0,0,0,93,79,
        1,0,0,0,93,81,1,0,0,0,94,7,1,0,0,0,95,97,5,31,0,0,96,95,1,0,0,0,
        96,97,1,0,0,0,97,98,1,0,0,0,98,99,5,40,0,0,99,9,1,0,0,0,100,106,
        3,12,6,0,101,102,3,36,18,0,102,103,3,12,6,0,103,105,1,0,0,0,104,
        101,1,0,0,0,105,108,1,0,0,0,106,104,1,0,0,0,106,107,1,0,0,0,107,
        11,1,0,0,0,108,106,1,0,0,0,109,114,3,38,19,0,110,114,3,14,7,0,111,
        114,3,16,8,0,112,114,3,30,15,0,113,109,1,0,0,0,113,110,1,0,0,0,113,
        111,1,0,0,0,113,112,1,0,0,0,114,13,1,0,0,0,115,117,5,31,0,0,116,
        115,1,0,0,0,116,117,1,0,0,0,117,118,1,0,0,0,118,120,5,40,0,0,119,
        121,5,34,0,0,120,119,1,0,0,0,120,121,1,0,0,0,121,15,1,0,0,0,122,
        126,3,18,9,0,123,126,3,20,10,0,124,126,3,40,20,0,125,122,1,0,0,0,
        125,123,1,0,0,0,125,124,1,0,0,0,126,17,1,0,0,0,127,128,7,4,0,0,128,
        129,5,28,0,0,129,132,3,40,20,0,130,131,5,35,0,0,131,133,3,40,20,
        0,132,130,1,0,0,0,132,133,1,0,0,0,133,134,1,0,0,0,134,135,5,29,0,
        0,135,19,1,0,0,0,136,137,5,5,0,0,137,138,5,28,0,0,138,139,3,14,7,
        0,139,140,5,29,0,0,140,21,1,0,0,0,141,147,3,42,21,0,142,147,5,2,
        0,0,143,147,5,3,0,0,144,147,5,4,0,0,145,147,5,5,0,0,146,141,1,0,
        0,0,146,142,1,0,0,0,146,143,1,0,0,0,146,144,1,0,0,0,146,145,1,0,
        0,0,147,23,1,0,0,0,148,153,3,26,13,0,149,150,5,35,0,0,150,152,3,
        26,13,0,151,149,1,0,0,0,152,155,1,0,0,0,153,151,1,0,0,0,153,154,
        1,0,0,0,154,156,1,0,0,0,155,153,1,0,0,0,156,157,5,0,0,1,157,25,1,
        0,0,0,158,164,3,28,14,0,159,160,3,0,0,0,160,161,3,28,14,0,161,163,
        1,0,0,0,162,159,1,0,0,0,163,166,1,0,0,0,164,162,1,0,0,0,164,165,
        1,0,0,0,165,27,1,0,0,0,166,164,1,0,0,0,167,169,3,2,1,0,168,167,1,
        0,0,0,169,172,1,0,0,0,170,171,1,0,0,0,170,168,1,0,0,0,171,175,1,
        0,0,0,172,170,1,0,0,0,173,176,3,10,5,0,174,176,3,4,2,0,175,173,1,
        0,0,0,175,174,1,0,0,0,176,29,1,0,0,0,177,190,5,45,0,0,178,179,5,
        28,0,0,179,184,3,26,13,0,180,181,5,35,0,0,181,183,3,26,13,0,182,
        180,1,0,0,0,183,186,1,0,0,0,184,182,1,0,0,0,184,185,1,0,0,0,185,
        187,1,0,0,0,186,184,1,0,0,0,187,188,5,29,0,0,188,190,1,0,0,0,189,
        177,1,0,0,0,189,178,1,0,0,0,190,31,1,0,0,0,191,192,5,36,0,0,192,
        193,3,34,17,0,193,194,5,35,0,0,194,195,3,34,17,0,195,196,5,37,0,
        0,196,33,1,0,0,0,197,199,5,31,0,0,198,197,1,0,0,0,198,199,1,0,0,
        0,199,200,1,0,0,0,200,201,5,40,0,0,201,35,1,0,0,0,202,203,7,5,0,
        0,203,37,1,0,0,0,204,205,7,6,0,0,205,39,1,0,0,0,206,210,5,41,0,0,
        207,210,5,42,0,0,208,210,3,22,11,0,209,206,1,0,0,0,209,207,1,0,0,
        0,209,208,1,0,0,0,210,41,1,0,0,0,211,212,7,7,0,0,212,43,1,0,0,0,
        25,46,53,55,62,66,70,75,88,93,96,106,113,116,120,125,132,146,153,
        164,170,175,184,189,198,209
    ]

class wmtlParser ( Parser ):

    grammarFileName = "wmtl.g4"

    atn = ATNDeserializer().deserialize(serializedATN())

    decisionsToDFA = [ DFA(ds, i) for i, ds in enumerate(atn.decisionToState) ]

    sharedContextCache = PredictionContextCache()

    literalNames = [ "<INVALID>", "'^'", "'sum'", "'min'", "'max'", "'known'", 
                     "<INVALID>", "<INVALID>", "<INVALID>", "<INVALID>", 
                     "<INVALID>", "'<>'", "'[]'", "'>='", "'<='", "'>'", 
                     "'<'", "<INVALID>", "'!='", "<INVALID>", "<INVALID>", 
                     "'F'", "'G'", "'U'", "'R'", "'X'", "'one'", "'all'", 
                     "'('", "')'", "'+'", "'-'", "'*'", "'/'", "'%'", "','", 
                     "'['", "']'", "'{'", "'}'" ]

    symbolicNames = [ "<INVALID>", "HAT", "SUM", "MIN", "MAX", "KNOWN", 
                      "AND", "OR", "NOT", "IMPLIES", "IFF", "DIAMOND", "BOX", 
                      "GE", "LE", "GT", "LT", "EQ", "NE", "TRUE", "FALSE", 
                      "EVENTUALLY", "ALWAYS", "UNTIL", "RELEASE", "NEXT", 
                      "ONE", "ALL", "OPEN", "CLOSE", "PLUS", "MINUS", "STAR", 
                      "SLASH", "PERCENT", "COMMA", "LBRACKET", "RBRACKET", 
                      "LBRACE", "RBRACE", "NUMBER", "NAME", "STRING", "SPACE", 
                      "STRAY", "GROUP" ]

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
    RULE_known = 10
    RULE_reserved = 11
    RULE_formula = 12
    RULE_level = 13
    RULE_unary = 14
    RULE_parts = 15
    RULE_interval = 16
    RULE_bound = 17
    RULE_relation = 18
    RULE_constant = 19
    RULE_name = 20
    RULE_word = 21

    ruleNames =  [ "connective", "prefix", "joined", "weight", "value", 
                   "comparison", "operand", "number", "atom", "count", "known", 
                   "reserved", "formula", "level", "unary", "parts", "interval", 
                   "bound", "relation", "constant", "name", "word" ]

    EOF = Token.EOF
    HAT=1
    SUM=2
    MIN=3
    MAX=4
    KNOWN=5
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
    ONE=26
    ALL=27
    OPEN=28
    CLOSE=29
    PLUS=30
    MINUS=31
    STAR=32
    SLASH=33
    PERCENT=34
    COMMA=35
    LBRACKET=36
    RBRACKET=37
    LBRACE=38
    RBRACE=39
    NUMBER=40
    NAME=41
    STRING=42
    SPACE=43
    STRAY=44
    GROUP=45

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
            self.state = 55
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [6, 7]:
                self.enterOuterAlt(localctx, 1)
                self.state = 44
                _la = self._input.LA(1)
                if not(_la==6 or _la==7):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 46
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                if _la==1:
                    self.state = 45
                    self.weight()


                pass
            elif token in [9]:
                self.enterOuterAlt(localctx, 2)
                self.state = 48
                self.match(wmtlParser.IMPLIES)
                pass
            elif token in [10]:
                self.enterOuterAlt(localctx, 3)
                self.state = 49
                self.match(wmtlParser.IFF)
                pass
            elif token in [23, 24]:
                self.enterOuterAlt(localctx, 4)
                self.state = 50
                _la = self._input.LA(1)
                if not(_la==23 or _la==24):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 51
                self.interval()
                self.state = 53
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                if _la==1:
                    self.state = 52
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
            self.state = 66
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [8]:
                self.enterOuterAlt(localctx, 1)
                self.state = 57
                self.match(wmtlParser.NOT)
                pass
            elif token in [25]:
                self.enterOuterAlt(localctx, 2)
                self.state = 58
                self.match(wmtlParser.NEXT)
                pass
            elif token in [11, 12, 21, 22]:
                self.enterOuterAlt(localctx, 3)
                self.state = 59
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 6297600) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 60
                self.interval()
                self.state = 62
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                if _la==1:
                    self.state = 61
                    self.weight()


                pass
            elif token in [26, 27]:
                self.enterOuterAlt(localctx, 4)
                self.state = 64
                _la = self._input.LA(1)
                if not(_la==26 or _la==27):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 65
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
            self.state = 75
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [6, 7]:
                self.enterOuterAlt(localctx, 1)
                self.state = 68
                _la = self._input.LA(1)
                if not(_la==6 or _la==7):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 70
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                if _la==1:
                    self.state = 69
                    self.weight()


                self.state = 72
                self.parts()
                pass
            elif token in [26, 27]:
                self.enterOuterAlt(localctx, 2)
                self.state = 73
                _la = self._input.LA(1)
                if not(_la==26 or _la==27):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 74
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
            self.state = 93
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,8,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 77
                self.match(wmtlParser.HAT)
                self.state = 78
                self.name()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 79
                self.match(wmtlParser.HAT)
                self.state = 80
                self.value()
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 81
                self.match(wmtlParser.HAT)
                self.state = 82
                self.match(wmtlParser.LBRACKET)
                self.state = 83
                self.value()
                self.state = 88
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==35:
                    self.state = 84
                    self.match(wmtlParser.COMMA)
                    self.state = 85
                    self.value()
                    self.state = 90
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 91
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
            self.state = 96
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==31:
                self.state = 95
                self.match(wmtlParser.MINUS)


            self.state = 98
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
            self.state = 100
            self.operand()
            self.state = 106
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 516096) != 0):
                self.state = 101
                self.relation()
                self.state = 102
                self.operand()
                self.state = 108
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
            self.state = 113
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [19, 20]:
                self.enterOuterAlt(localctx, 1)
                self.state = 109
                self.constant()
                pass
            elif token in [31, 40]:
                self.enterOuterAlt(localctx, 2)
                self.state = 110
                self.number()
                pass
            elif token in [2, 3, 4, 5, 21, 22, 23, 24, 25, 26, 27, 41, 42]:
                self.enterOuterAlt(localctx, 3)
                self.state = 111
                self.atom()
                pass
            elif token in [28, 45]:
                self.enterOuterAlt(localctx, 4)
                self.state = 112
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
            self.state = 116
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==31:
                self.state = 115
                self.match(wmtlParser.MINUS)


            self.state = 118
            self.match(wmtlParser.NUMBER)
            self.state = 120
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==34:
                self.state = 119
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


        def known(self):
            return self.getTypedRuleContext(wmtlParser.KnownContext,0)


        def name(self):
            return self.getTypedRuleContext(wmtlParser.NameContext,0)


        def getRuleIndex(self):
            return wmtlParser.RULE_atom




    def atom(self):

        localctx = wmtlParser.AtomContext(self, self._ctx, self.state)
        self.enterRule(localctx, 16, self.RULE_atom)
        try:
            self.state = 125
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,14,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 122
                self.count()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 123
                self.known()
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 124
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
            self.state = 127
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 28) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 128
            self.match(wmtlParser.OPEN)
            self.state = 129
            self.name()
            self.state = 132
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==35:
                self.state = 130
                self.match(wmtlParser.COMMA)
                self.state = 131
                self.name()


            self.state = 134
            self.match(wmtlParser.CLOSE)
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class KnownContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def KNOWN(self):
            return self.getToken(wmtlParser.KNOWN, 0)

        def OPEN(self):
            return self.getToken(wmtlParser.OPEN, 0)

        def number(self):
            return self.getTypedRuleContext(wmtlParser.NumberContext,0)


        def CLOSE(self):
            return self.getToken(wmtlParser.CLOSE, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_known




    def known(self):

        localctx = wmtlParser.KnownContext(self, self._ctx, self.state)
        self.enterRule(localctx, 20, self.RULE_known)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 136
            self.match(wmtlParser.KNOWN)
            self.state = 137
            self.match(wmtlParser.OPEN)
            self.state = 138
            self.number()
            self.state = 139
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

        def KNOWN(self):
            return self.getToken(wmtlParser.KNOWN, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_reserved




    def reserved(self):

        localctx = wmtlParser.ReservedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 22, self.RULE_reserved)
        try:
            self.state = 146
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [21, 22, 23, 24, 25, 26, 27]:
                self.enterOuterAlt(localctx, 1)
                self.state = 141
                self.word()
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 2)
                self.state = 142
                self.match(wmtlParser.SUM)
                pass
            elif token in [3]:
                self.enterOuterAlt(localctx, 3)
                self.state = 143
                self.match(wmtlParser.MIN)
                pass
            elif token in [4]:
                self.enterOuterAlt(localctx, 4)
                self.state = 144
                self.match(wmtlParser.MAX)
                pass
            elif token in [5]:
                self.enterOuterAlt(localctx, 5)
                self.state = 145
                self.match(wmtlParser.KNOWN)
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
        self.enterRule(localctx, 24, self.RULE_formula)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 148
            self.level()
            self.state = 153
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==35:
                self.state = 149
                self.match(wmtlParser.COMMA)
                self.state = 150
                self.level()
                self.state = 155
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 156
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
        self.enterRule(localctx, 26, self.RULE_level)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 158
            self.unary()
            self.state = 164
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 25167552) != 0):
                self.state = 159
                self.connective()
                self.state = 160
                self.unary()
                self.state = 166
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
        self.enterRule(localctx, 28, self.RULE_unary)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 170
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,19,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 167
                    self.prefix() 
                self.state = 172
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,19,self._ctx)

            self.state = 175
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,20,self._ctx)
            if la_ == 1:
                self.state = 173
                self.comparison()
                pass

            elif la_ == 2:
                self.state = 174
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
        self.enterRule(localctx, 30, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 189
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [45]:
                self.enterOuterAlt(localctx, 1)
                self.state = 177
                self.match(wmtlParser.GROUP)
                pass
            elif token in [28]:
                self.enterOuterAlt(localctx, 2)
                self.state = 178
                self.match(wmtlParser.OPEN)
                self.state = 179
                self.level()
                self.state = 184
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==35:
                    self.state = 180
                    self.match(wmtlParser.COMMA)
                    self.state = 181
                    self.level()
                    self.state = 186
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 187
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
        self.enterRule(localctx, 32, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 191
            self.match(wmtlParser.LBRACKET)
            self.state = 192
            self.bound()
            self.state = 193
            self.match(wmtlParser.COMMA)
            self.state = 194
            self.bound()
            self.state = 195
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
        self.enterRule(localctx, 34, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 198
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==31:
                self.state = 197
                self.match(wmtlParser.MINUS)


            self.state = 200
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
        self.enterRule(localctx, 36, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 202
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
            return self.getToken(wmtlParser.TRUE, 0)

        def FALSE(self):
            return self.getToken(wmtlParser.FALSE, 0)

        def getRuleIndex(self):
            return wmtlParser.RULE_constant




    def constant(self):

        localctx = wmtlParser.ConstantContext(self, self._ctx, self.state)
        self.enterRule(localctx, 38, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 204
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
            return self.getToken(wmtlParser.NAME, 0)

        def STRING(self):
            return self.getToken(wmtlParser.STRING, 0)

        def reserved(self):
            return self.getTypedRuleContext(wmtlParser.ReservedContext,0)


        def getRuleIndex(self):
            return wmtlParser.RULE_name




    def name(self):

        localctx = wmtlParser.NameContext(self, self._ctx, self.state)
        self.enterRule(localctx, 40, self.RULE_name)
        try:
            self.state = 209
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [41]:
                self.enterOuterAlt(localctx, 1)
                self.state = 206
                self.match(wmtlParser.NAME)
                pass
            elif token in [42]:
                self.enterOuterAlt(localctx, 2)
                self.state = 207
                self.match(wmtlParser.STRING)
                pass
            elif token in [2, 3, 4, 5, 21, 22, 23, 24, 25, 26, 27]:
                self.enterOuterAlt(localctx, 3)
                self.state = 208
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
        self.enterRule(localctx, 42, self.RULE_word)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 211
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 266338304) != 0)):
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





