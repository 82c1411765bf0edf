# Generated from stl.g4 by ANTLR 4.13.1
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
        4,1,43,178,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,2,19,7,19,1,0,
        1,0,1,0,1,0,5,0,45,8,0,10,0,12,0,48,9,0,1,1,1,1,1,1,5,1,53,8,1,10,
        1,12,1,56,9,1,1,2,1,2,1,2,5,2,61,8,2,10,2,12,2,64,9,2,1,3,5,3,67,
        8,3,10,3,12,3,70,9,3,1,3,1,3,1,4,1,4,1,4,1,4,1,4,3,4,79,8,4,1,5,
        1,5,1,5,1,5,1,5,3,5,86,8,5,1,5,1,5,1,6,1,6,1,6,1,6,3,6,94,8,6,1,
        7,1,7,1,7,5,7,99,8,7,10,7,12,7,102,9,7,1,7,1,7,1,8,1,8,1,8,1,8,5,
        8,110,8,8,10,8,12,8,113,9,8,1,9,1,9,1,9,1,9,1,9,1,9,3,9,121,8,9,
        1,10,5,10,124,8,10,10,10,12,10,127,9,10,1,10,1,10,3,10,131,8,10,
        1,11,1,11,1,11,1,11,3,11,137,8,11,1,12,1,12,1,12,1,13,1,13,1,13,
        1,13,1,13,5,13,147,8,13,10,13,12,13,150,9,13,1,13,1,13,3,13,154,
        8,13,1,14,1,14,1,14,1,14,1,14,1,14,1,15,3,15,163,8,15,1,15,1,15,
        1,16,1,16,1,17,1,17,1,18,1,18,1,18,3,18,174,8,18,1,19,1,19,1,19,
        1,125,0,20,0,2,4,6,8,10,12,14,16,18,20,22,24,26,28,30,32,34,36,38,
        0,9,1,0,28,29,1,0,30,31,1,0,1,3,1,0,21,22,3,0,9,10,19,20,24,25,1,
        0,24,25,1,0,11,16,1,0,17,18,1,0,19,25,184,0,40,1,0,0,0,2,49,1,0,
        0,0,4,57,1,0,0,0,6,68,1,0,0,0,8,78,1,0,0,0,10,80,1,0,0,0,12,93,1,
        0,0,0,14,95,1,0,0,0,16,105,1,0,0,0,18,120,1,0,0,0,20,125,1,0,0,0,
        22,136,1,0,0,0,24,138,1,0,0,0,26,153,1,0,0,0,28,155,1,0,0,0,30,162,
        1,0,0,0,32,166,1,0,0,0,34,168,1,0,0,0,36,173,1,0,0,0,38,175,1,0,
        0,0,40,46,3,2,1,0,41,42,3,32,16,0,42,43,3,2,1,0,43,45,1,0,0,0,44,
        41,1,0,0,0,45,48,1,0,0,0,46,44,1,0,0,0,46,47,1,0,0,0,47,1,1,0,0,
        0,48,46,1,0,0,0,49,54,3,4,2,0,50,51,7,0,0,0,51,53,3,4,2,0,52,50,
        1,0,0,0,53,56,1,0,0,0,54,52,1,0,0,0,54,55,1,0,0,0,55,3,1,0,0,0,56,
        54,1,0,0,0,57,62,3,6,3,0,58,59,7,1,0,0,59,61,3,6,3,0,60,58,1,0,0,
        0,61,64,1,0,0,0,62,60,1,0,0,0,62,63,1,0,0,0,63,5,1,0,0,0,64,62,1,
        0,0,0,65,67,7,0,0,0,66,65,1,0,0,0,67,70,1,0,0,0,68,66,1,0,0,0,68,
        69,1,0,0,0,69,71,1,0,0,0,70,68,1,0,0,0,71,72,3,8,4,0,72,7,1,0,0,
        0,73,79,3,34,17,0,74,79,5,38,0,0,75,79,3,36,18,0,76,79,3,10,5,0,
        77,79,3,26,13,0,78,73,1,0,0,0,78,74,1,0,0,0,78,75,1,0,0,0,78,76,
        1,0,0,0,78,77,1,0,0,0,79,9,1,0,0,0,80,81,7,2,0,0,81,82,5,26,0,0,
        82,85,3,36,18,0,83,84,5,33,0,0,84,86,3,36,18,0,85,83,1,0,0,0,85,
        86,1,0,0,0,86,87,1,0,0,0,87,88,5,27,0,0,88,11,1,0,0,0,89,94,3,38,
        19,0,90,94,5,1,0,0,91,94,5,2,0,0,92,94,5,3,0,0,93,89,1,0,0,0,93,
        90,1,0,0,0,93,91,1,0,0,0,93,92,1,0,0,0,94,13,1,0,0,0,95,100,3,16,
        8,0,96,97,5,33,0,0,97,99,3,16,8,0,98,96,1,0,0,0,99,102,1,0,0,0,100,
        98,1,0,0,0,100,101,1,0,0,0,101,103,1,0,0,0,102,100,1,0,0,0,103,104,
        5,0,0,1,104,15,1,0,0,0,105,111,3,20,10,0,106,107,3,18,9,0,107,108,
        3,20,10,0,108,110,1,0,0,0,109,106,1,0,0,0,110,113,1,0,0,0,111,109,
        1,0,0,0,111,112,1,0,0,0,112,17,1,0,0,0,113,111,1,0,0,0,114,121,5,
        4,0,0,115,121,5,5,0,0,116,121,5,7,0,0,117,121,5,8,0,0,118,119,7,
        3,0,0,119,121,3,28,14,0,120,114,1,0,0,0,120,115,1,0,0,0,120,116,
        1,0,0,0,120,117,1,0,0,0,120,118,1,0,0,0,121,19,1,0,0,0,122,124,3,
        22,11,0,123,122,1,0,0,0,124,127,1,0,0,0,125,126,1,0,0,0,125,123,
        1,0,0,0,126,130,1,0,0,0,127,125,1,0,0,0,128,131,3,0,0,0,129,131,
        3,24,12,0,130,128,1,0,0,0,130,129,1,0,0,0,131,21,1,0,0,0,132,137,
        5,6,0,0,133,137,5,23,0,0,134,135,7,4,0,0,135,137,3,28,14,0,136,132,
        1,0,0,0,136,133,1,0,0,0,136,134,1,0,0,0,137,23,1,0,0,0,138,139,7,
        5,0,0,139,140,3,26,13,0,140,25,1,0,0,0,141,154,5,43,0,0,142,143,
        5,26,0,0,143,148,3,16,8,0,144,145,5,33,0,0,145,147,3,16,8,0,146,
        144,1,0,0,0,147,150,1,0,0,0,148,146,1,0,0,0,148,149,1,0,0,0,149,
        151,1,0,0,0,150,148,1,0,0,0,151,152,5,27,0,0,152,154,1,0,0,0,153,
        141,1,0,0,0,153,142,1,0,0,0,154,27,1,0,0,0,155,156,5,34,0,0,156,
        157,3,30,15,0,157,158,5,33,0,0,158,159,3,30,15,0,159,160,5,35,0,
        0,160,29,1,0,0,0,161,163,5,29,0,0,162,161,1,0,0,0,162,163,1,0,0,
        0,163,164,1,0,0,0,164,165,5,38,0,0,165,31,1,0,0,0,166,167,7,6,0,
        0,167,33,1,0,0,0,168,169,7,7,0,0,169,35,1,0,0,0,170,174,5,39,0,0,
        171,174,5,40,0,0,172,174,3,12,6,0,173,170,1,0,0,0,173,171,1,0,0,
        0,173,172,1,0,0,0,174,37,1,0,0,0,175,176,7,8,0,0,176,39,1,0,0,0,
        17,46,54,62,68,78,85,93,100,111,120,125,130,136,148,153,162,173
    ]

