# Generated from catl.g4 by ANTLR 4.13.1
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
        4,1,45,213,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,2,19,7,19,2,20,
        7,20,2,21,7,21,2,22,7,22,1,0,1,0,1,0,1,0,3,0,51,8,0,1,1,1,1,1,1,
        1,1,1,1,1,1,1,1,1,1,1,1,3,1,62,8,1,1,1,1,1,1,2,1,2,1,2,1,2,1,2,1,
        2,1,2,1,3,1,3,1,3,1,3,5,3,77,8,3,10,3,12,3,80,9,3,3,3,82,8,3,1,3,
        1,3,1,4,1,4,1,4,1,4,1,4,1,4,1,5,1,5,1,5,1,5,1,5,1,5,3,5,98,8,5,1,
        6,1,6,1,6,1,6,5,6,104,8,6,10,6,12,6,107,9,6,1,7,1,7,1,7,1,7,3,7,
        113,8,7,1,8,3,8,116,8,8,1,8,1,8,3,8,120,8,8,1,9,1,9,1,9,1,9,1,9,
        3,9,127,8,9,1,9,1,9,1,10,1,10,1,10,5,10,134,8,10,10,10,12,10,137,
        9,10,1,10,1,10,1,11,1,11,1,11,1,11,5,11,145,8,11,10,11,12,11,148,
        9,11,1,12,1,12,1,12,1,12,1,12,1,12,3,12,156,8,12,1,13,5,13,159,8,
        13,10,13,12,13,162,9,13,1,13,1,13,3,13,166,8,13,1,14,1,14,1,14,1,
        14,3,14,172,8,14,1,15,1,15,1,15,1,16,1,16,1,16,1,16,1,16,5,16,182,
        8,16,10,16,12,16,185,9,16,1,16,1,16,3,16,189,8,16,1,17,1,17,1,17,
        1,17,1,17,1,17,1,18,3,18,198,8,18,1,18,1,18,1,19,1,19,1,20,1,20,
        1,21,1,21,1,21,3,21,209,8,21,1,22,1,22,1,22,1,160,0,23,0,2,4,6,8,
        10,12,14,16,18,20,22,24,26,28,30,32,34,36,38,40,42,44,0,7,1,0,3,
        5,1,0,23,24,3,0,11,12,21,22,26,27,1,0,26,27,1,0,13,18,1,0,19,20,
        1,0,21,27,222,0,50,1,0,0,0,2,52,1,0,0,0,4,65,1,0,0,0,6,72,1,0,0,
        0,8,85,1,0,0,0,10,97,1,0,0,0,12,99,1,0,0,0,14,112,1,0,0,0,16,115,
        1,0,0,0,18,121,1,0,0,0,20,130,1,0,0,0,22,140,1,0,0,0,24,155,1,0,
        0,0,26,160,1,0,0,0,28,171,1,0,0,0,30,173,1,0,0,0,32,188,1,0,0,0,
        34,190,1,0,0,0,36,197,1,0,0,0,38,201,1,0,0,0,40,203,1,0,0,0,42,208,
        1,0,0,0,44,210,1,0,0,0,46,51,3,18,9,0,47,51,3,2,1,0,48,51,3,4,2,
        0,49,51,3,42,21,0,50,46,1,0,0,0,50,47,1,0,0,0,50,48,1,0,0,0,50,49,
        1,0,0,0,51,1,1,0,0,0,52,53,5,1,0,0,53,54,5,28,0,0,54,55,3,16,8,0,
        55,56,5,35,0,0,56,57,3,42,21,0,57,58,5,35,0,0,58,61,3,6,3,0,59,60,
        5,35,0,0,60,62,3,6,3,0,61,59,1,0,0,0,61,62,1,0,0,0,62,63,1,0,0,0,
        63,64,5,29,0,0,64,3,1,0,0,0,65,66,5,2,0,0,66,67,5,28,0,0,67,68,3,
        42,21,0,68,69,5,35,0,0,69,70,3,6,3,0,70,71,5,29,0,0,71,5,1,0,0,0,
        72,81,5,38,0,0,73,78,3,8,4,0,74,75,5,35,0,0,75,77,3,8,4,0,76,74,
        1,0,0,0,77,80,1,0,0,0,78,76,1,0,0,0,78,79,1,0,0,0,79,82,1,0,0,0,
        80,78,1,0,0,0,81,73,1,0,0,0,81,82,1,0,0,0,82,83,1,0,0,0,83,84,5,
        39,0,0,84,7,1,0,0,0,85,86,5,28,0,0,86,87,3,42,21,0,87,88,5,35,0,
        0,88,89,3,16,8,0,89,90,5,29,0,0,90,9,1,0,0,0,91,98,3,44,22,0,92,
        98,5,3,0,0,93,98,5,4,0,0,94,98,5,5,0,0,95,98,5,1,0,0,96,98,5,2,0,
        0,97,91,1,0,0,0,97,92,1,0,0,0,97,93,1,0,0,0,97,94,1,0,0,0,97,95,
        1,0,0,0,97,96,1,0,0,0,98,11,1,0,0,0,99,105,3,14,7,0,100,101,3,38,
        19,0,101,102,3,14,7,0,102,104,1,0,0,0,103,100,1,0,0,0,104,107,1,
        0,0,0,105,103,1,0,0,0,105,106,1,0,0,0,106,13,1,0,0,0,107,105,1,0,
        0,0,108,113,3,40,20,0,109,113,3,16,8,0,110,113,3,0,0,0,111,113,3,
        32,16,0,112,108,1,0,0,0,112,109,1,0,0,0,112,110,1,0,0,0,112,111,
        1,0,0,0,113,15,1,0,0,0,114,116,5,31,0,0,115,114,1,0,0,0,115,116,
        1,0,0,0,116,117,1,0,0,0,117,119,5,40,0,0,118,120,5,34,0,0,119,118,
        1,0,0,0,119,120,1,0,0,0,120,17,1,0,0,0,121,122,7,0,0,0,122,123,5,
        28,0,0,123,126,3,42,21,0,124,125,5,35,0,0,125,127,3,42,21,0,126,
        124,1,0,0,0,126,127,1,0,0,0,127,128,1,0,0,0,128,129,5,29,0,0,129,
        19,1,0,0,0,130,135,3,22,11,0,131,132,5,35,0,0,132,134,3,22,11,0,
        133,131,1,0,0,0,134,137,1,0,0,0,135,133,1,0,0,0,135,136,1,0,0,0,
        136,138,1,0,0,0,137,135,1,0,0,0,138,139,5,0,0,1,139,21,1,0,0,0,140,
        146,3,26,13,0,141,142,3,24,12,0,142,143,3,26,13,0,143,145,1,0,0,
        0,144,141,1,0,0,0,145,148,1,0,0,0,146,144,1,0,0,0,146,147,1,0,0,
        0,147,23,1,0,0,0,148,146,1,0,0,0,149,156,5,6,0,0,150,156,5,7,0,0,
        151,156,5,9,0,0,152,156,5,10,0,0,153,154,7,1,0,0,154,156,3,34,17,
        0,155,149,1,0,0,0,155,150,1,0,0,0,155,151,1,0,0,0,155,152,1,0,0,
        0,155,153,1,0,0,0,156,25,1,0,0,0,157,159,3,28,14,0,158,157,1,0,0,
        0,159,162,1,0,0,0,160,161,1,0,0,0,160,158,1,0,0,0,161,165,1,0,0,
        0,162,160,1,0,0,0,163,166,3,12,6,0,164,166,3,30,15,0,165,163,1,0,
        0,0,165,164,1,0,0,0,166,27,1,0,0,0,167,172,5,8,0,0,168,172,5,25,
        0,0,169,170,7,2,0,0,170,172,3,34,17,0,171,167,1,0,0,0,171,168,1,
        0,0,0,171,169,1,0,0,0,172,29,1,0,0,0,173,174,7,3,0,0,174,175,3,32,
        16,0,175,31,1,0,0,0,176,189,5,45,0,0,177,178,5,28,0,0,178,183,3,
        22,11,0,179,180,5,35,0,0,180,182,3,22,11,0,181,179,1,0,0,0,182,185,
        1,0,0,0,183,181,1,0,0,0,183,184,1,0,0,0,184,186,1,0,0,0,185,183,
        1,0,0,0,186,187,5,29,0,0,187,189,1,0,0,0,188,176,1,0,0,0,188,177,
        1,0,0,0,189,33,1,0,0,0,190,191,5,36,0,0,191,192,3,36,18,0,192,193,
        5,35,0,0,193,194,3,36,18,0,194,195,5,37,0,0,195,35,1,0,0,0,196,198,
        5,31,0,0,197,196,1,0,0,0,197,198,1,0,0,0,198,199,1,0,0,0,199,200,
        5,40,0,0,200,37,1,0,0,0,201,202,7,4,0,0,202,39,1,0,0,0,203,204,7,
        5,0,0,204,41,1,0,0,0,205,209,5,41,0,0,206,209,5,42,0,0,207,209,3,
        10,5,0,208,205,1,0,0,0,208,206,1,0,0,0,208,207,1,0,0,0,209,43,1,
        0,0,0,210,211,7,6,0,0,211,45,1,0,0,0,20,50,61,78,81,97,105,112,115,
        119,126,135,146,155,160,165,171,183,188,197,208
    ]

