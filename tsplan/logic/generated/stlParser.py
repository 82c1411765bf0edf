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
        4,1,38,155,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,1,0,1,0,1,0,1,0,5,0,41,8,
        0,10,0,12,0,44,9,0,1,1,1,1,1,1,5,1,49,8,1,10,1,12,1,52,9,1,1,2,1,
        2,1,2,5,2,57,8,2,10,2,12,2,60,9,2,1,3,5,3,63,8,3,10,3,12,3,66,9,
        3,1,3,1,3,1,4,1,4,1,4,1,4,3,4,74,8,4,1,5,1,5,1,6,1,6,1,6,5,6,81,
        8,6,10,6,12,6,84,9,6,1,6,1,6,1,7,1,7,1,7,1,7,5,7,92,8,7,10,7,12,
        7,95,9,7,1,8,1,8,1,8,1,8,1,8,1,8,3,8,103,8,8,1,9,5,9,106,8,9,10,
        9,12,9,109,9,9,1,9,1,9,1,10,1,10,1,10,1,10,3,10,117,8,10,1,11,1,
        11,1,11,1,11,1,11,5,11,124,8,11,10,11,12,11,127,9,11,1,11,1,11,3,
        11,131,8,11,1,12,1,12,1,12,1,12,1,12,1,12,1,13,3,13,140,8,13,1,13,
        1,13,1,14,1,14,1,15,1,15,1,16,1,16,1,16,3,16,151,8,16,1,17,1,17,
        1,17,1,107,0,18,0,2,4,6,8,10,12,14,16,18,20,22,24,26,28,30,32,34,
        0,7,1,0,23,24,1,0,25,26,1,0,18,19,2,0,6,7,16,17,1,0,8,13,1,0,14,
        15,1,0,16,20,157,0,36,1,0,0,0,2,45,1,0,0,0,4,53,1,0,0,0,6,64,1,0,
        0,0,8,73,1,0,0,0,10,75,1,0,0,0,12,77,1,0,0,0,14,87,1,0,0,0,16,102,
        1,0,0,0,18,107,1,0,0,0,20,116,1,0,0,0,22,130,1,0,0,0,24,132,1,0,
        0,0,26,139,1,0,0,0,28,143,1,0,0,0,30,145,1,0,0,0,32,150,1,0,0,0,
        34,152,1,0,0,0,36,42,3,2,1,0,37,38,3,28,14,0,38,39,3,2,1,0,39,41,
        1,0,0,0,40,37,1,0,0,0,41,44,1,0,0,0,42,40,1,0,0,0,42,43,1,0,0,0,
        43,1,1,0,0,0,44,42,1,0,0,0,45,50,3,4,2,0,46,47,7,0,0,0,47,49,3,4,
        2,0,48,46,1,0,0,0,49,52,1,0,0,0,50,48,1,0,0,0,50,51,1,0,0,0,51,3,
        1,0,0,0,52,50,1,0,0,0,53,58,3,6,3,0,54,55,7,1,0,0,55,57,3,6,3,0,
        56,54,1,0,0,0,57,60,1,0,0,0,58,56,1,0,0,0,58,59,1,0,0,0,59,5,1,0,
        0,0,60,58,1,0,0,0,61,63,7,0,0,0,62,61,1,0,0,0,63,66,1,0,0,0,64,62,
        1,0,0,0,64,65,1,0,0,0,65,67,1,0,0,0,66,64,1,0,0,0,67,68,3,8,4,0,
        68,7,1,0,0,0,69,74,3,30,15,0,70,74,5,33,0,0,71,74,3,32,16,0,72,74,
        3,22,11,0,73,69,1,0,0,0,73,70,1,0,0,0,73,71,1,0,0,0,73,72,1,0,0,
        0,74,9,1,0,0,0,75,76,3,34,17,0,76,11,1,0,0,0,77,82,3,14,7,0,78,79,
        5,28,0,0,79,81,3,14,7,0,80,78,1,0,0,0,81,84,1,0,0,0,82,80,1,0,0,
        0,82,83,1,0,0,0,83,85,1,0,0,0,84,82,1,0,0,0,85,86,5,0,0,1,86,13,
        1,0,0,0,87,93,3,18,9,0,88,89,3,16,8,0,89,90,3,18,9,0,90,92,1,0,0,
        0,91,88,1,0,0,0,92,95,1,0,0,0,93,91,1,0,0,0,93,94,1,0,0,0,94,15,
        1,0,0,0,95,93,1,0,0,0,96,103,5,1,0,0,97,103,5,2,0,0,98,103,5,4,0,
        0,99,103,5,5,0,0,100,101,7,2,0,0,101,103,3,24,12,0,102,96,1,0,0,
        0,102,97,1,0,0,0,102,98,1,0,0,0,102,99,1,0,0,0,102,100,1,0,0,0,103,
        17,1,0,0,0,104,106,3,20,10,0,105,104,1,0,0,0,106,109,1,0,0,0,107,
        108,1,0,0,0,107,105,1,0,0,0,108,110,1,0,0,0,109,107,1,0,0,0,110,
        111,3,0,0,0,111,19,1,0,0,0,112,117,5,3,0,0,113,117,5,20,0,0,114,
        115,7,3,0,0,115,117,3,24,12,0,116,112,1,0,0,0,116,113,1,0,0,0,116,
        114,1,0,0,0,117,21,1,0,0,0,118,131,5,38,0,0,119,120,5,21,0,0,120,
        125,3,14,7,0,121,122,5,28,0,0,122,124,3,14,7,0,123,121,1,0,0,0,124,
        127,1,0,0,0,125,123,1,0,0,0,125,126,1,0,0,0,126,128,1,0,0,0,127,
        125,1,0,0,0,128,129,5,22,0,0,129,131,1,0,0,0,130,118,1,0,0,0,130,
        119,1,0,0,0,131,23,1,0,0,0,132,133,5,29,0,0,133,134,3,26,13,0,134,
        135,5,28,0,0,135,136,3,26,13,0,136,137,5,30,0,0,137,25,1,0,0,0,138,
        140,5,24,0,0,139,138,1,0,0,0,139,140,1,0,0,0,140,141,1,0,0,0,141,
        142,5,33,0,0,142,27,1,0,0,0,143,144,7,4,0,0,144,29,1,0,0,0,145,146,
        7,5,0,0,146,31,1,0,0,0,147,151,5,34,0,0,148,151,5,35,0,0,149,151,
        3,10,5,0,150,147,1,0,0,0,150,148,1,0,0,0,150,149,1,0,0,0,151,33,
        1,0,0,0,152,153,7,6,0,0,153,35,1,0,0,0,14,42,50,58,64,73,82,93,102,
        107,116,125,130,139,150
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
    RULE_parts = 11
    RULE_interval = 12
    RULE_bound = 13
    RULE_relation = 14
    RULE_constant = 15
    RULE_name = 16
    RULE_letter = 17

    ruleNames =  [ "comparison", "total", "term", "factor", "operand", "reserved", 
                   "formula", "level", "connective", "unary", "prefix", 
                   "parts", "interval", "bound", "relation", "constant", 
                   "name", "letter" ]

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
            self.state = 36
            self.total()
            self.state = 42
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 16128) != 0):
                self.state = 37
                self.relation()
                self.state = 38
                self.total()
                self.state = 44
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
            self.state = 45
            self.term()
            self.state = 50
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==23 or _la==24:
                self.state = 46
                _la = self._input.LA(1)
                if not(_la==23 or _la==24):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 47
                self.term()
                self.state = 52
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
            self.state = 53
            self.factor()
            self.state = 58
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==25 or _la==26:
                self.state = 54
                _la = self._input.LA(1)
                if not(_la==25 or _la==26):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 55
                self.factor()
                self.state = 60
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
            self.state = 64
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==23 or _la==24:
                self.state = 61
                _la = self._input.LA(1)
                if not(_la==23 or _la==24):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 66
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 67
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


        def parts(self):
            return self.getTypedRuleContext(stlParser.PartsContext,0)


        def getRuleIndex(self):
            return stlParser.RULE_operand




    def operand(self):

        localctx = stlParser.OperandContext(self, self._ctx, self.state)
        self.enterRule(localctx, 8, self.RULE_operand)
        try:
            self.state = 73
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [14, 15]:
                self.enterOuterAlt(localctx, 1)
                self.state = 69
                self.constant()
                pass
            elif token in [33]:
                self.enterOuterAlt(localctx, 2)
                self.state = 70
                self.match(stlParser.NUMBER)
                pass
            elif token in [16, 17, 18, 19, 20, 34, 35]:
                self.enterOuterAlt(localctx, 3)
                self.state = 71
                self.name()
                pass
            elif token in [21, 38]:
                self.enterOuterAlt(localctx, 4)
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
            self.state = 75
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
        self.enterRule(localctx, 12, self.RULE_formula)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 77
            self.level()
            self.state = 82
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==28:
                self.state = 78
                self.match(stlParser.COMMA)
                self.state = 79
                self.level()
                self.state = 84
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 85
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
            self.state = 87
            self.unary()
            self.state = 93
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 786486) != 0):
                self.state = 88
                self.connective()
                self.state = 89
                self.unary()
                self.state = 95
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
            self.state = 102
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [1]:
                self.enterOuterAlt(localctx, 1)
                self.state = 96
                self.match(stlParser.AND)
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 2)
                self.state = 97
                self.match(stlParser.OR)
                pass
            elif token in [4]:
                self.enterOuterAlt(localctx, 3)
                self.state = 98
                self.match(stlParser.IMPLIES)
                pass
            elif token in [5]:
                self.enterOuterAlt(localctx, 4)
                self.state = 99
                self.match(stlParser.IFF)
                pass
            elif token in [18, 19]:
                self.enterOuterAlt(localctx, 5)
                self.state = 100
                _la = self._input.LA(1)
                if not(_la==18 or _la==19):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 101
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
            self.state = 107
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,8,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 104
                    self.prefix() 
                self.state = 109
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,8,self._ctx)

            self.state = 110
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
            self.state = 116
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [3]:
                self.enterOuterAlt(localctx, 1)
                self.state = 112
                self.match(stlParser.NOT)
                pass
            elif token in [20]:
                self.enterOuterAlt(localctx, 2)
                self.state = 113
                self.match(stlParser.NEXT)
                pass
            elif token in [6, 7, 16, 17]:
                self.enterOuterAlt(localctx, 3)
                self.state = 114
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 196800) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 115
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
        self.enterRule(localctx, 22, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 130
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [38]:
                self.enterOuterAlt(localctx, 1)
                self.state = 118
                self.match(stlParser.GROUP)
                pass
            elif token in [21]:
                self.enterOuterAlt(localctx, 2)
                self.state = 119
                self.match(stlParser.OPEN)
                self.state = 120
                self.level()
                self.state = 125
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==28:
                    self.state = 121
                    self.match(stlParser.COMMA)
                    self.state = 122
                    self.level()
                    self.state = 127
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 128
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
        self.enterRule(localctx, 24, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 132
            self.match(stlParser.LBRACKET)
            self.state = 133
            self.bound()
            self.state = 134
            self.match(stlParser.COMMA)
            self.state = 135
            self.bound()
            self.state = 136
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
        self.enterRule(localctx, 26, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 139
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==24:
                self.state = 138
                self.match(stlParser.MINUS)


            self.state = 141
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
        self.enterRule(localctx, 28, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 143
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
        self.enterRule(localctx, 30, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 145
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
        self.enterRule(localctx, 32, self.RULE_name)
        try:
            self.state = 150
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [34]:
                self.enterOuterAlt(localctx, 1)
                self.state = 147
                self.match(stlParser.NAME)
                pass
            elif token in [35]:
                self.enterOuterAlt(localctx, 2)
                self.state = 148
                self.match(stlParser.STRING)
                pass
            elif token in [16, 17, 18, 19, 20]:
                self.enterOuterAlt(localctx, 3)
                self.state = 149
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
        self.enterRule(localctx, 34, self.RULE_letter)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 152
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





