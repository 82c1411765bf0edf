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
        4,1,44,221,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,2,19,7,19,2,20,
        7,20,2,21,7,21,1,0,1,0,3,0,47,8,0,1,0,1,0,1,0,1,0,1,0,3,0,54,8,0,
        3,0,56,8,0,1,1,1,1,1,1,1,1,1,1,3,1,63,8,1,1,1,1,1,3,1,67,8,1,1,2,
        1,2,3,2,71,8,2,1,2,1,2,1,2,3,2,76,8,2,1,3,1,3,1,3,1,3,1,3,1,3,1,
        3,1,3,1,3,5,3,87,8,3,10,3,12,3,90,9,3,1,3,1,3,3,3,94,8,3,1,4,3,4,
        97,8,4,1,4,1,4,1,5,1,5,1,5,1,5,5,5,105,8,5,10,5,12,5,108,9,5,1,6,
        1,6,1,6,5,6,113,8,6,10,6,12,6,116,9,6,1,7,1,7,1,7,5,7,121,8,7,10,
        7,12,7,124,9,7,1,8,5,8,127,8,8,10,8,12,8,130,9,8,1,8,1,8,1,9,1,9,
        1,9,1,9,1,9,3,9,139,8,9,1,10,1,10,1,10,1,10,1,10,3,10,146,8,10,1,
        10,1,10,1,11,1,11,1,11,1,11,3,11,154,8,11,1,12,1,12,1,12,5,12,159,
        8,12,10,12,12,12,162,9,12,1,12,1,12,1,13,1,13,1,13,1,13,5,13,170,
        8,13,10,13,12,13,173,9,13,1,14,5,14,176,8,14,10,14,12,14,179,9,14,
        1,14,1,14,3,14,183,8,14,1,15,1,15,1,15,1,15,1,15,5,15,190,8,15,10,
        15,12,15,193,9,15,1,15,1,15,3,15,197,8,15,1,16,1,16,1,16,1,16,1,
        16,1,16,1,17,3,17,206,8,17,1,17,1,17,1,18,1,18,1,19,1,19,1,20,1,
        20,1,20,3,20,217,8,20,1,21,1,21,1,21,1,177,0,22,0,2,4,6,8,10,12,
        14,16,18,20,22,24,26,28,30,32,34,36,38,40,42,0,10,1,0,5,6,1,0,22,
        23,2,0,10,11,20,21,1,0,25,26,1,0,29,30,1,0,31,32,1,0,2,4,1,0,12,
        17,1,0,18,19,1,0,20,26,234,0,55,1,0,0,0,2,66,1,0,0,0,4,75,1,0,0,
        0,6,93,1,0,0,0,8,96,1,0,0,0,10,100,1,0,0,0,12,109,1,0,0,0,14,117,
        1,0,0,0,16,128,1,0,0,0,18,138,1,0,0,0,20,140,1,0,0,0,22,153,1,0,
        0,0,24,155,1,0,0,0,26,165,1,0,0,0,28,177,1,0,0,0,30,196,1,0,0,0,
        32,198,1,0,0,0,34,205,1,0,0,0,36,209,1,0,0,0,38,211,1,0,0,0,40,216,
        1,0,0,0,42,218,1,0,0,0,44,46,7,0,0,0,45,47,3,6,3,0,46,45,1,0,0,0,
        46,47,1,0,0,0,47,56,1,0,0,0,48,56,5,8,0,0,49,56,5,9,0,0,50,51,7,
        1,0,0,51,53,3,32,16,0,52,54,3,6,3,0,53,52,1,0,0,0,53,54,1,0,0,0,
        54,56,1,0,0,0,55,44,1,0,0,0,55,48,1,0,0,0,55,49,1,0,0,0,55,50,1,
        0,0,0,56,1,1,0,0,0,57,67,5,7,0,0,58,67,5,24,0,0,59,60,7,2,0,0,60,
        62,3,32,16,0,61,63,3,6,3,0,62,61,1,0,0,0,62,63,1,0,0,0,63,67,1,0,
        0,0,64,65,7,3,0,0,65,67,3,32,16,0,66,57,1,0,0,0,66,58,1,0,0,0,66,
        59,1,0,0,0,66,64,1,0,0,0,67,3,1,0,0,0,68,70,7,0,0,0,69,71,3,6,3,
        0,70,69,1,0,0,0,70,71,1,0,0,0,71,72,1,0,0,0,72,76,3,30,15,0,73,74,
        7,3,0,0,74,76,3,30,15,0,75,68,1,0,0,0,75,73,1,0,0,0,76,5,1,0,0,0,
        77,78,5,1,0,0,78,94,3,40,20,0,79,80,5,1,0,0,80,94,3,8,4,0,81,82,
        5,1,0,0,82,83,5,35,0,0,83,88,3,8,4,0,84,85,5,34,0,0,85,87,3,8,4,
        0,86,84,1,0,0,0,87,90,1,0,0,0,88,86,1,0,0,0,88,89,1,0,0,0,89,91,
        1,0,0,0,90,88,1,0,0,0,91,92,5,36,0,0,92,94,1,0,0,0,93,77,1,0,0,0,
        93,79,1,0,0,0,93,81,1,0,0,0,94,7,1,0,0,0,95,97,5,30,0,0,96,95,1,
        0,0,0,96,97,1,0,0,0,97,98,1,0,0,0,98,99,5,39,0,0,99,9,1,0,0,0,100,
        106,3,12,6,0,101,102,3,36,18,0,102,103,3,12,6,0,103,105,1,0,0,0,
        104,101,1,0,0,0,105,108,1,0,0,0,106,104,1,0,0,0,106,107,1,0,0,0,
        107,11,1,0,0,0,108,106,1,0,0,0,109,114,3,14,7,0,110,111,7,4,0,0,
        111,113,3,14,7,0,112,110,1,0,0,0,113,116,1,0,0,0,114,112,1,0,0,0,
        114,115,1,0,0,0,115,13,1,0,0,0,116,114,1,0,0,0,117,122,3,16,8,0,
        118,119,7,5,0,0,119,121,3,16,8,0,120,118,1,0,0,0,121,124,1,0,0,0,
        122,120,1,0,0,0,122,123,1,0,0,0,123,15,1,0,0,0,124,122,1,0,0,0,125,
        127,7,4,0,0,126,125,1,0,0,0,127,130,1,0,0,0,128,126,1,0,0,0,128,
        129,1,0,0,0,129,131,1,0,0,0,130,128,1,0,0,0,131,132,3,18,9,0,132,
        17,1,0,0,0,133,139,3,38,19,0,134,139,5,39,0,0,135,139,3,40,20,0,
        136,139,3,20,10,0,137,139,3,30,15,0,138,133,1,0,0,0,138,134,1,0,
        0,0,138,135,1,0,0,0,138,136,1,0,0,0,138,137,1,0,0,0,139,19,1,0,0,
        0,140,141,7,6,0,0,141,142,5,27,0,0,142,145,3,40,20,0,143,144,5,34,
        0,0,144,146,3,40,20,0,145,143,1,0,0,0,145,146,1,0,0,0,146,147,1,
        0,0,0,147,148,5,28,0,0,148,21,1,0,0,0,149,154,3,42,21,0,150,154,
        5,2,0,0,151,154,5,3,0,0,152,154,5,4,0,0,153,149,1,0,0,0,153,150,
        1,0,0,0,153,151,1,0,0,0,153,152,1,0,0,0,154,23,1,0,0,0,155,160,3,
        26,13,0,156,157,5,34,0,0,157,159,3,26,13,0,158,156,1,0,0,0,159,162,
        1,0,0,0,160,158,1,0,0,0,160,161,1,0,0,0,161,163,1,0,0,0,162,160,
        1,0,0,0,163,164,5,0,0,1,164,25,1,0,0,0,165,171,3,28,14,0,166,167,
        3,0,0,0,167,168,3,28,14,0,168,170,1,0,0,0,169,166,1,0,0,0,170,173,
        1,0,0,0,171,169,1,0,0,0,171,172,1,0,0,0,172,27,1,0,0,0,173,171,1,
        0,0,0,174,176,3,2,1,0,175,174,1,0,0,0,176,179,1,0,0,0,177,178,1,
        0,0,0,177,175,1,0,0,0,178,182,1,0,0,0,179,177,1,0,0,0,180,183,3,
        10,5,0,181,183,3,4,2,0,182,180,1,0,0,0,182,181,1,0,0,0,183,29,1,
        0,0,0,184,197,5,44,0,0,185,186,5,27,0,0,186,191,3,26,13,0,187,188,
        5,34,0,0,188,190,3,26,13,0,189,187,1,0,0,0,190,193,1,0,0,0,191,189,
        1,0,0,0,191,192,1,0,0,0,192,194,1,0,0,0,193,191,1,0,0,0,194,195,
        5,28,0,0,195,197,1,0,0,0,196,184,1,0,0,0,196,185,1,0,0,0,197,31,
        1,0,0,0,198,199,5,35,0,0,199,200,3,34,17,0,200,201,5,34,0,0,201,
        202,3,34,17,0,202,203,5,36,0,0,203,33,1,0,0,0,204,206,5,30,0,0,205,
        204,1,0,0,0,205,206,1,0,0,0,206,207,1,0,0,0,207,208,5,39,0,0,208,
        35,1,0,0,0,209,210,7,7,0,0,210,37,1,0,0,0,211,212,7,8,0,0,212,39,
        1,0,0,0,213,217,5,40,0,0,214,217,5,41,0,0,215,217,3,22,11,0,216,
        213,1,0,0,0,216,214,1,0,0,0,216,215,1,0,0,0,217,41,1,0,0,0,218,219,
        7,9,0,0,219,43,1,0,0,0,25,46,53,55,62,66,70,75,88,93,96,106,114,
        122,128,138,145,153,160,171,177,182,191,196,205,216
    ]