class catlParser ( Parser ):

    grammarFileName = "catl.g4"

    atn = ATNDeserializer().deserialize(serializedATN())

    decisionsToDFA = [ DFA(ds, i) for i, ds in enumerate(atn.decisionToState) ]

    sharedContextCache = PredictionContextCache()

    literalNames = [ "<INVALID>", "'T'", "'L'", "'sum'", "'min'", "'max'", 
                     "<INVALID>", "<INVALID>", "<INVALID>", "<INVALID>", 
                     "<INVALID>", "'<>'", "'[]'", "'>='", "'<='", "'>'", 
                     "'<'", "<INVALID>", "'!='", "<INVALID>", "<INVALID>", 
                     "'F'", "'G'", "'U'", "'R'", "'X'", "'one'", "'all'", 
                     "'('", "')'", "'+'", "'-'", "'*'", "'/'", "'%'", "','", 
                     "'['", "']'", "'{'", "'}'" ]

    symbolicNames = [ "<INVALID>", "TASK", "LIMIT", "SUM", "MIN", "MAX", 
                      "AND", "OR", "NOT", "IMPLIES", "IFF", "DIAMOND", "BOX", 
                      "GE", "LE", "GT", "LT", "EQ", "NE", "TRUE", "FALSE", 
                      "EVENTUALLY", "ALWAYS", "UNTIL", "RELEASE", "NEXT", 
                      "ONE", "ALL", "OPEN", "CLOSE", "PLUS", "MINUS", "STAR", 
                      "SLASH", "PERCENT", "COMMA", "LBRACKET", "RBRACKET", 
                      "LBRACE", "RBRACE", "NUMBER", "NAME", "STRING", "SPACE", 
                      "STRAY", "GROUP" ]

    RULE_atom = 0
    RULE_task = 1
    RULE_limit = 2
    RULE_pairs = 3
    RULE_pair = 4
    RULE_reserved = 5
    RULE_comparison = 6
    RULE_operand = 7
    RULE_number = 8
    RULE_count = 9
    RULE_formula = 10
    RULE_level = 11
    RULE_connective = 12
    RULE_unary = 13
    RULE_prefix = 14
    RULE_joined = 15
    RULE_parts = 16
    RULE_interval = 17
    RULE_bound = 18
    RULE_relation = 19
    RULE_constant = 20
    RULE_name = 21
    RULE_word = 22

    ruleNames =  [ "atom", "task", "limit", "pairs", "pair", "reserved", 
                   "comparison", "operand", "number", "count", "formula", 
                   "level", "connective", "unary", "prefix", "joined", "parts", 
                   "interval", "bound", "relation", "constant", "name", 
                   "word" ]

    EOF = Token.EOF
    TASK=1
    LIMIT=2
    SUM=3
    MIN=4
    MAX=5
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




    class AtomContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def count(self):
            return self.getTypedRuleContext(catlParser.CountContext,0)


        def task(self):
            return self.getTypedRuleContext(catlParser.TaskContext,0)


        def limit(self):
            return self.getTypedRuleContext(catlParser.LimitContext,0)


        def name(self):
            return self.getTypedRuleContext(catlParser.NameContext,0)


        def getRuleIndex(self):
            return catlParser.RULE_atom




    def atom(self):

        localctx = catlParser.AtomContext(self, self._ctx, self.state)
        self.enterRule(localctx, 0, self.RULE_atom)
        try:
            self.state = 50
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,0,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 46
                self.count()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 47
                self.task()
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 48
                self.limit()
                pass

            elif la_ == 4:
                self.enterOuterAlt(localctx, 4)
                self.state = 49
                self.name()
                pass


        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class TaskContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def TASK(self):
            return self.getToken(catlParser.TASK, 0)

        def OPEN(self):
            return self.getToken(catlParser.OPEN, 0)

        def number(self):
            return self.getTypedRuleContext(catlParser.NumberContext,0)


        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(catlParser.COMMA)
            else:
                return self.getToken(catlParser.COMMA, i)

        def name(self):
            return self.getTypedRuleContext(catlParser.NameContext,0)


        def pairs(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.PairsContext)
            else:
                return self.getTypedRuleContext(catlParser.PairsContext,i)


        def CLOSE(self):
            return self.getToken(catlParser.CLOSE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_task




    def task(self):

        localctx = catlParser.TaskContext(self, self._ctx, self.state)
        self.enterRule(localctx, 2, self.RULE_task)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 52
            self.match(catlParser.TASK)
            self.state = 53
            self.match(catlParser.OPEN)
            self.state = 54
            self.number()
            self.state = 55
            self.match(catlParser.COMMA)
            self.state = 56
            self.name()
            self.state = 57
            self.match(catlParser.COMMA)
            self.state = 58
            self.pairs()
            self.state = 61
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==35:
                self.state = 59
                self.match(catlParser.COMMA)
                self.state = 60
                self.pairs()


            self.state = 63
            self.match(catlParser.CLOSE)
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class LimitContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def LIMIT(self):
            return self.getToken(catlParser.LIMIT, 0)

        def OPEN(self):
            return self.getToken(catlParser.OPEN, 0)

        def name(self):
            return self.getTypedRuleContext(catlParser.NameContext,0)


        def COMMA(self):
            return self.getToken(catlParser.COMMA, 0)

        def pairs(self):
            return self.getTypedRuleContext(catlParser.PairsContext,0)


        def CLOSE(self):
            return self.getToken(catlParser.CLOSE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_limit




    def limit(self):

        localctx = catlParser.LimitContext(self, self._ctx, self.state)
        self.enterRule(localctx, 4, self.RULE_limit)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 65
            self.match(catlParser.LIMIT)
            self.state = 66
            self.match(catlParser.OPEN)
            self.state = 67
            self.name()
            self.state = 68
            self.match(catlParser.COMMA)
            self.state = 69
            self.pairs()
            self.state = 70
            self.match(catlParser.CLOSE)
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class PairsContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def LBRACE(self):
            return self.getToken(catlParser.LBRACE, 0)

        def RBRACE(self):
            return self.getToken(catlParser.RBRACE, 0)

        def pair(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.PairContext)
            else:
                return self.getTypedRuleContext(catlParser.PairContext,i)


        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(catlParser.COMMA)
            else:
                return self.getToken(catlParser.COMMA, i)

        def getRuleIndex(self):
            return catlParser.RULE_pairs




    def pairs(self):

        localctx = catlParser.PairsContext(self, self._ctx, self.state)
        self.enterRule(localctx, 6, self.RULE_pairs)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 72
            self.match(catlParser.LBRACE)
            self.state = 81
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==28:
                self.state = 73
                self.pair()
                self.state = 78
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==35:
                    self.state = 74
                    self.match(catlParser.COMMA)
                    self.state = 75
                    self.pair()
                    self.state = 80
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)



            self.state = 83
            self.match(catlParser.RBRACE)
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class PairContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def OPEN(self):
            return self.getToken(catlParser.OPEN, 0)

        def name(self):
            return self.getTypedRuleContext(catlParser.NameContext,0)


        def COMMA(self):
            return self.getToken(catlParser.COMMA, 0)

        def number(self):
            return self.getTypedRuleContext(catlParser.NumberContext,0)


        def CLOSE(self):
            return self.getToken(catlParser.CLOSE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_pair




    def pair(self):

        localctx = catlParser.PairContext(self, self._ctx, self.state)
        self.enterRule(localctx, 8, self.RULE_pair)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 85
            self.match(catlParser.OPEN)
            self.state = 86
            self.name()
            self.state = 87
            self.match(catlParser.COMMA)
            self.state = 88
            self.number()
            self.state = 89
            self.match(catlParser.CLOSE)
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
            return self.getTypedRuleContext(catlParser.WordContext,0)


        def SUM(self):
            return self.getToken(catlParser.SUM, 0)

        def MIN(self):
            return self.getToken(catlParser.MIN, 0)

        def MAX(self):
            return self.getToken(catlParser.MAX, 0)

        def TASK(self):
            return self.getToken(catlParser.TASK, 0)

        def LIMIT(self):
            return self.getToken(catlParser.LIMIT, 0)

        def getRuleIndex(self):
            return catlParser.RULE_reserved




    def reserved(self):

        localctx = catlParser.ReservedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 10, self.RULE_reserved)
        try:
            self.state = 97
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [21, 22, 23, 24, 25, 26, 27]:
                self.enterOuterAlt(localctx, 1)
                self.state = 91
                self.word()
                pass
            elif token in [3]:
                self.enterOuterAlt(localctx, 2)
                self.state = 92
                self.match(catlParser.SUM)
                pass
            elif token in [4]:
                self.enterOuterAlt(localctx, 3)
                self.state = 93
                self.match(catlParser.MIN)
                pass
            elif token in [5]:
                self.enterOuterAlt(localctx, 4)
                self.state = 94
                self.match(catlParser.MAX)
                pass
            elif token in [1]:
                self.enterOuterAlt(localctx, 5)
                self.state = 95
                self.match(catlParser.TASK)
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 6)
                self.state = 96
                self.match(catlParser.LIMIT)
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


    class ComparisonContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def operand(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.OperandContext)
            else:
                return self.getTypedRuleContext(catlParser.OperandContext,i)


        def relation(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.RelationContext)
            else:
                return self.getTypedRuleContext(catlParser.RelationContext,i)


        def getRuleIndex(self):
            return catlParser.RULE_comparison




    def comparison(self):

        localctx = catlParser.ComparisonContext(self, self._ctx, self.state)
        self.enterRule(localctx, 12, self.RULE_comparison)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 99
            self.operand()
            self.state = 105
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 516096) != 0):
                self.state = 100
                self.relation()
                self.state = 101
                self.operand()
                self.state = 107
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
            return self.getTypedRuleContext(catlParser.ConstantContext,0)


        def number(self):
            return self.getTypedRuleContext(catlParser.NumberContext,0)


        def atom(self):
            return self.getTypedRuleContext(catlParser.AtomContext,0)


        def parts(self):
            return self.getTypedRuleContext(catlParser.PartsContext,0)


        def getRuleIndex(self):
            return catlParser.RULE_operand




    def operand(self):

        localctx = catlParser.OperandContext(self, self._ctx, self.state)
        self.enterRule(localctx, 14, self.RULE_operand)
        try:
            self.state = 112
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [19, 20]:
                self.enterOuterAlt(localctx, 1)
                self.state = 108
                self.constant()
                pass
            elif token in [31, 40]:
                self.enterOuterAlt(localctx, 2)
                self.state = 109
                self.number()
                pass
            elif token in [1, 2, 3, 4, 5, 21, 22, 23, 24, 25, 26, 27, 41, 42]:
                self.enterOuterAlt(localctx, 3)
                self.state = 110
                self.atom()
                pass
            elif token in [28, 45]:
                self.enterOuterAlt(localctx, 4)
                self.state = 111
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
            return self.getToken(catlParser.NUMBER, 0)

        def MINUS(self):
            return self.getToken(catlParser.MINUS, 0)

        def PERCENT(self):
            return self.getToken(catlParser.PERCENT, 0)

        def getRuleIndex(self):
            return catlParser.RULE_number




    def number(self):

        localctx = catlParser.NumberContext(self, self._ctx, self.state)
        self.enterRule(localctx, 16, self.RULE_number)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 115
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==31:
                self.state = 114
                self.match(catlParser.MINUS)


            self.state = 117
            self.match(catlParser.NUMBER)
            self.state = 119
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==34:
                self.state = 118
                self.match(catlParser.PERCENT)


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
            return self.getToken(catlParser.OPEN, 0)

        def name(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.NameContext)
            else:
                return self.getTypedRuleContext(catlParser.NameContext,i)


        def CLOSE(self):
            return self.getToken(catlParser.CLOSE, 0)

        def SUM(self):
            return self.getToken(catlParser.SUM, 0)

        def MIN(self):
            return self.getToken(catlParser.MIN, 0)

        def MAX(self):
            return self.getToken(catlParser.MAX, 0)

        def COMMA(self):
            return self.getToken(catlParser.COMMA, 0)

        def getRuleIndex(self):
            return catlParser.RULE_count




    def count(self):

        localctx = catlParser.CountContext(self, self._ctx, self.state)
        self.enterRule(localctx, 18, self.RULE_count)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 121
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 56) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 122
            self.match(catlParser.OPEN)
            self.state = 123
            self.name()
            self.state = 126
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==35:
                self.state = 124
                self.match(catlParser.COMMA)
                self.state = 125
                self.name()


            self.state = 128
            self.match(catlParser.CLOSE)
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
                return self.getTypedRuleContexts(catlParser.LevelContext)
            else:
                return self.getTypedRuleContext(catlParser.LevelContext,i)


        def EOF(self):
            return self.getToken(catlParser.EOF, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(catlParser.COMMA)
            else:
                return self.getToken(catlParser.COMMA, i)

        def getRuleIndex(self):
            return catlParser.RULE_formula




    def formula(self):

        localctx = catlParser.FormulaContext(self, self._ctx, self.state)
        self.enterRule(localctx, 20, self.RULE_formula)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 130
            self.level()
            self.state = 135
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==35:
                self.state = 131
                self.match(catlParser.COMMA)
                self.state = 132
                self.level()
                self.state = 137
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 138
            self.match(catlParser.EOF)
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
                return self.getTypedRuleContexts(catlParser.UnaryContext)
            else:
                return self.getTypedRuleContext(catlParser.UnaryContext,i)


        def connective(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.ConnectiveContext)
            else:
                return self.getTypedRuleContext(catlParser.ConnectiveContext,i)


        def getRuleIndex(self):
            return catlParser.RULE_level




    def level(self):

        localctx = catlParser.LevelContext(self, self._ctx, self.state)
        self.enterRule(localctx, 22, self.RULE_level)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 140
            self.unary()
            self.state = 146
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 25167552) != 0):
                self.state = 141
                self.connective()
                self.state = 142
                self.unary()
                self.state = 148
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
            return self.getToken(catlParser.AND, 0)

        def OR(self):
            return self.getToken(catlParser.OR, 0)

        def IMPLIES(self):
            return self.getToken(catlParser.IMPLIES, 0)

        def IFF(self):
            return self.getToken(catlParser.IFF, 0)

        def interval(self):
            return self.getTypedRuleContext(catlParser.IntervalContext,0)


        def UNTIL(self):
            return self.getToken(catlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(catlParser.RELEASE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_connective




    def connective(self):

        localctx = catlParser.ConnectiveContext(self, self._ctx, self.state)
        self.enterRule(localctx, 24, self.RULE_connective)
        self._la = 0 # Token type
        try:
            self.state = 155
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [6]:
                self.enterOuterAlt(localctx, 1)
                self.state = 149
                self.match(catlParser.AND)
                pass
            elif token in [7]:
                self.enterOuterAlt(localctx, 2)
                self.state = 150
                self.match(catlParser.OR)
                pass
            elif token in [9]:
                self.enterOuterAlt(localctx, 3)
                self.state = 151
                self.match(catlParser.IMPLIES)
                pass
            elif token in [10]:
                self.enterOuterAlt(localctx, 4)
                self.state = 152
                self.match(catlParser.IFF)
                pass
            elif token in [23, 24]:
                self.enterOuterAlt(localctx, 5)
                self.state = 153
                _la = self._input.LA(1)
                if not(_la==23 or _la==24):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 154
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
            return self.getTypedRuleContext(catlParser.ComparisonContext,0)


        def joined(self):
            return self.getTypedRuleContext(catlParser.JoinedContext,0)


        def prefix(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.PrefixContext)
            else:
                return self.getTypedRuleContext(catlParser.PrefixContext,i)


        def getRuleIndex(self):
            return catlParser.RULE_unary




    def unary(self):

        localctx = catlParser.UnaryContext(self, self._ctx, self.state)
        self.enterRule(localctx, 26, self.RULE_unary)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 160
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,13,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 157
                    self.prefix() 
                self.state = 162
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,13,self._ctx)

            self.state = 165
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,14,self._ctx)
            if la_ == 1:
                self.state = 163
                self.comparison()
                pass

            elif la_ == 2:
                self.state = 164
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
            return self.getToken(catlParser.NOT, 0)

        def NEXT(self):
            return self.getToken(catlParser.NEXT, 0)

        def interval(self):
            return self.getTypedRuleContext(catlParser.IntervalContext,0)


        def EVENTUALLY(self):
            return self.getToken(catlParser.EVENTUALLY, 0)

        def DIAMOND(self):
            return self.getToken(catlParser.DIAMOND, 0)

        def ALWAYS(self):
            return self.getToken(catlParser.ALWAYS, 0)

        def BOX(self):
            return self.getToken(catlParser.BOX, 0)

        def ONE(self):
            return self.getToken(catlParser.ONE, 0)

        def ALL(self):
            return self.getToken(catlParser.ALL, 0)

        def getRuleIndex(self):
            return catlParser.RULE_prefix




    def prefix(self):

        localctx = catlParser.PrefixContext(self, self._ctx, self.state)
        self.enterRule(localctx, 28, self.RULE_prefix)
        self._la = 0 # Token type
        try:
            self.state = 171
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [8]:
                self.enterOuterAlt(localctx, 1)
                self.state = 167
                self.match(catlParser.NOT)
                pass
            elif token in [25]:
                self.enterOuterAlt(localctx, 2)
                self.state = 168
                self.match(catlParser.NEXT)
                pass
            elif token in [11, 12, 21, 22, 26, 27]:
                self.enterOuterAlt(localctx, 3)
                self.state = 169
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 207624192) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 170
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
            return self.getTypedRuleContext(catlParser.PartsContext,0)


        def ONE(self):
            return self.getToken(catlParser.ONE, 0)

        def ALL(self):
            return self.getToken(catlParser.ALL, 0)

        def getRuleIndex(self):
            return catlParser.RULE_joined




    def joined(self):

        localctx = catlParser.JoinedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 30, self.RULE_joined)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 173
            _la = self._input.LA(1)
            if not(_la==26 or _la==27):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 174
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
            return self.getToken(catlParser.GROUP, 0)

        def OPEN(self):
            return self.getToken(catlParser.OPEN, 0)

        def level(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.LevelContext)
            else:
                return self.getTypedRuleContext(catlParser.LevelContext,i)


        def CLOSE(self):
            return self.getToken(catlParser.CLOSE, 0)

        def COMMA(self, i:int=None):
            if i is None:
                return self.getTokens(catlParser.COMMA)
            else:
                return self.getToken(catlParser.COMMA, i)

        def getRuleIndex(self):
            return catlParser.RULE_parts




    def parts(self):

        localctx = catlParser.PartsContext(self, self._ctx, self.state)
        self.enterRule(localctx, 32, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 188
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [45]:
                self.enterOuterAlt(localctx, 1)
                self.state = 176
                self.match(catlParser.GROUP)
                pass
            elif token in [28]:
                self.enterOuterAlt(localctx, 2)
                self.state = 177
                self.match(catlParser.OPEN)
                self.state = 178
                self.level()
                self.state = 183
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==35:
                    self.state = 179
                    self.match(catlParser.COMMA)
                    self.state = 180
                    self.level()
                    self.state = 185
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 186
                self.match(catlParser.CLOSE)
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
            return self.getToken(catlParser.LBRACKET, 0)

        def bound(self, i:int=None):
            if i is None:
                return self.getTypedRuleContexts(catlParser.BoundContext)
            else:
                return self.getTypedRuleContext(catlParser.BoundContext,i)


        def COMMA(self):
            return self.getToken(catlParser.COMMA, 0)

        def RBRACKET(self):
            return self.getToken(catlParser.RBRACKET, 0)

        def getRuleIndex(self):
            return catlParser.RULE_interval




    def interval(self):

        localctx = catlParser.IntervalContext(self, self._ctx, self.state)
        self.enterRule(localctx, 34, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 190
            self.match(catlParser.LBRACKET)
            self.state = 191
            self.bound()
            self.state = 192
            self.match(catlParser.COMMA)
            self.state = 193
            self.bound()
            self.state = 194
            self.match(catlParser.RBRACKET)
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
            return self.getToken(catlParser.NUMBER, 0)

        def MINUS(self):
            return self.getToken(catlParser.MINUS, 0)

        def getRuleIndex(self):
            return catlParser.RULE_bound




    def bound(self):

        localctx = catlParser.BoundContext(self, self._ctx, self.state)
        self.enterRule(localctx, 36, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 197
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==31:
                self.state = 196
                self.match(catlParser.MINUS)


            self.state = 199
            self.match(catlParser.NUMBER)
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
            return self.getToken(catlParser.GE, 0)

        def LE(self):
            return self.getToken(catlParser.LE, 0)

        def GT(self):
            return self.getToken(catlParser.GT, 0)

        def LT(self):
            return self.getToken(catlParser.LT, 0)

        def EQ(self):
            return self.getToken(catlParser.EQ, 0)

        def NE(self):
            return self.getToken(catlParser.NE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_relation




    def relation(self):

        localctx = catlParser.RelationContext(self, self._ctx, self.state)
        self.enterRule(localctx, 38, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 201
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
            return self.getToken(catlParser.TRUE, 0)

        def FALSE(self):
            return self.getToken(catlParser.FALSE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_constant




    def constant(self):

        localctx = catlParser.ConstantContext(self, self._ctx, self.state)
        self.enterRule(localctx, 40, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 203
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
            return self.getToken(catlParser.NAME, 0)

        def STRING(self):
            return self.getToken(catlParser.STRING, 0)

        def reserved(self):
            return self.getTypedRuleContext(catlParser.ReservedContext,0)


        def getRuleIndex(self):
            return catlParser.RULE_name




    def name(self):

        localctx = catlParser.NameContext(self, self._ctx, self.state)
        self.enterRule(localctx, 42, self.RULE_name)
        try:
            self.state = 208
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [41]:
                self.enterOuterAlt(localctx, 1)
                self.state = 205
                self.match(catlParser.NAME)
                pass
            elif token in [42]:
                self.enterOuterAlt(localctx, 2)
                self.state = 206
                self.match(catlParser.STRING)
                pass
            elif token in [1, 2, 3, 4, 5, 21, 22, 23, 24, 25, 26, 27]:
                self.enterOuterAlt(localctx, 3)
                self.state = 207
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
            return self.getToken(catlParser.EVENTUALLY, 0)

        def ALWAYS(self):
            return self.getToken(catlParser.ALWAYS, 0)

        def UNTIL(self):
            return self.getToken(catlParser.UNTIL, 0)

        def RELEASE(self):
            return self.getToken(catlParser.RELEASE, 0)

        def NEXT(self):
            return self.getToken(catlParser.NEXT, 0)

        def ONE(self):
            return self.getToken(catlParser.ONE, 0)

        def ALL(self):
            return self.getToken(catlParser.ALL, 0)

        def getRuleIndex(self):
            return catlParser.RULE_word




    def word(self):

        localctx = catlParser.WordContext(self, self._ctx, self.state)
        self.enterRule(localctx, 44, self.RULE_word)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 210
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





