# Generated from mtl.g4 by ANTLR 4.13.1
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
        4,1,44,171,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,2,19,7,19,1,0,
        1,0,1,0,1,0,5,0,45,8,0,10,0,12,0,48,9,0,1,1,1,1,1,1,1,1,3,1,54,8,
        1,1,2,3,2,57,8,2,1,2,1,2,3,2,61,8,2,1,3,1,3,1,3,3,3,66,8,3,1,4,1,
        4,1,4,1,4,1,4,3,4,73,8,4,1,4,1,4,1,5,1,5,1,5,1,5,1,5,1,6,1,6,1,6,
        1,6,1,6,3,6,87,8,6,1,7,1,7,1,7,5,7,92,8,7,10,7,12,7,95,9,7,1,7,1,
        7,1,8,1,8,1,8,1,8,5,8,103,8,8,10,8,12,8,106,9,8,1,9,1,9,1,9,1,9,
        1,9,1,9,3,9,114,8,9,1,10,5,10,117,8,10,10,10,12,10,120,9,10,1,10,
        1,10,3,10,124,8,10,1,11,1,11,1,11,1,11,3,11,130,8,11,1,12,1,12,1,
        12,1,13,1,13,1,13,1,13,1,13,5,13,140,8,13,10,13,12,13,143,9,13,1,
        13,1,13,3,13,147,8,13,1,14,1,14,1,14,1,14,1,14,1,14,1,15,3,15,156,
        8,15,1,15,1,15,1,16,1,16,1,17,1,17,1,18,1,18,1,18,3,18,167,8,18,
        1,19,1,19,1,19,1,118,0,20,0,2,4,6,8,10,12,14,16,18,20,22,24,26,28,
        30,32,34,36,38,0,7,1,0,1,3,1,0,22,23,3,0,10,11,20,21,25,26,1,0,25,
        26,1,0,12,17,1,0,18,19,1,0,20,26,178,0,40,1,0,0,0,2,53,1,0,0,0,4,
        56,1,0,0,0,6,65,1,0,0,0,8,67,1,0,0,0,10,76,1,0,0,0,12,86,1,0,0,0,
        14,88,1,0,0,0,16,98,1,0,0,0,18,113,1,0,0,0,20,118,1,0,0,0,22,129,
        1,0,0,0,24,131,1,0,0,0,26,146,1,0,0,0,28,148,1,0,0,0,30,155,1,0,
        0,0,32,159,1,0,0,0,34,161,1,0,0,0,36,166,1,0,0,0,38,168,1,0,0,0,
        40,46,3,2,1,0,41,42,3,32,16,0,42,43,3,2,1,0,43,45,1,0,0,0,44,41,
        1,0,0,0,45,48,1,0,0,0,46,44,1,0,0,0,46,47,1,0,0,0,47,1,1,0,0,0,48,
        46,1,0,0,0,49,54,3,34,17,0,50,54,3,4,2,0,51,54,3,6,3,0,52,54,3,26,
        13,0,53,49,1,0,0,0,53,50,1,0,0,0,53,51,1,0,0,0,53,52,1,0,0,0,54,
        3,1,0,0,0,55,57,5,30,0,0,56,55,1,0,0,0,56,57,1,0,0,0,57,58,1,0,0,
        0,58,60,5,39,0,0,59,61,5,33,0,0,60,59,1,0,0,0,60,61,1,0,0,0,61,5,
        1,0,0,0,62,66,3,8,4,0,63,66,3,10,5,0,64,66,3,36,18,0,65,62,1,0,0,
        0,65,63,1,0,0,0,65,64,1,0,0,0,66,7,1,0,0,0,67,68,7,0,0,0,68,69,5,
        27,0,0,69,72,3,36,18,0,70,71,5,34,0,0,71,73,3,36,18,0,72,70,1,0,
        0,0,72,73,1,0,0,0,73,74,1,0,0,0,74,75,5,28,0,0,75,9,1,0,0,0,76,77,
        5,4,0,0,77,78,5,27,0,0,78,79,3,4,2,0,79,80,5,28,0,0,80,11,1,0,0,
        0,81,87,3,38,19,0,82,87,5,1,0,0,83,87,5,2,0,0,84,87,5,3,0,0,85,87,
        5,4,0,0,86,81,1,0,0,0,86,82,1,0,0,0,86,83,1,0,0,0,86,84,1,0,0,0,
        86,85,1,0,0,0,87,13,1,0,0,0,88,93,3,16,8,0,89,90,5,34,0,0,90,92,
        3,16,8,0,91,89,1,0,0,0,92,95,1,0,0,0,93,91,1,0,0,0,93,94,1,0,0,0,
        94,96,1,0,0,0,95,93,1,0,0,0,96,97,5,0,0,1,97,15,1,0,0,0,98,104,3,
        20,10,0,99,100,3,18,9,0,100,101,3,20,10,0,101,103,1,0,0,0,102,99,
        1,0,0,0,103,106,1,0,0,0,104,102,1,0,0,0,104,105,1,0,0,0,105,17,1,
        0,0,0,106,104,1,0,0,0,107,114,5,5,0,0,108,114,5,6,0,0,109,114,5,
        8,0,0,110,114,5,9,0,0,111,112,7,1,0,0,112,114,3,28,14,0,113,107,
        1,0,0,0,113,108,1,0,0,0,113,109,1,0,0,0,113,110,1,0,0,0,113,111,
        1,0,0,0,114,19,1,0,0,0,115,117,3,22,11,0,116,115,1,0,0,0,117,120,
        1,0,0,0,118,119,1,0,0,0,118,116,1,0,0,0,119,123,1,0,0,0,120,118,
        1,0,0,0,121,124,3,0,0,0,122,124,3,24,12,0,123,121,1,0,0,0,123,122,
        1,0,0,0,124,21,1,0,0,0,125,130,5,7,0,0,126,130,5,24,0,0,127,128,
        7,2,0,0,128,130,3,28,14,0,129,125,1,0,0,0,129,126,1,0,0,0,129,127,
        1,0,0,0,130,23,1,0,0,0,131,132,7,3,0,0,132,133,3,26,13,0,133,25,
        1,0,0,0,134,147,5,44,0,0,135,136,5,27,0,0,136,141,3,16,8,0,137,138,
        5,34,0,0,138,140,3,16,8,0,139,137,1,0,0,0,140,143,1,0,0,0,141,139,
        1,0,0,0,141,142,1,0,0,0,142,144,1,0,0,0,143,141,1,0,0,0,144,145,
        5,28,0,0,145,147,1,0,0,0,146,134,1,0,0,0,146,135,1,0,0,0,147,27,
        1,0,0,0,148,149,5,35,0,0,149,150,3,30,15,0,150,151,5,34,0,0,151,
        152,3,30,15,0,152,153,5,36,0,0,153,29,1,0,0,0,154,156,5,30,0,0,155,
        154,1,0,0,0,155,156,1,0,0,0,156,157,1,0,0,0,157,158,5,39,0,0,158,
        31,1,0,0,0,159,160,7,4,0,0,160,33,1,0,0,0,161,162,7,5,0,0,162,35,
        1,0,0,0,163,167,5,40,0,0,164,167,5,41,0,0,165,167,3,12,6,0,166,163,
        1,0,0,0,166,164,1,0,0,0,166,165,1,0,0,0,167,37,1,0,0,0,168,169,7,
        6,0,0,169,39,1,0,0,0,17,46,53,56,60,65,72,86,93,104,113,118,123,
        129,141,146,155,166
    ]

