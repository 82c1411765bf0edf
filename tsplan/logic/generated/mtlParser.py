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
        4,1,43,162,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,1,0,1,0,1,0,1,
        0,5,0,43,8,0,10,0,12,0,46,9,0,1,1,1,1,1,1,1,1,3,1,52,8,1,1,2,3,2,
        55,8,2,1,2,1,2,3,2,59,8,2,1,3,1,3,3,3,63,8,3,1,4,1,4,1,4,1,4,1,4,
        3,4,70,8,4,1,4,1,4,1,5,1,5,1,5,1,5,3,5,78,8,5,1,6,1,6,1,6,5,6,83,
        8,6,10,6,12,6,86,9,6,1,6,1,6,1,7,1,7,1,7,1,7,5,7,94,8,7,10,7,12,
        7,97,9,7,1,8,1,8,1,8,1,8,1,8,1,8,3,8,105,8,8,1,9,5,9,108,8,9,10,
        9,12,9,111,9,9,1,9,1,9,3,9,115,8,9,1,10,1,10,1,10,1,10,3,10,121,
        8,10,1,11,1,11,1,11,1,12,1,12,1,12,1,12,1,12,5,12,131,8,12,10,12,
        12,12,134,9,12,1,12,1,12,3,12,138,8,12,1,13,1,13,1,13,1,13,1,13,
        1,13,1,14,3,14,147,8,14,1,14,1,14,1,15,1,15,1,16,1,16,1,17,1,17,
        1,17,3,17,158,8,17,1,18,1,18,1,18,1,109,0,19,0,2,4,6,8,10,12,14,
        16,18,20,22,24,26,28,30,32,34,36,0,7,1,0,1,3,1,0,21,22,3,0,9,10,
        19,20,24,25,1,0,24,25,1,0,11,16,1,0,17,18,1,0,19,25,168,0,38,1,0,
        0,0,2,51,1,0,0,0,4,54,1,0,0,0,6,62,1,0,0,0,8,64,1,0,0,0,10,77,1,
        0,0,0,12,79,1,0,0,0,14,89,1,0,0,0,16,104,1,0,0,0,18,109,1,0,0,0,
        20,120,1,0,0,0,22,122,1,0,0,0,24,137,1,0,0,0,26,139,1,0,0,0,28,146,
        1,0,0,0,30,150,1,0,0,0,32,152,1,0,0,0,34,157,1,0,0,0,36,159,1,0,
        0,0,38,44,3,2,1,0,39,40,3,30,15,0,40,41,3,2,1,0,41,43,1,0,0,0,42,
        39,1,0,0,0,43,46,1,0,0,0,44,42,1,0,0,0,44,45,1,0,0,0,45,1,1,0,0,
        0,46,44,1,0,0,0,47,52,3,32,16,0,48,52,3,4,2,0,49,52,3,6,3,0,50,52,
        3,24,12,0,51,47,1,0,0,0,51,48,1,0,0,0,51,49,1,0,0,0,51,50,1,0,0,
        0,52,3,1,0,0,0,53,55,5,29,0,0,54,53,1,0,0,0,54,55,1,0,0,0,55,56,
        1,0,0,0,56,58,5,38,0,0,57,59,5,32,0,0,58,57,1,0,0,0,58,59,1,0,0,
        0,59,5,1,0,0,0,60,63,3,8,4,0,61,63,3,34,17,0,62,60,1,0,0,0,62,61,
        1,0,0,0,63,7,1,0,0,0,64,65,7,0,0,0,65,66,5,26,0,0,66,69,3,34,17,
        0,67,68,5,33,0,0,68,70,3,34,17,0,69,67,1,0,0,0,69,70,1,0,0,0,70,
        71,1,0,0,0,71,72,5,27,0,0,72,9,1,0,0,0,73,78,3,36,18,0,74,78,5,1,
        0,0,75,78,5,2,0,0,76,78,5,3,0,0,77,73,1,0,0,0,77,74,1,0,0,0,77,75,
        1,0,0,0,77,76,1,0,0,0,78,11,1,0,0,0,79,84,3,14,7,0,80,81,5,33,0,
        0,81,83,3,14,7,0,82,80,1,0,0,0,83,86,1,0,0,0,84,82,1,0,0,0,84,85,
        1,0,0,0,85,87,1,0,0,0,86,84,1,0,0,0,87,88,5,0,0,1,88,13,1,0,0,0,
        89,95,3,18,9,0,90,91,3,16,8,0,91,92,3,18,9,0,92,94,1,0,0,0,93,90,
        1,0,0,0,94,97,1,0,0,0,95,93,1,0,0,0,95,96,1,0,0,0,96,15,1,0,0,0,
        97,95,1,0,0,0,98,105,5,4,0,0,99,105,5,5,0,0,100,105,5,7,0,0,101,
        105,5,8,0,0,102,103,7,1,0,0,103,105,3,26,13,0,104,98,1,0,0,0,104,
        99,1,0,0,0,104,100,1,0,0,0,104,101,1,0,0,0,104,102,1,0,0,0,105,17,
        1,0,0,0,106,108,3,20,10,0,107,106,1,0,0,0,108,111,1,0,0,0,109,110,
        1,0,0,0,109,107,1,0,0,0,110,114,1,0,0,0,111,109,1,0,0,0,112,115,
        3,0,0,0,113,115,3,22,11,0,114,112,1,0,0,0,114,113,1,0,0,0,115,19,
        1,0,0,0,116,121,5,6,0,0,117,121,5,23,0,0,118,119,7,2,0,0,119,121,
        3,26,13,0,120,116,1,0,0,0,120,117,1,0,0,0,120,118,1,0,0,0,121,21,
        1,0,0,0,122,123,7,3,0,0,123,124,3,24,12,0,124,23,1,0,0,0,125,138,
        5,43,0,0,126,127,5,26,0,0,127,132,3,14,7,0,128,129,5,33,0,0,129,
        131,3,14,7,0,130,128,1,0,0,0,131,134,1,0,0,0,132,130,1,0,0,0,132,
        133,1,0,0,0,133,135,1,0,0,0,134,132,1,0,0,0,135,136,5,27,0,0,136,
        138,1,0,0,0,137,125,1,0,0,0,137,126,1,0,0,0,138,25,1,0,0,0,139,140,
        5,34,0,0,140,141,3,28,14,0,141,142,5,33,0,0,142,143,3,28,14,0,143,
        144,5,35,0,0,144,27,1,0,0,0,145,147,5,29,0,0,146,145,1,0,0,0,146,
        147,1,0,0,0,147,148,1,0,0,0,148,149,5,38,0,0,149,29,1,0,0,0,150,
        151,7,4,0,0,151,31,1,0,0,0,152,153,7,5,0,0,153,33,1,0,0,0,154,158,
        5,39,0,0,155,158,5,40,0,0,156,158,3,10,5,0,157,154,1,0,0,0,157,155,
        1,0,0,0,157,156,1,0,0,0,158,35,1,0,0,0,159,160,7,6,0,0,160,37,1,
        0,0,0,17,44,51,54,58,62,69,77,84,95,104,109,114,120,132,137,146,
        157
    ]

