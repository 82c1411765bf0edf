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
        4,1,38,136,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,1,0,1,0,1,0,1,0,5,0,39,8,0,10,0,12,
        0,42,9,0,1,1,1,1,1,1,5,1,47,8,1,10,1,12,1,50,9,1,1,2,1,2,1,2,5,2,
        55,8,2,10,2,12,2,58,9,2,1,3,5,3,61,8,3,10,3,12,3,64,9,3,1,3,1,3,
        1,4,1,4,1,4,1,4,1,4,1,4,1,4,1,4,3,4,76,8,4,1,5,1,5,1,6,1,6,1,6,1,
        7,1,7,1,7,1,7,5,7,87,8,7,10,7,12,7,90,9,7,1,8,1,8,1,8,1,8,1,8,1,
        8,3,8,98,8,8,1,9,5,9,101,8,9,10,9,12,9,104,9,9,1,9,1,9,1,10,1,10,
        1,10,1,10,3,10,112,8,10,1,11,1,11,1,11,1,11,1,11,1,11,1,12,3,12,
        121,8,12,1,12,1,12,1,13,1,13,1,14,1,14,1,15,1,15,1,15,3,15,132,8,
        15,1,16,1,16,1,16,1,102,0,17,0,2,4,6,8,10,12,14,16,18,20,22,24,26,
        28,30,32,0,7,1,0,23,24,1,0,25,26,1,0,18,19,2,0,6,7,16,17,1,0,8,13,
        1,0,14,15,1,0,16,20,137,0,34,1,0,0,0,2,43,1,0,0,0,4,51,1,0,0,0,6,
        62,1,0,0,0,8,75,1,0,0,0,10,77,1,0,0,0,12,79,1,0,0,0,14,82,1,0,0,
        0,16,97,1,0,0,0,18,102,1,0,0,0,20,111,1,0,0,0,22,113,1,0,0,0,24,
        120,1,0,0,0,26,124,1,0,0,0,28,126,1,0,0,0,30,131,1,0,0,0,32,133,
        1,0,0,0,34,40,3,2,1,0,35,36,3,26,13,0,36,37,3,2,1,0,37,39,1,0,0,
        0,38,35,1,0,0,0,39,42,1,0,0,0,40,38,1,0,0,0,40,41,1,0,0,0,41,1,1,
        0,0,0,42,40,1,0,0,0,43,48,3,4,2,0,44,45,7,0,0,0,45,47,3,4,2,0,46,
        44,1,0,0,0,47,50,1,0,0,0,48,46,1,0,0,0,48,49,1,0,0,0,49,3,1,0,0,
        0,50,48,1,0,0,0,51,56,3,6,3,0,52,53,7,1,0,0,53,55,3,6,3,0,54,52,
        1,0,0,0,55,58,1,0,0,0,56,54,1,0,0,0,56,57,1,0,0,0,57,5,1,0,0,0,58,
        56,1,0,0,0,59,61,7,0,0,0,60,59,1,0,0,0,61,64,1,0,0,0,62,60,1,0,0,
        0,62,63,1,0,0,0,63,65,1,0,0,0,64,62,1,0,0,0,65,66,3,8,4,0,66,7,1,
        0,0,0,67,76,3,28,14,0,68,76,5,33,0,0,69,76,3,30,15,0,70,76,5,38,
        0,0,71,72,5,21,0,0,72,73,3,14,7,0,73,74,5,22,0,0,74,76,1,0,0,0,75,
        67,1,0,0,0,75,68,1,0,0,0,75,69,1,0,0,0,75,70,1,0,0,0,75,71,1,0,0,
        0,76,9,1,0,0,0,77,78,3,32,16,0,78,11,1,0,0,0,79,80,3,14,7,0,80,81,
        5,0,0,1,81,13,1,0,0,0,82,88,3,18,9,0,83,84,3,16,8,0,84,85,3,18,9,
        0,85,87,1,0,0,0,86,83,1,0,0,0,87,90,1,0,0,0,88,86,1,0,0,0,88,89,
        1,0,0,0,89,15,1,0,0,0,90,88,1,0,0,0,91,98,5,1,0,0,92,98,5,2,0,0,
        93,98,5,4,0,0,94,98,5,5,0,0,95,96,7,2,0,0,96,98,3,22,11,0,97,91,
        1,0,0,0,97,92,1,0,0,0,97,93,1,0,0,0,97,94,1,0,0,0,97,95,1,0,0,0,
        98,17,1,0,0,0,99,101,3,20,10,0,100,99,1,0,0,0,101,104,1,0,0,0,102,
        103,1,0,0,0,102,100,1,0,0,0,103,105,1,0,0,0,104,102,1,0,0,0,105,
        106,3,0,0,0,106,19,1,0,0,0,107,112,5,3,0,0,108,112,5,20,0,0,109,
        110,7,3,0,0,110,112,3,22,11,0,111,107,1,0,0,0,111,108,1,0,0,0,111,
        109,1,0,0,0,112,21,1,0,0,0,113,114,5,29,0,0,114,115,3,24,12,0,115,
        116,5,28,0,0,116,117,3,24,12,0,117,118,5,30,0,0,118,23,1,0,0,0,119,
        121,5,24,0,0,120,119,1,0,0,0,120,121,1,0,0,0,121,122,1,0,0,0,122,
        123,5,33,0,0,123,25,1,0,0,0,124,125,7,4,0,0,125,27,1,0,0,0,126,127,
        7,5,0,0,127,29,1,0,0,0,128,132,5,34,0,0,129,132,5,35,0,0,130,132,
        3,10,5,0,131,128,1,0,0,0,131,129,1,0,0,0,131,130,1,0,0,0,132,31,
        1,0,0,0,133,134,7,6,0,0,134,33,1,0,0,0,11,40,48,56,62,75,88,97,102,
        111,120,131
    ]