class wstlParser ( Parser ):

    grammarFileName = "wstl.g4"

    atn = ATNDeserializer().deserialize(serializedATN())

    decisionsToDFA = [ DFA(ds, i) for i, ds in enumerate(atn.decisionToState) ]

    sharedContextCache = PredictionContextCache()

    literalNames = [ "<INVALID>", "'^'", "'in'", "'out'", "'clear'", "<INVALID>", 
                     "<INVALID>", "<INVALID>", "<INVALID>", "<INVALID>", 
                     "'<>'", "'[]'", "'>='", "'<='", "'>'", "'<'", "<INVALID>", 
                     "'!='", "<INVALID>", "<INVALID>", "'F'", "'G'", "'U'", 
                     "'R'", "'X'", "'one'", "'all'", "'('", "')'", "'+'", 
                     "'-'", "'*'", "'/'", "'%'", "','", "'['", "']'", "'{'", 
                     "'}'" ]

    symbolicNames = [ "<INVALID>", "HAT", "IN", "OUT", "CLEAR", "AND", "OR", 
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
    RULE_total = 6
    RULE_term = 7
    RULE_factor = 8
    RULE_operand = 9
    RULE_region = 10
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
                   "comparison", "total", "term", "factor", "operand", "region", 
                   "reserved", "formula", "level", "unary", "parts", "interval", 
                   "bound", "relation", "constant", "name", "word" ]

    EOF = Token.EOF
    HAT=1
    IN=2
    OUT=3
    CLEAR=4
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
            self.state = 55
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [5, 6]:
                self.enterOuterAlt(localctx, 1)
                self.state = 44
                _la = self._input.LA(1)
                if not(_la==5 or _la==6):
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
            elif token in [8]:
                self.enterOuterAlt(localctx, 2)
                self.state = 48
                self.match(wstlParser.IMPLIES)
                pass
            elif token in [9]:
                self.enterOuterAlt(localctx, 3)
                self.state = 49
                self.match(wstlParser.IFF)
                pass
            elif token in [22, 23]:
                self.enterOuterAlt(localctx, 4)
                self.state = 50
                _la = self._input.LA(1)
                if not(_la==22 or _la==23):
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


        def ONE(self):
            return self.getToken(wstlParser.ONE, 0)

        def ALL(self):
            return self.getToken(wstlParser.ALL, 0)

        def getRuleIndex(self):
            return wstlParser.RULE_prefix




    def prefix(self):

        localctx = wstlParser.PrefixContext(self, self._ctx, self.state)
        self.enterRule(localctx, 2, self.RULE_prefix)
        self._la = 0 # Token type
        try:
            self.state = 66
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [7]:
                self.enterOuterAlt(localctx, 1)
                self.state = 57
                self.match(wstlParser.NOT)
                pass
            elif token in [24]:
                self.enterOuterAlt(localctx, 2)
                self.state = 58
                self.match(wstlParser.NEXT)
                pass
            elif token in [10, 11, 20, 21]:
                self.enterOuterAlt(localctx, 3)
                self.state = 59
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 3148800) != 0)):
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
            elif token in [25, 26]:
                self.enterOuterAlt(localctx, 4)
                self.state = 64
                _la = self._input.LA(1)
                if not(_la==25 or _la==26):
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
            return self.getTypedRuleContext(wstlParser.PartsContext,0)


        def AND(self):
            return self.getToken(wstlParser.AND, 0)

        def OR(self):
            return self.getToken(wstlParser.OR, 0)

        def weight(self):
            return self.getTypedRuleContext(wstlParser.WeightContext,0)


        def ONE(self):
            return self.getToken(wstlParser.ONE, 0)

        def ALL(self):
            return self.getToken(wstlParser.ALL, 0)

        def getRuleIndex(self):
            return wstlParser.RULE_joined




    def joined(self):

        localctx = wstlParser.JoinedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 4, self.RULE_joined)
        self._la = 0 # Token type
        try:
            self.state = 75
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [5, 6]:
                self.enterOuterAlt(localctx, 1)
                self.state = 68
                _la = self._input.LA(1)
                if not(_la==5 or _la==6):
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
            elif token in [25, 26]:
                self.enterOuterAlt(localctx, 2)
                self.state = 73
                _la = self._input.LA(1)
                if not(_la==25 or _la==26):
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
        self.enterRule(localctx, 6, self.RULE_weight)
        self._la = 0 # Token type
        try:
            self.state = 93
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,8,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 77
                self.match(wstlParser.HAT)
                self.state = 78
                self.name()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 79
                self.match(wstlParser.HAT)
                self.state = 80
                self.value()
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 81
                self.match(wstlParser.HAT)
                self.state = 82
                self.match(wstlParser.LBRACKET)
                self.state = 83
                self.value()
                self.state = 88
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==34:
                    self.state = 84
                    self.match(wstlParser.COMMA)
                    self.state = 85
                    self.value()
                    self.state = 90
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 91
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
        self.enterRule(localctx, 8, self.RULE_value)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 96
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==30:
                self.state = 95
                self.match(wstlParser.MINUS)


            self.state = 98
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
        self.enterRule(localctx, 10, self.RULE_comparison)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 100
            self.total()
            self.state = 106
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 258048) != 0):
                self.state = 101
                self.relation()
                self.state = 102
                self.total()
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
        self.enterRule(localctx, 12, self.RULE_total)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 109
            self.term()
            self.state = 114
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==29 or _la==30:
                self.state = 110
                _la = self._input.LA(1)
                if not(_la==29 or _la==30):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 111
                self.term()
                self.state = 116
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
        self.enterRule(localctx, 14, self.RULE_term)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 117
            self.factor()
            self.state = 122
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==31 or _la==32:
                self.state = 118
                _la = self._input.LA(1)
                if not(_la==31 or _la==32):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 119
                self.factor()
                self.state = 124
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
        self.enterRule(localctx, 16, self.RULE_factor)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 128
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==29 or _la==30:
                self.state = 125
                _la = self._input.LA(1)
                if not(_la==29 or _la==30):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 130
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 131
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


        def region(self):
            return self.getTypedRuleContext(wstlParser.RegionContext,0)


        def parts(self):
            return self.getTypedRuleContext(wstlParser.PartsContext,0)


        def getRuleIndex(self):
            return wstlParser.RULE_operand




    def operand(self):

        localctx = wstlParser.OperandContext(self, self._ctx, self.state)
        self.enterRule(localctx, 18, self.RULE_operand)
        try:
            self.state = 138
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,14,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 133
                self.constant()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 134
                self.match(wstlParser.NUMBER)
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 135
                self.name()
                pass

            elif la_ == 4:
                self.enterOuterAlt(localctx, 4)
                self.state = 136
                self.region()
                pass

            elif la_ == 5:
                self.enterOuterAlt(localctx, 5)
                self.state = 137
                self.parts()
                pass


        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class RegionContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def OPEN(self):
            return self.getToken(wstlParser.OPEN, 0)

        def name(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(wstlParser.NameContext)
            else:
                return self.getTypedRuleContext(wstlParser.NameContext,i)


        def CLOSE(self):
            return self.getToken(wstlParser.CLOSE, 0)

        def IN(self):
            return self.getToken(wstlParser.IN, 0)

        def OUT(self):
            return self.getToken(wstlParser.OUT, 0)

        def CLEAR(self):
            return self.getToken(wstlParser.CLEAR, 0)

        def COMMA(self):
            return self.getToken(wstlParser.COMMA, 0)

        def getRuleIndex(self):
            return wstlParser.RULE_region




    def region(self):

        localctx = wstlParser.RegionContext(self, self._ctx, self.state)
        self.enterRule(localctx, 20, self.RULE_region)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 140
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 28) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 141
            self.match(wstlParser.OPEN)
            self.state = 142
            self.name()
            self.state = 145
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==34:
                self.state = 143
                self.match(wstlParser.COMMA)
                self.state = 144
                self.name()


            self.state = 147
            self.match(wstlParser.CLOSE)
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
            return self.getTypedRuleContext(wstlParser.WordContext,0)


        def IN(self):
            return self.getToken(wstlParser.IN, 0)

        def OUT(self):
            return self.getToken(wstlParser.OUT, 0)

        def CLEAR(self):
            return self.getToken(wstlParser.CLEAR, 0)

        def getRuleIndex(self):
            return wstlParser.RULE_reserved




    def reserved(self):

        localctx = wstlParser.ReservedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 22, self.RULE_reserved)
        try:
            self.state = 153
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [20, 21, 22, 23, 24, 25, 26]:
                self.enterOuterAlt(localctx, 1)
                self.state = 149
                self.word()
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 2)
                self.state = 150
                self.match(wstlParser.IN)
                pass
            elif token in [3]:
                self.enterOuterAlt(localctx, 3)
                self.state = 151
                self.match(wstlParser.OUT)
                pass
            elif token in [4]:
                self.enterOuterAlt(localctx, 4)
                self.state = 152
                self.match(wstlParser.CLEAR)
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
            self.state = 155
            self.level()
            self.state = 160
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==34:
                self.state = 156
                self.match(wstlParser.COMMA)
                self.state = 157
                self.level()
                self.state = 162
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 163
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
            self.state = 165
            self.unary()
            self.state = 171
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 12583776) != 0):
                self.state = 166
                self.connective()
                self.state = 167
                self.unary()
                self.state = 173
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
        self.enterRule(localctx, 28, self.RULE_unary)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 177
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,19,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 174
                    self.prefix() 
                self.state = 179
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,19,self._ctx)

            self.state = 182
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,20,self._ctx)
            if la_ == 1:
                self.state = 180
                self.comparison()
                pass

            elif la_ == 2:
                self.state = 181
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
        self.enterRule(localctx, 30, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 196
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [44]:
                self.enterOuterAlt(localctx, 1)
                self.state = 184
                self.match(wstlParser.GROUP)
                pass
            elif token in [27]:
                self.enterOuterAlt(localctx, 2)
                self.state = 185
                self.match(wstlParser.OPEN)
                self.state = 186
                self.level()
                self.state = 191
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==34:
                    self.state = 187
                    self.match(wstlParser.COMMA)
                    self.state = 188
                    self.level()
                    self.state = 193
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 194
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
        self.enterRule(localctx, 32, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 198
            self.match(wstlParser.LBRACKET)
            self.state = 199
            self.bound()
            self.state = 200
            self.match(wstlParser.COMMA)
            self.state = 201
            self.bound()
            self.state = 202
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
        self.enterRule(localctx, 34, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 205
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==30:
                self.state = 204
                self.match(wstlParser.MINUS)


            self.state = 207
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
        self.enterRule(localctx, 36, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 209
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
            return self.getToken(wstlParser.TRUE, 0)

        def FALSE(self):
            return self.getToken(wstlParser.FALSE, 0)

        def getRuleIndex(self):
            return wstlParser.RULE_constant




    def constant(self):

        localctx = wstlParser.ConstantContext(self, self._ctx, self.state)
        self.enterRule(localctx, 38, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 211
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
            return self.getToken(wstlParser.NAME, 0)

        def STRING(self):
            return self.getToken(wstlParser.STRING, 0)

        def reserved(self):
            return self.getTypedRuleContext(wstlParser.ReservedContext,0)


        def getRuleIndex(self):
            return wstlParser.RULE_name




    def name(self):

        localctx = wstlParser.NameContext(self, self._ctx, self.state)
        self.enterRule(localctx, 40, self.RULE_name)
        try:
            self.state = 216
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [40]:
                self.enterOuterAlt(localctx, 1)
                self.state = 213
                self.match(wstlParser.NAME)
                pass
            elif token in [41]:
                self.enterOuterAlt(localctx, 2)
                self.state = 214
                self.match(wstlParser.STRING)
                pass
            elif token in [2, 3, 4, 20, 21, 22, 23, 24, 25, 26]:
                self.enterOuterAlt(localctx, 3)
                self.state = 215
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
            return self.getToken(wstlParser.EVENTUALLY, 0)

        def ALWAYS(self):
            return self.getToken(wstlParser.ALWAYS, 0)

        def UNTIL(self):
            return self.getToken(wstlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(wstlParser.RELEASE, 0)

        def NEXT(self):
            return self.getToken(wstlParser.NEXT, 0)

        def ONE(self):
            return self.getToken(wstlParser.ONE, 0)

        def ALL(self):
            return self.getToken(wstlParser.ALL, 0)

        def getRuleIndex(self):
            return wstlParser.RULE_word




    def word(self):

        localctx = wstlParser.WordContext(self, self._ctx, self.state)
        self.enterRule(localctx, 42, self.RULE_word)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 218
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





