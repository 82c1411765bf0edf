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
        4,1,41,171,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,1,0,1,0,1,0,1,
        0,5,0,43,8,0,10,0,12,0,46,9,0,1,1,1,1,1,1,5,1,51,8,1,10,1,12,1,54,
        9,1,1,2,1,2,1,2,5,2,59,8,2,10,2,12,2,62,9,2,1,3,5,3,65,8,3,10,3,
        12,3,68,9,3,1,3,1,3,1,4,1,4,1,4,1,4,1,4,3,4,77,8,4,1,5,1,5,1,5,1,
        5,1,5,3,5,84,8,5,1,5,1,5,1,6,1,6,1,6,1,6,3,6,92,8,6,1,7,1,7,1,7,
        5,7,97,8,7,10,7,12,7,100,9,7,1,7,1,7,1,8,1,8,1,8,1,8,5,8,108,8,8,
        10,8,12,8,111,9,8,1,9,1,9,1,9,1,9,1,9,1,9,3,9,119,8,9,1,10,5,10,
        122,8,10,10,10,12,10,125,9,10,1,10,1,10,1,11,1,11,1,11,1,11,3,11,
        133,8,11,1,12,1,12,1,12,1,12,1,12,5,12,140,8,12,10,12,12,12,143,
        9,12,1,12,1,12,3,12,147,8,12,1,13,1,13,1,13,1,13,1,13,1,13,1,14,
        3,14,156,8,14,1,14,1,14,1,15,1,15,1,16,1,16,1,17,1,17,1,17,3,17,
        167,8,17,1,18,1,18,1,18,1,123,0,19,0,2,4,6,8,10,12,14,16,18,20,22,
        24,26,28,30,32,34,36,0,8,1,0,26,27,1,0,28,29,1,0,1,3,1,0,21,22,2,
        0,9,10,19,20,1,0,11,16,1,0,17,18,1,0,19,23,177,0,38,1,0,0,0,2,47,
        1,0,0,0,4,55,1,0,0,0,6,66,1,0,0,0,8,76,1,0,0,0,10,78,1,0,0,0,12,
        91,1,0,0,0,14,93,1,0,0,0,16,103,1,0,0,0,18,118,1,0,0,0,20,123,1,
        0,0,0,22,132,1,0,0,0,24,146,1,0,0,0,26,148,1,0,0,0,28,155,1,0,0,
        0,30,159,1,0,0,0,32,161,1,0,0,0,34,166,1,0,0,0,36,168,1,0,0,0,38,
        44,3,2,1,0,39,40,3,30,15,0,40,41,3,2,1,0,41,43,1,0,0,0,42,39,1,0,
        0,0,43,46,1,0,0,0,44,42,1,0,0,0,44,45,1,0,0,0,45,1,1,0,0,0,46,44,
        1,0,0,0,47,52,3,4,2,0,48,49,7,0,0,0,49,51,3,4,2,0,50,48,1,0,0,0,
        51,54,1,0,0,0,52,50,1,0,0,0,52,53,1,0,0,0,53,3,1,0,0,0,54,52,1,0,
        0,0,55,60,3,6,3,0,56,57,7,1,0,0,57,59,3,6,3,0,58,56,1,0,0,0,59,62,
        1,0,0,0,60,58,1,0,0,0,60,61,1,0,0,0,61,5,1,0,0,0,62,60,1,0,0,0,63,
        65,7,0,0,0,64,63,1,0,0,0,65,68,1,0,0,0,66,64,1,0,0,0,66,67,1,0,0,
        0,67,69,1,0,0,0,68,66,1,0,0,0,69,70,3,8,4,0,70,7,1,0,0,0,71,77,3,
        32,16,0,72,77,5,36,0,0,73,77,3,34,17,0,74,77,3,10,5,0,75,77,3,24,
        12,0,76,71,1,0,0,0,76,72,1,0,0,0,76,73,1,0,0,0,76,74,1,0,0,0,76,
        75,1,0,0,0,77,9,1,0,0,0,78,79,7,2,0,0,79,80,5,24,0,0,80,83,3,34,
        17,0,81,82,5,31,0,0,82,84,3,34,17,0,83,81,1,0,0,0,83,84,1,0,0,0,
        84,85,1,0,0,0,85,86,5,25,0,0,86,11,1,0,0,0,87,92,3,36,18,0,88,92,
        5,1,0,0,89,92,5,2,0,0,90,92,5,3,0,0,91,87,1,0,0,0,91,88,1,0,0,0,
        91,89,1,0,0,0,91,90,1,0,0,0,92,13,1,0,0,0,93,98,3,16,8,0,94,95,5,
        31,0,0,95,97,3,16,8,0,96,94,1,0,0,0,97,100,1,0,0,0,98,96,1,0,0,0,
        98,99,1,0,0,0,99,101,1,0,0,0,100,98,1,0,0,0,101,102,5,0,0,1,102,
        15,1,0,0,0,103,109,3,20,10,0,104,105,3,18,9,0,105,106,3,20,10,0,
        106,108,1,0,0,0,107,104,1,0,0,0,108,111,1,0,0,0,109,107,1,0,0,0,
        109,110,1,0,0,0,110,17,1,0,0,0,111,109,1,0,0,0,112,119,5,4,0,0,113,
        119,5,5,0,0,114,119,5,7,0,0,115,119,5,8,0,0,116,117,7,3,0,0,117,
        119,3,26,13,0,118,112,1,0,0,0,118,113,1,0,0,0,118,114,1,0,0,0,118,
        115,1,0,0,0,118,116,1,0,0,0,119,19,1,0,0,0,120,122,3,22,11,0,121,
        120,1,0,0,0,122,125,1,0,0,0,123,124,1,0,0,0,123,121,1,0,0,0,124,
        126,1,0,0,0,125,123,1,0,0,0,126,127,3,0,0,0,127,21,1,0,0,0,128,133,
        5,6,0,0,129,133,5,23,0,0,130,131,7,4,0,0,131,133,3,26,13,0,132,128,
        1,0,0,0,132,129,1,0,0,0,132,130,1,0,0,0,133,23,1,0,0,0,134,147,5,
        41,0,0,135,136,5,24,0,0,136,141,3,16,8,0,137,138,5,31,0,0,138,140,
        3,16,8,0,139,137,1,0,0,0,140,143,1,0,0,0,141,139,1,0,0,0,141,142,
        1,0,0,0,142,144,1,0,0,0,143,141,1,0,0,0,144,145,5,25,0,0,145,147,
        1,0,0,0,146,134,1,0,0,0,146,135,1,0,0,0,147,25,1,0,0,0,148,149,5,
        32,0,0,149,150,3,28,14,0,150,151,5,31,0,0,151,152,3,28,14,0,152,
        153,5,33,0,0,153,27,1,0,0,0,154,156,5,27,0,0,155,154,1,0,0,0,155,
        156,1,0,0,0,156,157,1,0,0,0,157,158,5,36,0,0,158,29,1,0,0,0,159,
        160,7,5,0,0,160,31,1,0,0,0,161,162,7,6,0,0,162,33,1,0,0,0,163,167,
        5,37,0,0,164,167,5,38,0,0,165,167,3,12,6,0,166,163,1,0,0,0,166,164,
        1,0,0,0,166,165,1,0,0,0,167,35,1,0,0,0,168,169,7,7,0,0,169,37,1,
        0,0,0,16,44,52,60,66,76,83,91,98,109,118,123,132,141,146,155,166
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
                     "'R'", "'X'", "'('", "')'", "'+'", "'-'", "'*'", "'/'", 
                     "'%'", "','", "'['", "']'", "'{'", "'}'" ]

    symbolicNames = [ "<INVALID>", "IN", "OUT", "CLEAR", "AND", "OR", "NOT", 
                      "IMPLIES", "IFF", "DIAMOND", "BOX", "GE", "LE", "GT", 
                      "LT", "EQ", "NE", "TRUE", "FALSE", "EVENTUALLY", "ALWAYS", 
                      "UNTIL", "RELEASE", "NEXT", "OPEN", "CLOSE", "PLUS", 
                      "MINUS", "STAR", "SLASH", "PERCENT", "COMMA", "LBRACKET", 
                      "RBRACKET", "LBRACE", "RBRACE", "NUMBER", "NAME", 
                      "STRING", "SPACE", "STRAY", "GROUP" ]

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
    RULE_parts = 12
    RULE_interval = 13
    RULE_bound = 14
    RULE_relation = 15
    RULE_constant = 16
    RULE_name = 17
    RULE_letter = 18

    ruleNames =  [ "comparison", "total", "term", "factor", "operand", "region", 
                   "reserved", "formula", "level", "connective", "unary", 
                   "prefix", "parts", "interval", "bound", "relation", "constant", 
                   "name", "letter" ]

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
    OPEN=24
    CLOSE=25
    PLUS=26
    MINUS=27
    STAR=28
    SLASH=29
    PERCENT=30
    COMMA=31
    LBRACKET=32
    RBRACKET=33
    LBRACE=34
    RBRACE=35
    NUMBER=36
    NAME=37
    STRING=38
    SPACE=39
    STRAY=40
    GROUP=41

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
            self.state = 38
            self.total()
            self.state = 44
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 129024) != 0):
                self.state = 39
                self.relation()
                self.state = 40
                self.total()
                self.state = 46
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
            self.state = 47
            self.term()
            self.state = 52
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==26 or _la==27:
                self.state = 48
                _la = self._input.LA(1)
                if not(_la==26 or _la==27):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 49
                self.term()
                self.state = 54
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
            self.state = 55
            self.factor()
            self.state = 60
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==28 or _la==29:
                self.state = 56
                _la = self._input.LA(1)
                if not(_la==28 or _la==29):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 57
                self.factor()
                self.state = 62
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
            self.state = 66
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==26 or _la==27:
                self.state = 63
                _la = self._input.LA(1)
                if not(_la==26 or _la==27):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 68
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 69
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
            self.state = 76
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,4,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 71
                self.constant()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 72
                self.match(stlParser.NUMBER)
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 73
                self.name()
                pass

            elif la_ == 4:
                self.enterOuterAlt(localctx, 4)
                self.state = 74
                self.region()
                pass

            elif la_ == 5:
                self.enterOuterAlt(localctx, 5)
                self.state = 75
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
            self.state = 78
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 14) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 79
            self.match(stlParser.OPEN)
            self.state = 80
            self.name()
            self.state = 83
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==31:
                self.state = 81
                self.match(stlParser.COMMA)
                self.state = 82
                self.name()


            self.state = 85
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

        def letter(self):
            return self.getTypedRuleContext(stlParser.LetterContext,0)


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
            self.state = 91
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [19, 20, 21, 22, 23]:
                self.enterOuterAlt(localctx, 1)
                self.state = 87
                self.letter()
                pass
            elif token in [1]:
                self.enterOuterAlt(localctx, 2)
                self.state = 88
                self.match(stlParser.IN)
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 3)
                self.state = 89
                self.match(stlParser.OUT)
                pass
            elif token in [3]:
                self.enterOuterAlt(localctx, 4)
                self.state = 90
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
            self.state = 93
            self.level()
            self.state = 98
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==31:
                self.state = 94
                self.match(stlParser.COMMA)
                self.state = 95
                self.level()
                self.state = 100
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 101
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
            self.state = 103
            self.unary()
            self.state = 109
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 6291888) != 0):
                self.state = 104
                self.connective()
                self.state = 105
                self.unary()
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
            self.state = 118
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [4]:
                self.enterOuterAlt(localctx, 1)
                self.state = 112
                self.match(stlParser.AND)
                pass
            elif token in [5]:
                self.enterOuterAlt(localctx, 2)
                self.state = 113
                self.match(stlParser.OR)
                pass
            elif token in [7]:
                self.enterOuterAlt(localctx, 3)
                self.state = 114
                self.match(stlParser.IMPLIES)
                pass
            elif token in [8]:
                self.enterOuterAlt(localctx, 4)
                self.state = 115
                self.match(stlParser.IFF)
                pass
            elif token in [21, 22]:
                self.enterOuterAlt(localctx, 5)
                self.state = 116
                _la = self._input.LA(1)
                if not(_la==21 or _la==22):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 117
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
            self.state = 123
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,10,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 120
                    self.prefix() 
                self.state = 125
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,10,self._ctx)

            self.state = 126
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

        def getRuleIndex(self):
            return stlParser.RULE_prefix




    def prefix(self):

        localctx = stlParser.PrefixContext(self, self._ctx, self.state)
        self.enterRule(localctx, 22, self.RULE_prefix)
        self._la = 0 # Token type
        try:
            self.state = 132
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [6]:
                self.enterOuterAlt(localctx, 1)
                self.state = 128
                self.match(stlParser.NOT)
                pass
            elif token in [23]:
                self.enterOuterAlt(localctx, 2)
                self.state = 129
                self.match(stlParser.NEXT)
                pass
            elif token in [9, 10, 19, 20]:
                self.enterOuterAlt(localctx, 3)
                self.state = 130
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 1574400) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 131
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
        self.enterRule(localctx, 24, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 146
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [41]:
                self.enterOuterAlt(localctx, 1)
                self.state = 134
                self.match(stlParser.GROUP)
                pass
            elif token in [24]:
                self.enterOuterAlt(localctx, 2)
                self.state = 135
                self.match(stlParser.OPEN)
                self.state = 136
                self.level()
                self.state = 141
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==31:
                    self.state = 137
                    self.match(stlParser.COMMA)
                    self.state = 138
                    self.level()
                    self.state = 143
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 144
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
        self.enterRule(localctx, 26, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 148
            self.match(stlParser.LBRACKET)
            self.state = 149
            self.bound()
            self.state = 150
            self.match(stlParser.COMMA)
            self.state = 151
            self.bound()
            self.state = 152
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
        self.enterRule(localctx, 28, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 155
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==27:
                self.state = 154
                self.match(stlParser.MINUS)


            self.state = 157
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
        self.enterRule(localctx, 30, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 159
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
        self.enterRule(localctx, 32, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 161
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
        self.enterRule(localctx, 34, self.RULE_name)
        try:
            self.state = 166
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [37]:
                self.enterOuterAlt(localctx, 1)
                self.state = 163
                self.match(stlParser.NAME)
                pass
            elif token in [38]:
                self.enterOuterAlt(localctx, 2)
                self.state = 164
                self.match(stlParser.STRING)
                pass
            elif token in [1, 2, 3, 19, 20, 21, 22, 23]:
                self.enterOuterAlt(localctx, 3)
                self.state = 165
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
            return self.getToken(stlParser.EVENTUALLY, 0)

        def ALWAYS(self):
            return self.getToken(stlParser.ALWAYS, 0)

        def UNTIL(self):
            return self.getToken(stlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(stlParser.RELEASE, 0)

        def NEXT(self):
            return self.getToken(stlParser.NEXT, 0)

        def getRuleIndex(self):
            return stlParser.RULE_letter




    def letter(self):

        localctx = stlParser.LetterContext(self, self._ctx, self.state)
        self.enterRule(localctx, 36, self.RULE_letter)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 168
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 16252928) != 0)):
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