class stlParser ( Parser ):

    grammarFileName = "stl.g4"

    atn = ATNDeserializer().deserialize(serializedATN())

    decisionsToDFA = [ DFA(ds, i) for i, ds in enumerate(atn.decisionToState) ]

    sharedContextCache = PredictionContextCache()

    literalNames = [ "<INVALID>", "<INVALID>", "<INVALID>", "<INVALID>", 
                     "<INVALID>", "<INVALID>", "'<>'", "'[]'", "'>='", "'<='", 
                     "'>'", "'<'", "<INVALID>", "'!='", "<INVALID>", "<INVALID>", 
                     "'F'", "'G'", "'U'", "'R'", "'X'", "'('", "')'", "'+'", 
                     "'-'", "'*'", "'/'", "'%'", "','", "'['", "']'", "'{'", 
                     "'}'" ]

    symbolicNames = [ "<INVALID>", "AND", "OR", "NOT", "IMPLIES", "IFF", 
                      "DIAMOND", "BOX", "GE", "LE", "GT", "LT", "EQ", "NE", 
                      "TRUE", "FALSE", "EVENTUALLY", "ALWAYS", "UNTIL", 
                      "RELEASE", "NEXT", "OPEN", "CLOSE", "PLUS", "MINUS", 
                      "STAR", "SLASH", "PERCENT", "COMMA", "LBRACKET", "RBRACKET", 
                      "LBRACE", "RBRACE", "NUMBER", "NAME", "STRING", "SPACE", 
                      "STRAY", "GROUP" ]

    RULE_comparison = 0
    RULE_total = 1
    RULE_term = 2
    RULE_factor = 3
    RULE_operand = 4
    RULE_reserved = 5
    RULE_formula = 6
    RULE_level = 7
    RULE_connective = 8
    RULE_unary = 9
    RULE_prefix = 10
    RULE_interval = 11
    RULE_bound = 12
    RULE_relation = 13
    RULE_constant = 14
    RULE_name = 15
    RULE_letter = 16

    ruleNames =  [ "comparison", "total", "term", "factor", "operand", "reserved", 
                   "formula", "level", "connective", "unary", "prefix", 
                   "interval", "bound", "relation", "constant", "name", 
                   "letter" ]

    EOF = Token.EOF
    AND=1
    OR=2
    NOT=3
    IMPLIES=4
    IFF=5
    DIAMOND=6
    BOX=7
    GE=8
    LE=9
    GT=10
    LT=11
    EQ=12
    NE=13
    TRUE=14
    FALSE=15
    EVENTUALLY=16
    ALWAYS=17
    UNTIL=18
    RELEASE=19
    NEXT=20
    OPEN=21
    CLOSE=22
    PLUS=23
    MINUS=24
    STAR=25
    SLASH=26
    PERCENT=27
    COMMA=28
    LBRACKET=29
    RBRACKET=30
    LBRACE=31
    RBRACE=32
    NUMBER=33
    NAME=34
    STRING=35
    SPACE=36
    STRAY=37
    GROUP=38

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
            self.state = 34
            self.total()
            self.state = 40
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 16128) != 0):
                self.state = 35
                self.relation()
                self.state = 36
                self.total()
                self.state = 42
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
            self.state = 43
            self.term()
            self.state = 48
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==23 or _la==24:
                self.state = 44
                _la = self._input.LA(1)
                if not(_la==23 or _la==24):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 45
                self.term()
                self.state = 50
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
            self.state = 51
            self.factor()
            self.state = 56
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==25 or _la==26:
                self.state = 52
                _la = self._input.LA(1)
                if not(_la==25 or _la==26):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 53
                self.factor()
                self.state = 58
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
            self.state = 62
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==23 or _la==24:
                self.state = 59
                _la = self._input.LA(1)
                if not(_la==23 or _la==24):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 64
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 65
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


        def GROUP(self):
            return self.getToken(stlParser.GROUP, 0)

        def OPEN(self):
            return self.getToken(stlParser.OPEN, 0)

        def level(self):
            return self.getTypedRuleContext(stlParser.LevelContext,0)


        def CLOSE(self):
            return self.getToken(stlParser.CLOSE, 0)

        def getRuleIndex(self):
            return stlParser.RULE_operand




    def operand(self):

        localctx = stlParser.OperandContext(self, self._ctx, self.state)
        self.enterRule(localctx, 8, self.RULE_operand)
        try:
            self.state = 75
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [14, 15]:
                self.enterOuterAlt(localctx, 1)
                self.state = 67
                self.constant()
                pass
            elif token in [33]:
                self.enterOuterAlt(localctx, 2)
                self.state = 68
                self.match(stlParser.NUMBER)
                pass
            elif token in [16, 17, 18, 19, 20, 34, 35]:
                self.enterOuterAlt(localctx, 3)
                self.state = 69
                self.name()
                pass
            elif token in [38]:
                self.enterOuterAlt(localctx, 4)
                self.state = 70
                self.match(stlParser.GROUP)
                pass
            elif token in [21]:
                self.enterOuterAlt(localctx, 5)
                self.state = 71
                self.match(stlParser.OPEN)
                self.state = 72
                self.level()
                self.state = 73
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


    class ReservedContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def letter(self):
            return self.getTypedRuleContext(stlParser.LetterContext,0)


        def getRuleIndex(self):
            return stlParser.RULE_reserved




    def reserved(self):

        localctx = stlParser.ReservedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 10, self.RULE_reserved)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 77
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

        def level(self):
            return self.getTypedRuleContext(stlParser.LevelContext,0)


        def EOF(self):
            return self.getToken(stlParser.EOF, 0)

        def getRuleIndex(self):
            return stlParser.RULE_formula




    def formula(self):

        localctx = stlParser.FormulaContext(self, self._ctx, self.state)
        self.enterRule(localctx, 12, self.RULE_formula)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 79
            self.level()
            self.state = 80
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
        self.enterRule(localctx, 14, self.RULE_level)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 82
            self.unary()
            self.state = 88
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 786486) != 0):
                self.state = 83
                self.connective()
                self.state = 84
                self.unary()
                self.state = 90
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
        self.enterRule(localctx, 16, self.RULE_connective)
        self._la = 0 # Token type
        try:
            self.state = 97
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [1]:
                self.enterOuterAlt(localctx, 1)
                self.state = 91
                self.match(stlParser.AND)
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 2)
                self.state = 92
                self.match(stlParser.OR)
                pass
            elif token in [4]:
                self.enterOuterAlt(localctx, 3)
                self.state = 93
                self.match(stlParser.IMPLIES)
                pass
            elif token in [5]:
                self.enterOuterAlt(localctx, 4)
                self.state = 94
                self.match(stlParser.IFF)
                pass
            elif token in [18, 19]:
                self.enterOuterAlt(localctx, 5)
                self.state = 95
                _la = self._input.LA(1)
                if not(_la==18 or _la==19):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 96
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
        self.enterRule(localctx, 18, self.RULE_unary)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 102
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,7,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 99
                    self.prefix() 
                self.state = 104
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,7,self._ctx)

            self.state = 105
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
        self.enterRule(localctx, 20, self.RULE_prefix)
        self._la = 0 # Token type
        try:
            self.state = 111
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [3]:
                self.enterOuterAlt(localctx, 1)
                self.state = 107
                self.match(stlParser.NOT)
                pass
            elif token in [20]:
                self.enterOuterAlt(localctx, 2)
                self.state = 108
                self.match(stlParser.NEXT)
                pass
            elif token in [6, 7, 16, 17]:
                self.enterOuterAlt(localctx, 3)
                self.state = 109
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 196800) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 110
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
        self.enterRule(localctx, 22, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 113
            self.match(stlParser.LBRACKET)
            self.state = 114
            self.bound()
            self.state = 115
            self.match(stlParser.COMMA)
            self.state = 116
            self.bound()
            self.state = 117
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
        self.enterRule(localctx, 24, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 120
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==24:
                self.state = 119
                self.match(stlParser.MINUS)


            self.state = 122
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
        self.enterRule(localctx, 26, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 124
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 16128) != 0)):
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
        self.enterRule(localctx, 28, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 126
            _la = self._input.LA(1)
            if not(_la==14 or _la==15):
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
        self.enterRule(localctx, 30, self.RULE_name)
        try:
            self.state = 131
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [34]:
                self.enterOuterAlt(localctx, 1)
                self.state = 128
                self.match(stlParser.NAME)
                pass
            elif token in [35]:
                self.enterOuterAlt(localctx, 2)
                self.state = 129
                self.match(stlParser.STRING)
                pass
            elif token in [16, 17, 18, 19, 20]:
                self.enterOuterAlt(localctx, 3)
                self.state = 130
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
        self.enterRule(localctx, 32, self.RULE_letter)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 133
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 2031616) != 0)):
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