class mtlParser ( Parser ):

    grammarFileName = "mtl.g4"

    atn = ATNDeserializer().deserialize(serializedATN())

    decisionsToDFA = [ DFA(ds, i) for i, ds in enumerate(atn.decisionToState) ]

    sharedContextCache = PredictionContextCache()

    literalNames = [ "<INVALID>", "'sum'", "'min'", "'max'", "<INVALID>", 
                     "<INVALID>", "<INVALID>", "<INVALID>", "<INVALID>", 
                     "'<>'", "'[]'", "'>='", "'<='", "'>'", "'<'", "<INVALID>", 
                     "'!='", "<INVALID>", "<INVALID>", "'F'", "'G'", "'U'", 
                     "'R'", "'X'", "'one'", "'all'", "'('", "')'", "'+'", 
                     "'-'", "'*'", "'/'", "'%'", "','", "'['", "']'", "'{'", 
                     "'}'" ]

    symbolicNames = [ "<INVALID>", "SUM", "MIN", "MAX", "AND", "OR", "NOT", 
                      "IMPLIES", "IFF", "DIAMOND", "BOX", "GE", "LE", "GT", 
                      "LT", "EQ", "NE", "TRUE", "FALSE", "EVENTUALLY", "ALWAYS", 
                      "UNTIL", "RELEASE", "NEXT", "ONE", "ALL", "OPEN", 
                      "CLOSE", "PLUS", "MINUS", "STAR", "SLASH", "PERCENT", 
                      "COMMA", "LBRACKET", "RBRACKET", "LBRACE", "RBRACE", 
                      "NUMBER", "NAME", "STRING", "SPACE", "STRAY", "GROUP" ]

    RULE_comparison = 0
    RULE_operand = 1
    RULE_number = 2
    RULE_atom = 3
    RULE_count = 4
    RULE_reserved = 5
    RULE_formula = 6
    RULE_level = 7
    RULE_connective = 8
    RULE_unary = 9
    RULE_prefix = 10
    RULE_joined = 11
    RULE_parts = 12
    RULE_interval = 13
    RULE_bound = 14
    RULE_relation = 15
    RULE_constant = 16
    RULE_name = 17
    RULE_word = 18

    ruleNames =  [ "comparison", "operand", "number", "atom", "count", "reserved", 
                   "formula", "level", "connective", "unary", "prefix", 
                   "joined", "parts", "interval", "bound", "relation", "constant", 
                   "name", "word" ]

    EOF = Token.EOF
    SUM=1
    MIN=2
    MAX=3
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
            self.state = 38
            self.operand()
            self.state = 44
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 129024) != 0):
                self.state = 39
                self.relation()
                self.state = 40
                self.operand()
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
            self.state = 51
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [17, 18]:
                self.enterOuterAlt(localctx, 1)
                self.state = 47
                self.constant()
                pass
            elif token in [29, 38]:
                self.enterOuterAlt(localctx, 2)
                self.state = 48
                self.number()
                pass
            elif token in [1, 2, 3, 19, 20, 21, 22, 23, 24, 25, 39, 40]:
                self.enterOuterAlt(localctx, 3)
                self.state = 49
                self.atom()
                pass
            elif token in [26, 43]:
                self.enterOuterAlt(localctx, 4)
                self.state = 50
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
            self.state = 54
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==29:
                self.state = 53
                self.match(mtlParser.MINUS)


            self.state = 56
            self.match(mtlParser.NUMBER)
            self.state = 58
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==32:
                self.state = 57
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


        def name(self):
            return self.getTypedRuleContext(mtlParser.NameContext,0)


        def getRuleIndex(self):
            return mtlParser.RULE_atom




    def atom(self):

        localctx = mtlParser.AtomContext(self, self._ctx, self.state)
        self.enterRule(localctx, 6, self.RULE_atom)
        try:
            self.state = 62
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,4,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 60
                self.count()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 61
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
            self.state = 64
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 14) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 65
            self.match(mtlParser.OPEN)
            self.state = 66
            self.name()
            self.state = 69
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==33:
                self.state = 67
                self.match(mtlParser.COMMA)
                self.state = 68
                self.name()


            self.state = 71
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

        def getRuleIndex(self):
            return mtlParser.RULE_reserved




    def reserved(self):

        localctx = mtlParser.ReservedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 10, self.RULE_reserved)
        try:
            self.state = 77
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [19, 20, 21, 22, 23, 24, 25]:
                self.enterOuterAlt(localctx, 1)
                self.state = 73
                self.word()
                pass
            elif token in [1]:
                self.enterOuterAlt(localctx, 2)
                self.state = 74
                self.match(mtlParser.SUM)
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 3)
                self.state = 75
                self.match(mtlParser.MIN)
                pass
            elif token in [3]:
                self.enterOuterAlt(localctx, 4)
                self.state = 76
                self.match(mtlParser.MAX)
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
        self.enterRule(localctx, 12, self.RULE_formula)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 79
            self.level()
            self.state = 84
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==33:
                self.state = 80
                self.match(mtlParser.COMMA)
                self.state = 81
                self.level()
                self.state = 86
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 87
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
        self.enterRule(localctx, 14, self.RULE_level)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 89
            self.unary()
            self.state = 95
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 6291888) != 0):
                self.state = 90
                self.connective()
                self.state = 91
                self.unary()
                self.state = 97
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
        self.enterRule(localctx, 16, self.RULE_connective)
        self._la = 0 # Token type
        try:
            self.state = 104
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [4]:
                self.enterOuterAlt(localctx, 1)
                self.state = 98
                self.match(mtlParser.AND)
                pass
            elif token in [5]:
                self.enterOuterAlt(localctx, 2)
                self.state = 99
                self.match(mtlParser.OR)
                pass
            elif token in [7]:
                self.enterOuterAlt(localctx, 3)
                self.state = 100
                self.match(mtlParser.IMPLIES)
                pass
            elif token in [8]:
                self.enterOuterAlt(localctx, 4)
                self.state = 101
                self.match(mtlParser.IFF)
                pass
            elif token in [21, 22]:
                self.enterOuterAlt(localctx, 5)
                self.state = 102
                _la = self._input.LA(1)
                if not(_la==21 or _la==22):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 103
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
        self.enterRule(localctx, 18, self.RULE_unary)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 109
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,10,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 106
                    self.prefix() 
                self.state = 111
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,10,self._ctx)

            self.state = 114
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,11,self._ctx)
            if la_ == 1:
                self.state = 112
                self.comparison()
                pass

            elif la_ == 2:
                self.state = 113
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
        self.enterRule(localctx, 20, self.RULE_prefix)
        self._la = 0 # Token type
        try:
            self.state = 120
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [6]:
                self.enterOuterAlt(localctx, 1)
                self.state = 116
                self.match(mtlParser.NOT)
                pass
            elif token in [23]:
                self.enterOuterAlt(localctx, 2)
                self.state = 117
                self.match(mtlParser.NEXT)
                pass
            elif token in [9, 10, 19, 20, 24, 25]:
                self.enterOuterAlt(localctx, 3)
                self.state = 118
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 51906048) != 0)):
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
        self.enterRule(localctx, 22, self.RULE_joined)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 122
            _la = self._input.LA(1)
            if not(_la==24 or _la==25):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 123
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
        self.enterRule(localctx, 24, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 137
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [43]:
                self.enterOuterAlt(localctx, 1)
                self.state = 125
                self.match(mtlParser.GROUP)
                pass
            elif token in [26]:
                self.enterOuterAlt(localctx, 2)
                self.state = 126
                self.match(mtlParser.OPEN)
                self.state = 127
                self.level()
                self.state = 132
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==33:
                    self.state = 128
                    self.match(mtlParser.COMMA)
                    self.state = 129
                    self.level()
                    self.state = 134
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 135
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
        self.enterRule(localctx, 26, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 139
            self.match(mtlParser.LBRACKET)
            self.state = 140
            self.bound()
            self.state = 141
            self.match(mtlParser.COMMA)
            self.state = 142
            self.bound()
            self.state = 143
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
        self.enterRule(localctx, 28, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 146
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==29:
                self.state = 145
                self.match(mtlParser.MINUS)


            self.state = 148
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
        self.enterRule(localctx, 30, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 150
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
            return self.getToken(mtlParser.TRUE, 0)

        def FALSE(self):
            return self.getToken(mtlParser.FALSE, 0)

        def getRuleIndex(self):
            return mtlParser.RULE_constant




    def constant(self):

        localctx = mtlParser.ConstantContext(self, self._ctx, self.state)
        self.enterRule(localctx, 32, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 152
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
            return self.getToken(mtlParser.NAME, 0)

        def STRING(self):
            return self.getToken(mtlParser.STRING, 0)

        def reserved(self):
            return self.getTypedRuleContext(mtlParser.ReservedContext,0)


        def getRuleIndex(self):
            return mtlParser.RULE_name




    def name(self):

        localctx = mtlParser.NameContext(self, self._ctx, self.state)
        self.enterRule(localctx, 34, self.RULE_name)
        try:
            self.state = 157
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [39]:
                self.enterOuterAlt(localctx, 1)
                self.state = 154
                self.match(mtlParser.NAME)
                pass
            elif token in [40]:
                self.enterOuterAlt(localctx, 2)
                self.state = 155
                self.match(mtlParser.STRING)
                pass
            elif token in [1, 2, 3, 19, 20, 21, 22, 23, 24, 25]:
                self.enterOuterAlt(localctx, 3)
                self.state = 156
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
        self.enterRule(localctx, 36, self.RULE_word)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 159
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