class mtlParser ( Parser ):

    grammarFileName = "mtl.g4"

    atn = ATNDeserializer().deserialize(serializedATN())

    decisionsToDFA = [ DFA(ds, i) for i, ds in enumerate(atn.decisionToState) ]

    sharedContextCache = PredictionContextCache()

    literalNames = [ "<INVALID>", "'sum'", "'min'", "'max'", "'known'", 
                     "<INVALID>", "<INVALID>", "<INVALID>", "<INVALID>", 
                     "<INVALID>", "'<>'", "'[]'", "'>='", "'<='", "'>'", 
                     "'<'", "<INVALID>", "'!='", "<INVALID>", "<INVALID>", 
                     "'F'", "'G'", "'U'", "'R'", "'X'", "'one'", "'all'", 
                     "'('", "')'", "'+'", "'-'", "'*'", "'/'", "'%'", "','", 
                     "'['", "']'", "'{'", "'}'" ]

    symbolicNames = [ "<INVALID>", "SUM", "MIN", "MAX", "KNOWN", "AND", 
                      "OR", "NOT", "IMPLIES", "IFF", "DIAMOND", "BOX", "GE", 
                      "LE", "GT", "LT", "EQ", "NE", "TRUE", "FALSE", "EVENTUALLY", 
                      "ALWAYS", "UNTIL", "RELEASE", "NEXT", "ONE", "ALL", 
                      "OPEN", "CLOSE", "PLUS", "MINUS", "STAR", "SLASH", 
                      "PERCENT", "COMMA", "LBRACKET", "RBRACKET", "LBRACE", 
                      "RBRACE", "NUMBER", "NAME", "STRING", "SPACE", "STRAY", 
                      "GROUP" ]

    RULE_comparison = 0
    RULE_operand = 1
    RULE_number = 2
    RULE_atom = 3
    RULE_count = 4
    RULE_known = 5
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

    ruleNames =  [ "comparison", "operand", "number", "atom", "count", "known", 
                   "reserved", "formula", "level", "connective", "unary", 
                   "prefix", "joined", "parts", "interval", "bound", "relation", 
                   "constant", "name", "word" ]

    EOF = Token.EOF
    SUM=1
    MIN=2
    MAX=3
    KNOWN=4
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




    class ComparisonContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def operand(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(mtlParser.OperandContext)
            else:
                return self.getTypedRuleContext(mtlParser.OperandContext,i)


        def relation(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(mtlParser.RelationContext)
            else:
                return self.getTypedRuleContext(mtlParser.RelationContext,i)


        def getRuleIndex(self):
            return mtlParser.RULE_comparison




    def comparison(self):

        localctx = mtlParser.ComparisonContext(self, self._ctx, self.state)
        self.enterRule(localctx, 0, self.RULE_comparison)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 40
            self.operand()
            self.state = 46
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 258048) != 0):
                self.state = 41
                self.relation()
                self.state = 42
                self.operand()
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


    class OperandContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def constant(self):
            return self.getTypedRuleContext(mtlParser.ConstantContext,0)


        def number(self):
            return self.getTypedRuleContext(mtlParser.NumberContext,0)


        def atom(self):
            return self.getTypedRuleContext(mtlParser.AtomContext,0)


        def parts(self):
            return self.getTypedRuleContext(mtlParser.PartsContext,0)


        def getRuleIndex(self):
            return mtlParser.RULE_operand




    def operand(self):

        localctx = mtlParser.OperandContext(self, self._ctx, self.state)
        self.enterRule(localctx, 2, self.RULE_operand)
        try:
            self.state = 53
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [18, 19]:
                self.enterOuterAlt(localctx, 1)
                self.state = 49
                self.constant()
                pass
            elif token in [30, 39]:
                self.enterOuterAlt(localctx, 2)
                self.state = 50
                self.number()
                pass
            elif token in [1, 2, 3, 4, 20, 21, 22, 23, 24, 25, 26, 40, 41]:
                self.enterOuterAlt(localctx, 3)
                self.state = 51
                self.atom()
                pass
            elif token in [27, 44]:
                self.enterOuterAlt(localctx, 4)
                self.state = 52
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
            return self.getToken(mtlParser.NUMBER, 0)

        def MINUS(self):
            return self.getToken(mtlParser.MINUS, 0)

        def PERCENT(self):
            return self.getToken(mtlParser.PERCENT, 0)

        def getRuleIndex(self):
            return mtlParser.RULE_number




    def number(self):

        localctx = mtlParser.NumberContext(self, self._ctx, self.state)
        self.enterRule(localctx, 4, self.RULE_number)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 56
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==30:
                self.state = 55
                self.match(mtlParser.MINUS)


            self.state = 58
            self.match(mtlParser.NUMBER)
            self.state = 60
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==33:
                self.state = 59
                self.match(mtlParser.PERCENT)


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
            return self.getTypedRuleContext(mtlParser.CountContext,0)


        def known(self):
            return self.getTypedRuleContext(mtlParser.KnownContext,0)


        def name(self):
            return self.getTypedRuleContext(mtlParser.NameContext,0)


        def getRuleIndex(self):
            return mtlParser.RULE_atom




    def atom(self):

        localctx = mtlParser.AtomContext(self, self._ctx, self.state)
        self.enterRule(localctx, 6, self.RULE_atom)
        try:
            self.state = 65
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,4,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 62
                self.count()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 63
                self.known()
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 64
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
            return self.getToken(mtlParser.OPEN, 0)

        def name(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(mtlParser.NameContext)
            else:
                return self.getTypedRuleContext(mtlParser.NameContext,i)


        def CLOSE(self):
            return self.getToken(mtlParser.CLOSE, 0)

        def SUM(self):
            return self.getToken(mtlParser.SUM, 0)

        def MIN(self):
            return self.getToken(mtlParser.MIN, 0)

        def MAX(self):
            return self.getToken(mtlParser.MAX, 0)

        def COMMA(self):
            return self.getToken(mtlParser.COMMA, 0)

        def getRuleIndex(self):
            return mtlParser.RULE_count




    def count(self):

        localctx = mtlParser.CountContext(self, self._ctx, self.state)
        self.enterRule(localctx, 8, self.RULE_count)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 67
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 14) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 68
            self.match(mtlParser.OPEN)
            self.state = 69
            self.name()
            self.state = 72
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==34:
                self.state = 70
                self.match(mtlParser.COMMA)
                self.state = 71
                self.name()


            self.state = 74
            self.match(mtlParser.CLOSE)
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
            return self.getToken(mtlParser.KNOWN, 0)

        def OPEN(self):
            return self.getToken(mtlParser.OPEN, 0)

        def number(self):
            return self.getTypedRuleContext(mtlParser.NumberContext,0)


        def CLOSE(self):
            return self.getToken(mtlParser.CLOSE, 0)

        def getRuleIndex(self):
            return mtlParser.RULE_known




    def known(self):

        localctx = mtlParser.KnownContext(self, self._ctx, self.state)
        self.enterRule(localctx, 10, self.RULE_known)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 76
            self.match(mtlParser.KNOWN)
            self.state = 77
            self.match(mtlParser.OPEN)
            self.state = 78
            self.number()
            self.state = 79
            self.match(mtlParser.CLOSE)
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
            return self.getTypedRuleContext(mtlParser.WordContext,0)


        def SUM(self):
            return self.getToken(mtlParser.SUM, 0)

        def MIN(self):
            return self.getToken(mtlParser.MIN, 0)

        def MAX(self):
            return self.getToken(mtlParser.MAX, 0)

        def KNOWN(self):
            return self.getToken(mtlParser.KNOWN, 0)

        def getRuleIndex(self):
            return mtlParser.RULE_reserved




    def reserved(self):

        localctx = mtlParser.ReservedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 12, self.RULE_reserved)
        try:
            self.state = 86
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [20, 21, 22, 23, 24, 25, 26]:
                self.enterOuterAlt(localctx, 1)
                self.state = 81
                self.word()
                pass
            elif token in [1]:
                self.enterOuterAlt(localctx, 2)
                self.state = 82
                self.match(mtlParser.SUM)
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 3)
                self.state = 83
                self.match(mtlParser.MIN)
                pass
            elif token in [3]:
                self.enterOuterAlt(localctx, 4)
                self.state = 84
                self.match(mtlParser.MAX)
                pass
            elif token in [4]:
                self.enterOuterAlt(localctx, 5)
                self.state = 85
                self.match(mtlParser.KNOWN)
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
                return self.getTypedRuleContexts(mtlParser.LevelContext)
            else:
                return self.getTypedRuleContext(mtlParser.LevelContext,i)


        def EOF(self):
            return self.getToken(mtlParser.EOF, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(mtlParser.COMMA)
            else:
                return self.getToken(mtlParser.COMMA, i)

        def getRuleIndex(self):
            return mtlParser.RULE_formula




    def formula(self):

        localctx = mtlParser.FormulaContext(self, self._ctx, self.state)
        self.enterRule(localctx, 14, self.RULE_formula)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 88
            self.level()
            self.state = 93
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==34:
                self.state = 89
                self.match(mtlParser.COMMA)
                self.state = 90
                self.level()
                self.state = 95
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 96
            self.match(mtlParser.EOF)
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
                return self.getTypedRuleContexts(mtlParser.UnaryContext)
            else:
                return self.getTypedRuleContext(mtlParser.UnaryContext,i)


        def connective(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(mtlParser.ConnectiveContext)
            else:
                return self.getTypedRuleContext(mtlParser.ConnectiveContext,i)


        def getRuleIndex(self):
            return mtlParser.RULE_level




    def level(self):

        localctx = mtlParser.LevelContext(self, self._ctx, self.state)
        self.enterRule(localctx, 16, self.RULE_level)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 98
            self.unary()
            self.state = 104
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 12583776) != 0):
                self.state = 99
                self.connective()
                self.state = 100
                self.unary()
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


    class ConnectiveContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def AND(self):
            return self.getToken(mtlParser.AND, 0)

        def OR(self):
            return self.getToken(mtlParser.OR, 0)

        def IMPLIES(self):
            return self.getToken(mtlParser.IMPLIES, 0)

        def IFF(self):
            return self.getToken(mtlParser.IFF, 0)

        def interval(self):
            return self.getTypedRuleContext(mtlParser.IntervalContext,0)


        def UNTIL(self):
            return self.getToken(mtlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(mtlParser.RELEASE, 0)

        def getRuleIndex(self):
            return mtlParser.RULE_connective




    def connective(self):

        localctx = mtlParser.ConnectiveContext(self, self._ctx, self.state)
        self.enterRule(localctx, 18, self.RULE_connective)
        self._la = 0 # Token type
        try:
            self.state = 113
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [5]:
                self.enterOuterAlt(localctx, 1)
                self.state = 107
                self.match(mtlParser.AND)
                pass
            elif token in [6]:
                self.enterOuterAlt(localctx, 2)
                self.state = 108
                self.match(mtlParser.OR)
                pass
            elif token in [8]:
                self.enterOuterAlt(localctx, 3)
                self.state = 109
                self.match(mtlParser.IMPLIES)
                pass
            elif token in [9]:
                self.enterOuterAlt(localctx, 4)
                self.state = 110
                self.match(mtlParser.IFF)
                pass
            elif token in [22, 23]:
                self.enterOuterAlt(localctx, 5)
                self.state = 111
                _la = self._input.LA(1)
                if not(_la==22 or _la==23):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 112
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
            return self.getTypedRuleContext(mtlParser.ComparisonContext,0)


        def joined(self):
            return self.getTypedRuleContext(mtlParser.JoinedContext,0)


        def prefix(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(mtlParser.PrefixContext)
            else:
                return self.getTypedRuleContext(mtlParser.PrefixContext,i)


        def getRuleIndex(self):
            return mtlParser.RULE_unary




    def unary(self):

        localctx = mtlParser.UnaryContext(self, self._ctx, self.state)
        self.enterRule(localctx, 20, self.RULE_unary)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 118
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,10,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 115
                    self.prefix() 
                self.state = 120
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,10,self._ctx)

            self.state = 123
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,11,self._ctx)
            if la_ == 1:
                self.state = 121
                self.comparison()
                pass

            elif la_ == 2:
                self.state = 122
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
            return self.getToken(mtlParser.NOT, 0)

        def NEXT(self):
            return self.getToken(mtlParser.NEXT, 0)

        def interval(self):
            return self.getTypedRuleContext(mtlParser.IntervalContext,0)


        def EVENTUALLY(self):
            return self.getToken(mtlParser.EVENTUALLY, 0)

        def DIAMOND(self):
            return self.getToken(mtlParser.DIAMOND, 0)

        def ALWAYS(self):
            return self.getToken(mtlParser.ALWAYS, 0)

        def BOX(self):
            return self.getToken(mtlParser.BOX, 0)

        def ONE(self):
            return self.getToken(mtlParser.ONE, 0)

        def ALL(self):
            return self.getToken(mtlParser.ALL, 0)

        def getRuleIndex(self):
            return mtlParser.RULE_prefix




    def prefix(self):

        localctx = mtlParser.PrefixContext(self, self._ctx, self.state)
        self.enterRule(localctx, 22, self.RULE_prefix)
        self._la = 0 # Token type
        try:
            self.state = 129
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [7]:
                self.enterOuterAlt(localctx, 1)
                self.state = 125
                self.match(mtlParser.NOT)
                pass
            elif token in [24]:
                self.enterOuterAlt(localctx, 2)
                self.state = 126
                self.match(mtlParser.NEXT)
                pass
            elif token in [10, 11, 20, 21, 25, 26]:
                self.enterOuterAlt(localctx, 3)
                self.state = 127
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 103812096) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 128
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
            return self.getTypedRuleContext(mtlParser.PartsContext,0)


        def ONE(self):
            return self.getToken(mtlParser.ONE, 0)

        def ALL(self):
            return self.getToken(mtlParser.ALL, 0)

        def getRuleIndex(self):
            return mtlParser.RULE_joined




    def joined(self):

        localctx = mtlParser.JoinedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 24, self.RULE_joined)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 131
            _la = self._input.LA(1)
            if not(_la==25 or _la==26):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 132
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
            return self.getToken(mtlParser.GROUP, 0)

        def OPEN(self):
            return self.getToken(mtlParser.OPEN, 0)

        def level(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(mtlParser.LevelContext)
            else:
                return self.getTypedRuleContext(mtlParser.LevelContext,i)


        def CLOSE(self):
            return self.getToken(mtlParser.CLOSE, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(mtlParser.COMMA)
            else:
                return self.getToken(mtlParser.COMMA, i)

        def getRuleIndex(self):
            return mtlParser.RULE_parts




    def parts(self):

        localctx = mtlParser.PartsContext(self, self._ctx, self.state)
        self.enterRule(localctx, 26, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 146
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [44]:
                self.enterOuterAlt(localctx, 1)
                self.state = 134
                self.match(mtlParser.GROUP)
                pass
            elif token in [27]:
                self.enterOuterAlt(localctx, 2)
                self.state = 135
                self.match(mtlParser.OPEN)
                self.state = 136
                self.level()
                self.state = 141
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==34:
                    self.state = 137
                    self.match(mtlParser.COMMA)
                    self.state = 138
                    self.level()
                    self.state = 143
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 144
                self.match(mtlParser.CLOSE)
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
            return self.getToken(mtlParser.LBRACKET, 0)

        def bound(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(mtlParser.BoundContext)
            else:
                return self.getTypedRuleContext(mtlParser.BoundContext,i)


        def COMMA(self):
            return self.getToken(mtlParser.COMMA, 0)

        def RBRACKET(self):
            return self.getToken(mtlParser.RBRACKET, 0)

        def getRuleIndex(self):
            return mtlParser.RULE_interval




    def interval(self):

        localctx = mtlParser.IntervalContext(self, self._ctx, self.state)
        self.enterRule(localctx, 28, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 148
            self.match(mtlParser.LBRACKET)
            self.state = 149
            self.bound()
            self.state = 150
            self.match(mtlParser.COMMA)
            self.state = 151
            self.bound()
            self.state = 152
            self.match(mtlParser.RBRACKET)
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
            return self.getToken(mtlParser.NUMBER, 0)

        def MINUS(self):
            return self.getToken(mtlParser.MINUS, 0)

        def getRuleIndex(self):
            return mtlParser.RULE_bound




    def bound(self):

        localctx = mtlParser.BoundContext(self, self._ctx, self.state)
        self.enterRule(localctx, 30, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 155
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==30:
                self.state = 154
                self.match(mtlParser.MINUS)


            self.state = 157
            self.match(mtlParser.NUMBER)
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
            return self.getToken(mtlParser.GE, 0)

        def LE(self):
            return self.getToken(mtlParser.LE, 0)

        def GT(self):
            return self.getToken(mtlParser.GT, 0)

        def LT(self):
            return self.getToken(mtlParser.LT, 0)

        def EQ(self):
            return self.getToken(mtlParser.EQ, 0)

        def NE(self):
            return self.getToken(mtlParser.NE, 0)

        def getRuleIndex(self):
            return mtlParser.RULE_relation




    def relation(self):

        localctx = mtlParser.RelationContext(self, self._ctx, self.state)
        self.enterRule(localctx, 32, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 159
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
            return self.getToken(mtlParser.TRUE, 0)

        def FALSE(self):
            return self.getToken(mtlParser.FALSE, 0)

        def getRuleIndex(self):
            return mtlParser.RULE_constant




    def constant(self):

        localctx = mtlParser.ConstantContext(self, self._ctx, self.state)
        self.enterRule(localctx, 34, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 161
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
            return self.getToken(mtlParser.NAME, 0)

        def STRING(self):
            return self.getToken(mtlParser.STRING, 0)

        def reserved(self):
            return self.getTypedRuleContext(mtlParser.ReservedContext,0)


        def getRuleIndex(self):
            return mtlParser.RULE_name




    def name(self):

        localctx = mtlParser.NameContext(self, self._ctx, self.state)
        self.enterRule(localctx, 36, self.RULE_name)
        try:
            self.state = 166
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [40]:
                self.enterOuterAlt(localctx, 1)
                self.state = 163
                self.match(mtlParser.NAME)
                pass
            elif token in [41]:
                self.enterOuterAlt(localctx, 2)
                self.state = 164
                self.match(mtlParser.STRING)
                pass
            elif token in [1, 2, 3, 4, 20, 21, 22, 23, 24, 25, 26]:
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


    class WordContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def EVENTUALLY(self):
            return self.getToken(mtlParser.EVENTUALLY, 0)

        def ALWAYS(self):
            return self.getToken(mtlParser.ALWAYS, 0)

        def UNTIL(self):
            return self.getToken(mtlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(mtlParser.RELEASE, 0)

        def NEXT(self):
            return self.getToken(mtlParser.NEXT, 0)

        def ONE(self):
            return self.getToken(mtlParser.ONE, 0)

        def ALL(self):
            return self.getToken(mtlParser.ALL, 0)

        def getRuleIndex(self):
            return mtlParser.RULE_word




    def word(self):

        localctx = mtlParser.WordContext(self, self._ctx, self.state)
        self.enterRule(localctx, 38, self.RULE_word)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 168
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