class stlParser ( Parser ):

    grammarFileName = "stl.g4"

    atn = ATNDeserializer().deserialize(serializedATN())

    decisionsToDFA = [ DFA(ds, i) for i, ds in enumerate(atn.decisionToState) ]

    sharedContextCache = PredictionContextCache()

    literalNames = [ "<INVALID>", "'in'", "'out'", "'clear'", "<INVALID>", 
                     "<INVALID>", "<INVALID>", "<INVALID>", "<INVALID>", 
                     "'<>'", "'[]'", "'>='", "'<='", "'>'", "'<'", "<INVALID>", 
                     "'!='", "<INVALID>", "<INVALID>", "'F'", "'G'", "'U'", 
                     "'R'", "'X'", "'one'", "'all'", "'('", "')'", "'+'", 
                     "'-'", "'*'", "'/'", "'%'", "','", "'['", "']'", "'{'", 
                     "'}'" ]

    symbolicNames = [ "<INVALID>", "IN", "OUT", "CLEAR", "AND", "OR", "NOT", 
                      "IMPLIES", "IFF", "DIAMOND", "BOX", "GE", "LE", "GT", 
                      "LT", "EQ", "NE", "TRUE", "FALSE", "EVENTUALLY", "ALWAYS", 
                      "UNTIL", "RELEASE", "NEXT", "ONE", "ALL", "OPEN", 
                      "CLOSE", "PLUS", "MINUS", "STAR", "SLASH", "PERCENT", 
                      "COMMA", "LBRACKET", "RBRACKET", "LBRACE", "RBRACE", 
                      "NUMBER", "NAME", "STRING", "SPACE", "STRAY", "GROUP" ]

    RULE_comparison = 0
    RULE_total = 1
    RULE_term = 2
    RULE_factor = 3
    RULE_operand = 4
    RULE_region = 5
    RULE_reserved = 6
    RULE_formula = 7
    RULE_level = 8
    RULE_connective = 9
    RULE_unary = 10
    RULE_prefix = 11
    RULE_joined = 12
    RULE_parts = 13
    RULE_interval = 14
    RULE_bound = 15
    RULE_relation = 16
    RULE_constant = 17
    RULE_name = 18
    RULE_word = 19

    ruleNames =  [ "comparison", "total", "term", "factor", "operand", "region", 
                   "reserved", "formula", "level", "connective", "unary", 
                   "prefix", "joined", "parts", "interval", "bound", "relation", 
                   "constant", "name", "word" ]

    EOF = Token.EOF
    IN=1
    OUT=2
    CLEAR=3
    AND=4
    OR=5
    NOT=6
    IMPLIES=7
    IFF=8
    DIAMOND=9
    BOX=10
    GE=11
    LE=12
    GT=13
    LT=14
    EQ=15
    NE=16
    TRUE=17
    FALSE=18
    EVENTUALLY=19
    ALWAYS=20
    UNTIL=21
    RELEASE=22
    NEXT=23
    ONE=24
    ALL=25
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




    class ComparisonContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def total(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(stlParser.TotalContext)
            else:
                return self.getTypedRuleContext(stlParser.TotalContext,i)


        def relation(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(stlParser.RelationContext)
            else:
                return self.getTypedRuleContext(stlParser.RelationContext,i)


        def getRuleIndex(self):
            return stlParser.RULE_comparison




    def comparison(self):

        localctx = stlParser.ComparisonContext(self, self._ctx, self.state)
        self.enterRule(localctx, 0, self.RULE_comparison)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 40
            self.total()
            self.state = 46
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 129024) != 0):
                self.state = 41
                self.relation()
                self.state = 42
                self.total()
                self.state = 48
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
                return self.getTypedRuleContexts(stlParser.TermContext)
            else:
                return self.getTypedRuleContext(stlParser.TermContext,i)


        def PLUS(self, i:int=None):
            if i is None:
                return self.getTokens(stlParser.PLUS)
            else:
                return self.getToken(stlParser.PLUS, i)

        def MINUS(self, i:int=None):
            if i is None:
                return self.getTokens(stlParser.MINUS)
            else:
                return self.getToken(stlParser.MINUS, i)

        def getRuleIndex(self):
            return stlParser.RULE_total




    def total(self):

        localctx = stlParser.TotalContext(self, self._ctx, self.state)
        self.enterRule(localctx, 2, self.RULE_total)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 49
            self.term()
            self.state = 54
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==28 or _la==29:
                self.state = 50
                _la = self._input.LA(1)
                if not(_la==28 or _la==29):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 51
                self.term()
                self.state = 56
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
                return self.getTypedRuleContexts(stlParser.FactorContext)
            else:
                return self.getTypedRuleContext(stlParser.FactorContext,i)


        def STAR(self, i:int=None):
            if i is None:
                return self.getTokens(stlParser.STAR)
            else:
                return self.getToken(stlParser.STAR, i)

        def SLASH(self, i:int=None):
            if i is None:
                return self.getTokens(stlParser.SLASH)
            else:
                return self.getToken(stlParser.SLASH, i)

        def getRuleIndex(self):
            return stlParser.RULE_term




    def term(self):

        localctx = stlParser.TermContext(self, self._ctx, self.state)
        self.enterRule(localctx, 4, self.RULE_term)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 57
            self.factor()
            self.state = 62
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==30 or _la==31:
                self.state = 58
                _la = self._input.LA(1)
                if not(_la==30 or _la==31):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 59
                self.factor()
                self.state = 64
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
            return self.getTypedRuleContext(stlParser.OperandContext,0)


        def PLUS(self, i:int=None):
            if i is None:
                return self.getTokens(stlParser.PLUS)
            else:
                return self.getToken(stlParser.PLUS, i)

        def MINUS(self, i:int=None):
            if i is None:
                return self.getTokens(stlParser.MINUS)
            else:
                return self.getToken(stlParser.MINUS, i)

        def getRuleIndex(self):
            return stlParser.RULE_factor




    def factor(self):

        localctx = stlParser.FactorContext(self, self._ctx, self.state)
        self.enterRule(localctx, 6, self.RULE_factor)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 68
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==28 or _la==29:
                self.state = 65
                _la = self._input.LA(1)
                if not(_la==28 or _la==29):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 70
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 71
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
            return self.getTypedRuleContext(stlParser.ConstantContext,0)


        def NUMBER(self):
            return self.getToken(stlParser.NUMBER, 0)

        def name(self):
            return self.getTypedRuleContext(stlParser.NameContext,0)


        def region(self):
            return self.getTypedRuleContext(stlParser.RegionContext,0)


        def parts(self):
            return self.getTypedRuleContext(stlParser.PartsContext,0)


        def getRuleIndex(self):
            return stlParser.RULE_operand




    def operand(self):

        localctx = stlParser.OperandContext(self, self._ctx, self.state)
        self.enterRule(localctx, 8, self.RULE_operand)
        try:
            self.state = 78
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,4,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 73
                self.constant()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 74
                self.match(stlParser.NUMBER)
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 75
                self.name()
                pass

            elif la_ == 4:
                self.enterOuterAlt(localctx, 4)
                self.state = 76
                self.region()
                pass

            elif la_ == 5:
                self.enterOuterAlt(localctx, 5)
                self.state = 77
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
            return self.getToken(stlParser.OPEN, 0)

        def name(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(stlParser.NameContext)
            else:
                return self.getTypedRuleContext(stlParser.NameContext,i)


        def CLOSE(self):
            return self.getToken(stlParser.CLOSE, 0)

        def IN(self):
            return self.getToken(stlParser.IN, 0)

        def OUT(self):
            return self.getToken(stlParser.OUT, 0)

        def CLEAR(self):
            return self.getToken(stlParser.CLEAR, 0)

        def COMMA(self):
            return self.getToken(stlParser.COMMA, 0)

        def getRuleIndex(self):
            return stlParser.RULE_region




    def region(self):

        localctx = stlParser.RegionContext(self, self._ctx, self.state)
        self.enterRule(localctx, 10, self.RULE_region)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 80
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 14) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 81
            self.match(stlParser.OPEN)
            self.state = 82
            self.name()
            self.state = 85
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==33:
                self.state = 83
                self.match(stlParser.COMMA)
                self.state = 84
                self.name()


            self.state = 87
            self.match(stlParser.CLOSE)
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
            return self.getTypedRuleContext(stlParser.WordContext,0)


        def IN(self):
            return self.getToken(stlParser.IN, 0)

        def OUT(self):
            return self.getToken(stlParser.OUT, 0)

        def CLEAR(self):
            return self.getToken(stlParser.CLEAR, 0)

        def getRuleIndex(self):
            return stlParser.RULE_reserved




    def reserved(self):

        localctx = stlParser.ReservedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 12, self.RULE_reserved)
        try:
            self.state = 93
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [19, 20, 21, 22, 23, 24, 25]:
                self.enterOuterAlt(localctx, 1)
                self.state = 89
                self.word()
                pass
            elif token in [1]:
                self.enterOuterAlt(localctx, 2)
                self.state = 90
                self.match(stlParser.IN)
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 3)
                self.state = 91
                self.match(stlParser.OUT)
                pass
            elif token in [3]:
                self.enterOuterAlt(localctx, 4)
                self.state = 92
                self.match(stlParser.CLEAR)
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
                return self.getTypedRuleContexts(stlParser.LevelContext)
            else:
                return self.getTypedRuleContext(stlParser.LevelContext,i)


        def EOF(self):
            return self.getToken(stlParser.EOF, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(stlParser.COMMA)
            else:
                return self.getToken(stlParser.COMMA, i)

        def getRuleIndex(self):
            return stlParser.RULE_formula




    def formula(self):

        localctx = stlParser.FormulaContext(self, self._ctx, self.state)
        self.enterRule(localctx, 14, self.RULE_formula)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 95
            self.level()
            self.state = 100
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==33:
                self.state = 96
                self.match(stlParser.COMMA)
                self.state = 97
                self.level()
                self.state = 102
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 103
            self.match(stlParser.EOF)
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
                return self.getTypedRuleContexts(stlParser.UnaryContext)
            else:
                return self.getTypedRuleContext(stlParser.UnaryContext,i)


        def connective(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(stlParser.ConnectiveContext)
            else:
                return self.getTypedRuleContext(stlParser.ConnectiveContext,i)


        def getRuleIndex(self):
            return stlParser.RULE_level




    def level(self):

        localctx = stlParser.LevelContext(self, self._ctx, self.state)
        self.enterRule(localctx, 16, self.RULE_level)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 105
            self.unary()
            self.state = 111
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 6291888) != 0):
                self.state = 106
                self.connective()
                self.state = 107
                self.unary()
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


    class ConnectiveContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def AND(self):
            return self.getToken(stlParser.AND, 0)

        def OR(self):
            return self.getToken(stlParser.OR, 0)

        def IMPLIES(self):
            return self.getToken(stlParser.IMPLIES, 0)

        def IFF(self):
            return self.getToken(stlParser.IFF, 0)

        def interval(self):
            return self.getTypedRuleContext(stlParser.IntervalContext,0)


        def UNTIL(self):
            return self.getToken(stlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(stlParser.RELEASE, 0)

        def getRuleIndex(self):
            return stlParser.RULE_connective




    def connective(self):

        localctx = stlParser.ConnectiveContext(self, self._ctx, self.state)
        self.enterRule(localctx, 18, self.RULE_connective)
        self._la = 0 # Token type
        try:
            self.state = 120
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [4]:
                self.enterOuterAlt(localctx, 1)
                self.state = 114
                self.match(stlParser.AND)
                pass
            elif token in [5]:
                self.enterOuterAlt(localctx, 2)
                self.state = 115
                self.match(stlParser.OR)
                pass
            elif token in [7]:
                self.enterOuterAlt(localctx, 3)
                self.state = 116
                self.match(stlParser.IMPLIES)
                pass
            elif token in [8]:
                self.enterOuterAlt(localctx, 4)
                self.state = 117
                self.match(stlParser.IFF)
                pass
            elif token in [21, 22]:
                self.enterOuterAlt(localctx, 5)
                self.state = 118
                _la = self._input.LA(1)
                if not(_la==21 or _la==22):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 119
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
            return self.getTypedRuleContext(stlParser.ComparisonContext,0)


        def joined(self):
            return self.getTypedRuleContext(stlParser.JoinedContext,0)


        def prefix(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(stlParser.PrefixContext)
            else:
                return self.getTypedRuleContext(stlParser.PrefixContext,i)


        def getRuleIndex(self):
            return stlParser.RULE_unary




    def unary(self):

        localctx = stlParser.UnaryContext(self, self._ctx, self.state)
        self.enterRule(localctx, 20, self.RULE_unary)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 125
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,10,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 122
                    self.prefix() 
                self.state = 127
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,10,self._ctx)

            self.state = 130
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,11,self._ctx)
            if la_ == 1:
                self.state = 128
                self.comparison()
                pass

            elif la_ == 2:
                self.state = 129
                self.joined()
                pass


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
            return self.getToken(stlParser.NOT, 0)

        def NEXT(self):
            return self.getToken(stlParser.NEXT, 0)

        def interval(self):
            return self.getTypedRuleContext(stlParser.IntervalContext,0)


        def EVENTUALLY(self):
            return self.getToken(stlParser.EVENTUALLY, 0)

        def DIAMOND(self):
            return self.getToken(stlParser.DIAMOND, 0)

        def ALWAYS(self):
            return self.getToken(stlParser.ALWAYS, 0)

        def BOX(self):
            return self.getToken(stlParser.BOX, 0)

        def ONE(self):
            return self.getToken(stlParser.ONE, 0)

        def ALL(self):
            return self.getToken(stlParser.ALL, 0)

        def getRuleIndex(self):
            return stlParser.RULE_prefix




    def prefix(self):

        localctx = stlParser.PrefixContext(self, self._ctx, self.state)
        self.enterRule(localctx, 22, self.RULE_prefix)
        self._la = 0 # Token type
        try:
            self.state = 136
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [6]:
                self.enterOuterAlt(localctx, 1)
                self.state = 132
                self.match(stlParser.NOT)
                pass
            elif token in [23]:
                self.enterOuterAlt(localctx, 2)
                self.state = 133
                self.match(stlParser.NEXT)
                pass
            elif token in [9, 10, 19, 20, 24, 25]:
                self.enterOuterAlt(localctx, 3)
                self.state = 134
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 51906048) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 135
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
            return self.getTypedRuleContext(stlParser.PartsContext,0)


        def ONE(self):
            return self.getToken(stlParser.ONE, 0)

        def ALL(self):
            return self.getToken(stlParser.ALL, 0)

        def getRuleIndex(self):
            return stlParser.RULE_joined




    def joined(self):

        localctx = stlParser.JoinedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 24, self.RULE_joined)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 138
            _la = self._input.LA(1)
            if not(_la==24 or _la==25):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 139
            self.parts()
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
            return self.getToken(stlParser.GROUP, 0)

        def OPEN(self):
            return self.getToken(stlParser.OPEN, 0)

        def level(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(stlParser.LevelContext)
            else:
                return self.getTypedRuleContext(stlParser.LevelContext,i)


        def CLOSE(self):
            return self.getToken(stlParser.CLOSE, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(stlParser.COMMA)
            else:
                return self.getToken(stlParser.COMMA, i)

        def getRuleIndex(self):
            return stlParser.RULE_parts




    def parts(self):

        localctx = stlParser.PartsContext(self, self._ctx, self.state)
        self.enterRule(localctx, 26, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 153
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [43]:
                self.enterOuterAlt(localctx, 1)
                self.state = 141
                self.match(stlParser.GROUP)
                pass
            elif token in [26]:
                self.enterOuterAlt(localctx, 2)
                self.state = 142
                self.match(stlParser.OPEN)
                self.state = 143
                self.level()
                self.state = 148
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==33:
                    self.state = 144
                    self.match(stlParser.COMMA)
                    self.state = 145
                    self.level()
                    self.state = 150
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 151
                self.match(stlParser.CLOSE)
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
            return self.getToken(stlParser.LBRACKET, 0)

        def bound(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(stlParser.BoundContext)
            else:
                return self.getTypedRuleContext(stlParser.BoundContext,i)


        def COMMA(self):
            return self.getToken(stlParser.COMMA, 0)

        def RBRACKET(self):
            return self.getToken(stlParser.RBRACKET, 0)

        def getRuleIndex(self):
            return stlParser.RULE_interval




    def interval(self):

        localctx = stlParser.IntervalContext(self, self._ctx, self.state)
        self.enterRule(localctx, 28, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 155
            self.match(stlParser.LBRACKET)
            self.state = 156
            self.bound()
            self.state = 157
            self.match(stlParser.COMMA)
            self.state = 158
            self.bound()
            self.state = 159
            self.match(stlParser.RBRACKET)
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
            return self.getToken(stlParser.NUMBER, 0)

        def MINUS(self):
            return self.getToken(stlParser.MINUS, 0)

        def getRuleIndex(self):
            return stlParser.RULE_bound




    def bound(self):

        localctx = stlParser.BoundContext(self, self._ctx, self.state)
        self.enterRule(localctx, 30, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 162
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==29:
                self.state = 161
                self.match(stlParser.MINUS)


            self.state = 164
            self.match(stlParser.NUMBER)
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
            return self.getToken(stlParser.GE, 0)

        def LE(self):
            return self.getToken(stlParser.LE, 0)

        def GT(self):
            return self.getToken(stlParser.GT, 0)

        def LT(self):
            return self.getToken(stlParser.LT, 0)

        def EQ(self):
            return self.getToken(stlParser.EQ, 0)

        def NE(self):
            return self.getToken(stlParser.NE, 0)

        def getRuleIndex(self):
            return stlParser.RULE_relation




    def relation(self):

        localctx = stlParser.RelationContext(self, self._ctx, self.state)
        self.enterRule(localctx, 32, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 166
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 129024) != 0)):
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
            return self.getToken(stlParser.TRUE, 0)

        def FALSE(self):
            return self.getToken(stlParser.FALSE, 0)

        def getRuleIndex(self):
            return stlParser.RULE_constant




    def constant(self):

        localctx = stlParser.ConstantContext(self, self._ctx, self.state)
        self.enterRule(localctx, 34, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 168
            _la = self._input.LA(1)
            if not(_la==17 or _la==18):
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
            return self.getToken(stlParser.NAME, 0)

        def STRING(self):
            return self.getToken(stlParser.STRING, 0)

        def reserved(self):
            return self.getTypedRuleContext(stlParser.ReservedContext,0)


        def getRuleIndex(self):
            return stlParser.RULE_name




    def name(self):

        localctx = stlParser.NameContext(self, self._ctx, self.state)
        self.enterRule(localctx, 36, self.RULE_name)
        try:
            self.state = 173
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [39]:
                self.enterOuterAlt(localctx, 1)
                self.state = 170
                self.match(stlParser.NAME)
                pass
            elif token in [40]:
                self.enterOuterAlt(localctx, 2)
                self.state = 171
                self.match(stlParser.STRING)
                pass
            elif token in [1, 2, 3, 19, 20, 21, 22, 23, 24, 25]:
                self.enterOuterAlt(localctx, 3)
                self.state = 172
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
            return self.getToken(stlParser.EVENTUALLY, 0)

        def ALWAYS(self):
            return self.getToken(stlParser.ALWAYS, 0)

        def UNTIL(self):
            return self.getToken(stlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(stlParser.RELEASE, 0)

        def NEXT(self):
            return self.getToken(stlParser.NEXT, 0)

        def ONE(self):
            return self.getToken(stlParser.ONE, 0)

        def ALL(self):
            return self.getToken(stlParser.ALL, 0)

        def getRuleIndex(self):
            return stlParser.RULE_word




    def word(self):

        localctx = stlParser.WordContext(self, self._ctx, self.state)
        self.enterRule(localctx, 38, self.RULE_word)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 175
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 66584576) != 0)):
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





