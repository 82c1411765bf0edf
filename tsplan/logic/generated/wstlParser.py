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
        4,1,42,216,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,2,19,7,19,2,20,
        7,20,2,21,7,21,1,0,1,0,3,0,47,8,0,1,0,1,0,1,0,1,0,1,0,3,0,54,8,0,
        3,0,56,8,0,1,1,5,1,59,8,1,10,1,12,1,62,9,1,1,1,1,1,3,1,66,8,1,1,
        2,1,2,1,2,1,2,1,2,3,2,73,8,2,3,2,75,8,2,1,3,1,3,3,3,79,8,3,1,3,1,
        3,1,4,1,4,1,4,1,4,1,4,1,4,1,4,1,4,1,4,5,4,92,8,4,10,4,12,4,95,9,
        4,1,4,1,4,3,4,99,8,4,1,5,3,5,102,8,5,1,5,1,5,1,6,1,6,1,6,1,6,5,6,
        110,8,6,10,6,12,6,113,9,6,1,7,1,7,1,7,5,7,118,8,7,10,7,12,7,121,
        9,7,1,8,1,8,1,8,5,8,126,8,8,10,8,12,8,129,9,8,1,9,5,9,132,8,9,10,
        9,12,9,135,9,9,1,9,1,9,1,10,1,10,1,10,1,10,1,10,3,10,144,8,10,1,
        11,1,11,1,11,1,11,1,11,3,11,151,8,11,1,11,1,11,1,12,1,12,1,12,1,
        12,3,12,159,8,12,1,13,1,13,1,13,5,13,164,8,13,10,13,12,13,167,9,
        13,1,13,1,13,1,14,1,14,1,14,1,14,5,14,175,8,14,10,14,12,14,178,9,
        14,1,15,1,15,1,15,1,15,1,15,5,15,185,8,15,10,15,12,15,188,9,15,1,
        15,1,15,3,15,192,8,15,1,16,1,16,1,16,1,16,1,16,1,16,1,17,3,17,201,
        8,17,1,17,1,17,1,18,1,18,1,19,1,19,1,20,1,20,1,20,3,20,212,8,20,
        1,21,1,21,1,21,1,60,0,22,0,2,4,6,8,10,12,14,16,18,20,22,24,26,28,
        30,32,34,36,38,40,42,0,9,1,0,5,6,1,0,22,23,2,0,10,11,20,21,1,0,27,
        28,1,0,29,30,1,0,2,4,1,0,12,17,1,0,18,19,1,0,20,24,227,0,55,1,0,
        0,0,2,60,1,0,0,0,4,74,1,0,0,0,6,76,1,0,0,0,8,98,1,0,0,0,10,101,1,
        0,0,0,12,105,1,0,0,0,14,114,1,0,0,0,16,122,1,0,0,0,18,133,1,0,0,
        0,20,143,1,0,0,0,22,145,1,0,0,0,24,158,1,0,0,0,26,160,1,0,0,0,28,
        170,1,0,0,0,30,191,1,0,0,0,32,193,1,0,0,0,34,200,1,0,0,0,36,204,
        1,0,0,0,38,206,1,0,0,0,40,211,1,0,0,0,42,213,1,0,0,0,44,46,7,0,0,
        0,45,47,3,8,4,0,46,45,1,0,0,0,46,47,1,0,0,0,47,56,1,0,0,0,48,56,
        5,8,0,0,49,56,5,9,0,0,50,51,7,1,0,0,51,53,3,32,16,0,52,54,3,8,4,
        0,53,52,1,0,0,0,53,54,1,0,0,0,54,56,1,0,0,0,55,44,1,0,0,0,55,48,
        1,0,0,0,55,49,1,0,0,0,55,50,1,0,0,0,56,1,1,0,0,0,57,59,3,4,2,0,58,
        57,1,0,0,0,59,62,1,0,0,0,60,61,1,0,0,0,60,58,1,0,0,0,61,65,1,0,0,
        0,62,60,1,0,0,0,63,66,3,12,6,0,64,66,3,6,3,0,65,63,1,0,0,0,65,64,
        1,0,0,0,66,3,1,0,0,0,67,75,5,7,0,0,68,75,5,24,0,0,69,70,7,2,0,0,
        70,72,3,32,16,0,71,73,3,8,4,0,72,71,1,0,0,0,72,73,1,0,0,0,73,75,
        1,0,0,0,74,67,1,0,0,0,74,68,1,0,0,0,74,69,1,0,0,0,75,5,1,0,0,0,76,
        78,7,0,0,0,77,79,3,8,4,0,78,77,1,0,0,0,78,79,1,0,0,0,79,80,1,0,0,
        0,80,81,3,30,15,0,81,7,1,0,0,0,82,83,5,1,0,0,83,99,3,40,20,0,84,
        85,5,1,0,0,85,99,3,10,5,0,86,87,5,1,0,0,87,88,5,33,0,0,88,93,3,10,
        5,0,89,90,5,32,0,0,90,92,3,10,5,0,91,89,1,0,0,0,92,95,1,0,0,0,93,
        91,1,0,0,0,93,94,1,0,0,0,94,96,1,0,0,0,95,93,1,0,0,0,96,97,5,34,
        0,0,97,99,1,0,0,0,98,82,1,0,0,0,98,84,1,0,0,0,98,86,1,0,0,0,99,9,
        1,0,0,0,100,102,5,28,0,0,101,100,1,0,0,0,101,102,1,0,0,0,102,103,
        1,0,0,0,103,104,5,37,0,0,104,11,1,0,0,0,105,111,3,14,7,0,106,107,
        3,36,18,0,107,108,3,14,7,0,108,110,1,0,0,0,109,106,1,0,0,0,110,113,
        1,0,0,0,111,109,1,0,0,0,111,112,1,0,0,0,112,13,1,0,0,0,113,111,1,
        0,0,0,114,119,3,16,8,0,115,116,7,3,0,0,116,118,3,16,8,0,117,115,
        1,0,0,0,118,121,1,0,0,0,119,117,1,0,0,0,119,120,1,0,0,0,120,15,1,
        0,0,0,121,119,1,0,0,0,122,127,3,18,9,0,123,124,7,4,0,0,124,126,3,
        18,9,0,125,123,1,0,0,0,126,129,1,0,0,0,127,125,1,0,0,0,127,128,1,
        0,0,0,128,17,1,0,0,0,129,127,1,0,0,0,130,132,7,3,0,0,131,130,1,0,
        0,0,132,135,1,0,0,0,133,131,1,0,0,0,133,134,1,0,0,0,134,136,1,0,
        0,0,135,133,1,0,0,0,136,137,3,20,10,0,137,19,1,0,0,0,138,144,3,38,
        19,0,139,144,5,37,0,0,140,144,3,40,20,0,141,144,3,22,11,0,142,144,
        3,30,15,0,143,138,1,0,0,0,143,139,1,0,0,0,143,140,1,0,0,0,143,141,
        1,0,0,0,143,142,1,0,0,0,144,21,1,0,0,0,145,146,7,5,0,0,146,147,5,
        25,0,0,147,150,3,40,20,0,148,149,5,32,0,0,149,151,3,40,20,0,150,
        148,1,0,0,0,150,151,1,0,0,0,151,152,1,0,0,0,152,153,5,26,0,0,153,
        23,1,0,0,0,154,159,3,42,21,0,155,159,5,2,0,0,156,159,5,3,0,0,157,
        159,5,4,0,0,158,154,1,0,0,0,158,155,1,0,0,0,158,156,1,0,0,0,158,
        157,1,0,0,0,159,25,1,0,0,0,160,165,3,28,14,0,161,162,5,32,0,0,162,
        164,3,28,14,0,163,161,1,0,0,0,164,167,1,0,0,0,165,163,1,0,0,0,165,
        166,1,0,0,0,166,168,1,0,0,0,167,165,1,0,0,0,168,169,5,0,0,1,169,
        27,1,0,0,0,170,176,3,2,1,0,171,172,3,0,0,0,172,173,3,2,1,0,173,175,
        1,0,0,0,174,171,1,0,0,0,175,178,1,0,0,0,176,174,1,0,0,0,176,177,
        1,0,0,0,177,29,1,0,0,0,178,176,1,0,0,0,179,192,5,42,0,0,180,181,
        5,25,0,0,181,186,3,28,14,0,182,183,5,32,0,0,183,185,3,28,14,0,184,
        182,1,0,0,0,185,188,1,0,0,0,186,184,1,0,0,0,186,187,1,0,0,0,187,
        189,1,0,0,0,188,186,1,0,0,0,189,190,5,26,0,0,190,192,1,0,0,0,191,
        179,1,0,0,0,191,180,1,0,0,0,192,31,1,0,0,0,193,194,5,33,0,0,194,
        195,3,34,17,0,195,196,5,32,0,0,196,197,3,34,17,0,197,198,5,34,0,
        0,198,33,1,0,0,0,199,201,5,28,0,0,200,199,1,0,0,0,200,201,1,0,0,
        0,201,202,1,0,0,0,202,203,5,37,0,0,203,35,1,0,0,0,204,205,7,6,0,
        0,205,37,1,0,0,0,206,207,7,7,0,0,207,39,1,0,0,0,208,212,5,38,0,0,
        209,212,5,39,0,0,210,212,3,24,12,0,211,208,1,0,0,0,211,209,1,0,0,
        0,211,210,1,0,0,0,212,41,1,0,0,0,213,214,7,8,0,0,214,43,1,0,0,0,
        24,46,53,55,60,65,72,74,78,93,98,101,111,119,127,133,143,150,158,
        165,176,186,191,200,211
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
                     "'R'", "'X'", "'('", "')'", "'+'", "'-'", "'*'", "'/'", 
                     "'%'", "','", "'['", "']'", "'{'", "'}'" ]

    symbolicNames = [ "<INVALID>", "HAT", "IN", "OUT", "CLEAR", "AND", "OR", 
                      "NOT", "IMPLIES", "IFF", "DIAMOND", "BOX", "GE", "LE", 
                      "GT", "LT", "EQ", "NE", "TRUE", "FALSE", "EVENTUALLY", 
                      "ALWAYS", "UNTIL", "RELEASE", "NEXT", "OPEN", "CLOSE", 
                      "PLUS", "MINUS", "STAR", "SLASH", "PERCENT", "COMMA", 
                      "LBRACKET", "RBRACKET", "LBRACE", "RBRACE", "NUMBER", 
                      "NAME", "STRING", "SPACE", "STRAY", "GROUP" ]

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
    RULE_region = 11
    RULE_reserved = 12
    RULE_formula = 13
    RULE_level = 14
    RULE_parts = 15
    RULE_interval = 16
    RULE_bound = 17
    RULE_relation = 18
    RULE_constant = 19
    RULE_name = 20
    RULE_letter = 21

    ruleNames =  [ "connective", "unary", "prefix", "joined", "weight", 
                   "value", "comparison", "total", "term", "factor", "operand", 
                   "region", "reserved", "formula", "level", "parts", "interval", 
                   "bound", "relation", "constant", "name", "letter" ]

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
    OPEN=25
    CLOSE=26
    PLUS=27
    MINUS=28
    STAR=29
    SLASH=30
    PERCENT=31
    COMMA=32
    LBRACKET=33
    RBRACKET=34
    LBRACE=35
    RBRACE=36
    NUMBER=37
    NAME=38
    STRING=39
    SPACE=40
    STRAY=41
    GROUP=42

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
            self.state = 60
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,3,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 57
                    self.prefix() 
                self.state = 62
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,3,self._ctx)

            self.state = 65
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [2, 3, 4, 18, 19, 20, 21, 22, 23, 24, 25, 27, 28, 37, 38, 39, 42]:
                self.state = 63
                self.comparison()
                pass
            elif token in [5, 6]:
                self.state = 64
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
            self.state = 74
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [7]:
                self.enterOuterAlt(localctx, 1)
                self.state = 67
                self.match(wstlParser.NOT)
                pass
            elif token in [24]:
                self.enterOuterAlt(localctx, 2)
                self.state = 68
                self.match(wstlParser.NEXT)
                pass
            elif token in [10, 11, 20, 21]:
                self.enterOuterAlt(localctx, 3)
                self.state = 69
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 3148800) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 70
                self.interval()
                self.state = 72
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                if _la==1:
                    self.state = 71
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
            self.state = 76
            _la = self._input.LA(1)
            if not(_la==5 or _la==6):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 78
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==1:
                self.state = 77
                self.weight()


            self.state = 80
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
            self.state = 98
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,9,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 82
                self.match(wstlParser.HAT)
                self.state = 83
                self.name()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 84
                self.match(wstlParser.HAT)
                self.state = 85
                self.value()
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 86
                self.match(wstlParser.HAT)
                self.state = 87
                self.match(wstlParser.LBRACKET)
                self.state = 88
                self.value()
                self.state = 93
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==32:
                    self.state = 89
                    self.match(wstlParser.COMMA)
                    self.state = 90
                    self.value()
                    self.state = 95
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 96
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
            self.state = 101
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==28:
                self.state = 100
                self.match(wstlParser.MINUS)


            self.state = 103
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
            self.state = 105
            self.total()
            self.state = 111
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 258048) != 0):
                self.state = 106
                self.relation()
                self.state = 107
                self.total()
                self.state = 113
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
            self.state = 114
            self.term()
            self.state = 119
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==27 or _la==28:
                self.state = 115
                _la = self._input.LA(1)
                if not(_la==27 or _la==28):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 116
                self.term()
                self.state = 121
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
            self.state = 122
            self.factor()
            self.state = 127
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==29 or _la==30:
                self.state = 123
                _la = self._input.LA(1)
                if not(_la==29 or _la==30):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 124
                self.factor()
                self.state = 129
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
            self.state = 133
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==27 or _la==28:
                self.state = 130
                _la = self._input.LA(1)
                if not(_la==27 or _la==28):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 135
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 136
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
        self.enterRule(localctx, 20, self.RULE_operand)
        try:
            self.state = 143
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,15,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 138
                self.constant()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 139
                self.match(wstlParser.NUMBER)
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 140
                self.name()
                pass

            elif la_ == 4:
                self.enterOuterAlt(localctx, 4)
                self.state = 141
                self.region()
                pass

            elif la_ == 5:
                self.enterOuterAlt(localctx, 5)
                self.state = 142
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
        self.enterRule(localctx, 22, self.RULE_region)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 145
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 28) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 146
            self.match(wstlParser.OPEN)
            self.state = 147
            self.name()
            self.state = 150
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==32:
                self.state = 148
                self.match(wstlParser.COMMA)
                self.state = 149
                self.name()


            self.state = 152
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

        def letter(self):
            return self.getTypedRuleContext(wstlParser.LetterContext,0)


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
        self.enterRule(localctx, 24, self.RULE_reserved)
        try:
            self.state = 158
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [20, 21, 22, 23, 24]:
                self.enterOuterAlt(localctx, 1)
                self.state = 154
                self.letter()
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 2)
                self.state = 155
                self.match(wstlParser.IN)
                pass
            elif token in [3]:
                self.enterOuterAlt(localctx, 3)
                self.state = 156
                self.match(wstlParser.OUT)
                pass
            elif token in [4]:
                self.enterOuterAlt(localctx, 4)
                self.state = 157
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
        self.enterRule(localctx, 26, self.RULE_formula)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 160
            self.level()
            self.state = 165
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==32:
                self.state = 161
                self.match(wstlParser.COMMA)
                self.state = 162
                self.level()
                self.state = 167
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 168
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
        self.enterRule(localctx, 28, self.RULE_level)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 170
            self.unary()
            self.state = 176
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 12583776) != 0):
                self.state = 171
                self.connective()
                self.state = 172
                self.unary()
                self.state = 178
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
        self.enterRule(localctx, 30, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 191
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [42]:
                self.enterOuterAlt(localctx, 1)
                self.state = 179
                self.match(wstlParser.GROUP)
                pass
            elif token in [25]:
                self.enterOuterAlt(localctx, 2)
                self.state = 180
                self.match(wstlParser.OPEN)
                self.state = 181
                self.level()
                self.state = 186
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==32:
                    self.state = 182
                    self.match(wstlParser.COMMA)
                    self.state = 183
                    self.level()
                    self.state = 188
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 189
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
            self.state = 193
            self.match(wstlParser.LBRACKET)
            self.state = 194
            self.bound()
            self.state = 195
            self.match(wstlParser.COMMA)
            self.state = 196
            self.bound()
            self.state = 197
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
            self.state = 200
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==28:
                self.state = 199
                self.match(wstlParser.MINUS)


            self.state = 202
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
            self.state = 204
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
            self.state = 206
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
            self.state = 211
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [38]:
                self.enterOuterAlt(localctx, 1)
                self.state = 208
                self.match(wstlParser.NAME)
                pass
            elif token in [39]:
                self.enterOuterAlt(localctx, 2)
                self.state = 209
                self.match(wstlParser.STRING)
                pass
            elif token in [2, 3, 4, 20, 21, 22, 23, 24]:
                self.enterOuterAlt(localctx, 3)
                self.state = 210
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
        self.enterRule(localctx, 42, self.RULE_letter)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 213
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 32505856) != 0)):
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





