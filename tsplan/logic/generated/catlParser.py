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
        4,1,46,222,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,2,19,7,19,2,20,
        7,20,2,21,7,21,2,22,7,22,2,23,7,23,1,0,1,0,1,0,1,0,1,0,3,0,54,8,
        0,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,3,1,65,8,1,1,1,1,1,1,2,1,2,
        1,2,1,2,1,2,1,2,1,2,1,3,1,3,1,3,1,3,5,3,80,8,3,10,3,12,3,83,9,3,
        3,3,85,8,3,1,3,1,3,1,4,1,4,1,4,1,4,1,4,1,4,1,5,1,5,1,5,1,5,1,5,1,
        5,1,5,3,5,102,8,5,1,6,1,6,1,6,1,6,5,6,108,8,6,10,6,12,6,111,9,6,
        1,7,1,7,1,7,1,7,3,7,117,8,7,1,8,3,8,120,8,8,1,8,1,8,3,8,124,8,8,
        1,9,1,9,1,9,1,9,1,9,3,9,131,8,9,1,9,1,9,1,10,1,10,1,10,1,10,1,10,
        1,11,1,11,1,11,5,11,143,8,11,10,11,12,11,146,9,11,1,11,1,11,1,12,
        1,12,1,12,1,12,5,12,154,8,12,10,12,12,12,157,9,12,1,13,1,13,1,13,
        1,13,1,13,1,13,3,13,165,8,13,1,14,5,14,168,8,14,10,14,12,14,171,
        9,14,1,14,1,14,3,14,175,8,14,1,15,1,15,1,15,1,15,3,15,181,8,15,1,
        16,1,16,1,16,1,17,1,17,1,17,1,17,1,17,5,17,191,8,17,10,17,12,17,
        194,9,17,1,17,1,17,3,17,198,8,17,1,18,1,18,1,18,1,18,1,18,1,18,1,
        19,3,19,207,8,19,1,19,1,19,1,20,1,20,1,21,1,21,1,22,1,22,1,22,3,
        22,218,8,22,1,23,1,23,1,23,1,169,0,24,0,2,4,6,8,10,12,14,16,18,20,
        22,24,26,28,30,32,34,36,38,40,42,44,46,0,7,1,0,3,5,1,0,24,25,3,0,
        12,13,22,23,27,28,1,0,27,28,1,0,14,19,1,0,20,21,1,0,22,28,232,0,
        53,1,0,0,0,2,55,1,0,0,0,4,68,1,0,0,0,6,75,1,0,0,0,8,88,1,0,0,0,10,
        101,1,0,0,0,12,103,1,0,0,0,14,116,1,0,0,0,16,119,1,0,0,0,18,125,
        1,0,0,0,20,134,1,0,0,0,22,139,1,0,0,0,24,149,1,0,0,0,26,164,1,0,
        0,0,28,169,1,0,0,0,30,180,1,0,0,0,32,182,1,0,0,0,34,197,1,0,0,0,
        36,199,1,0,0,0,38,206,1,0,0,0,40,210,1,0,0,0,42,212,1,0,0,0,44,217,
        1,0,0,0,46,219,1,0,0,0,48,54,3,18,9,0,49,54,3,20,10,0,50,54,3,2,
        1,0,51,54,3,4,2,0,52,54,3,44,22,0,53,48,1,0,0,0,53,49,1,0,0,0,53,
        50,1,0,0,0,53,51,1,0,0,0,53,52,1,0,0,0,54,1,1,0,0,0,55,56,5,1,0,
        0,56,57,5,29,0,0,57,58,3,16,8,0,58,59,5,36,0,0,59,60,3,44,22,0,60,
        61,5,36,0,0,61,64,3,6,3,0,62,63,5,36,0,0,63,65,3,6,3,0,64,62,1,0,
        0,0,64,65,1,0,0,0,65,66,1,0,0,0,66,67,5,30,0,0,67,3,1,0,0,0,68,69,
        5,2,0,0,69,70,5,29,0,0,70,71,3,44,22,0,71,72,5,36,0,0,72,73,3,6,
        3,0,73,74,5,30,0,0,74,5,1,0,0,0,75,84,5,39,0,0,76,81,3,8,4,0,77,
        78,5,36,0,0,78,80,3,8,4,0,79,77,1,0,0,0,80,83,1,0,0,0,81,79,1,0,
        0,0,81,82,1,0,0,0,82,85,1,0,0,0,83,81,1,0,0,0,84,76,1,0,0,0,84,85,
        1,0,0,0,85,86,1,0,0,0,86,87,5,40,0,0,87,7,1,0,0,0,88,89,5,29,0,0,
        89,90,3,44,22,0,90,91,5,36,0,0,91,92,3,16,8,0,92,93,5,30,0,0,93,
        9,1,0,0,0,94,102,3,46,23,0,95,102,5,3,0,0,96,102,5,4,0,0,97,102,
        5,5,0,0,98,102,5,6,0,0,99,102,5,1,0,0,100,102,5,2,0,0,101,94,1,0,
        0,0,101,95,1,0,0,0,101,96,1,0,0,0,101,97,1,0,0,0,101,98,1,0,0,0,
        101,99,1,0,0,0,101,100,1,0,0,0,102,11,1,0,0,0,103,109,3,14,7,0,104,
        105,3,40,20,0,105,106,3,14,7,0,106,108,1,0,0,0,107,104,1,0,0,0,108,
        111,1,0,0,0,109,107,1,0,0,0,109,110,1,0,0,0,110,13,1,0,0,0,111,109,
        1,0,0,0,112,117,3,42,21,0,113,117,3,16,8,0,114,117,3,0,0,0,115,117,
        3,34,17,0,116,112,1,0,0,0,116,113,1,0,0,0,116,114,1,0,0,0,116,115,
        1,0,0,0,117,15,1,0,0,0,118,120,5,32,0,0,119,118,1,0,0,0,119,120,
        1,0,0,0,120,121,1,0,0,0,121,123,5,41,0,0,122,124,5,35,0,0,123,122,
        1,0,0,0,123,124,1,0,0,0,124,17,1,0,0,0,125,126,7,0,0,0,126,127,5,
        29,0,0,127,130,3,44,22,0,128,129,5,36,0,0,129,131,3,44,22,0,130,
        128,1,0,0,0,130,131,1,0,0,0,131,132,1,0,0,0,132,133,5,30,0,0,133,
        19,1,0,0,0,134,135,5,6,0,0,135,136,5,29,0,0,136,137,3,16,8,0,137,
        138,5,30,0,0,138,21,1,0,0,0,139,144,3,24,12,0,140,141,5,36,0,0,141,
        143,3,24,12,0,142,140,1,0,0,0,143,146,1,0,0,0,144,142,1,0,0,0,144,
        145,1,0,0,0,145,147,1,0,0,0,146,144,1,0,0,0,147,148,5,0,0,1,148,
        23,1,0,0,0,149,155,3,28,14,0,150,151,3,26,13,0,151,152,3,28,14,0,
        152,154,1,0,0,0,153,150,1,0,0,0,154,157,1,0,0,0,155,153,1,0,0,0,
        155,156,1,0,0,0,156,25,1,0,0,0,157,155,1,0,0,0,158,165,5,7,0,0,159,
        165,5,8,0,0,160,165,5,10,0,0,161,165,5,11,0,0,162,163,7,1,0,0,163,
        165,3,36,18,0,164,158,1,0,0,0,164,159,1,0,0,0,164,160,1,0,0,0,164,
        161,1,0,0,0,164,162,1,0,0,0,165,27,1,0,0,0,166,168,3,30,15,0,167,
        166,1,0,0,0,168,171,1,0,0,0,169,170,1,0,0,0,169,167,1,0,0,0,170,
        174,1,0,0,0,171,169,1,0,0,0,172,175,3,12,6,0,173,175,3,32,16,0,174,
        172,1,0,0,0,174,173,1,0,0,0,175,29,1,0,0,0,176,181,5,9,0,0,177,181,
        5,26,0,0,178,179,7,2,0,0,179,181,3,36,18,0,180,176,1,0,0,0,180,177,
        1,0,0,0,180,178,1,0,0,0,181,31,1,0,0,0,182,183,7,3,0,0,183,184,3,
        34,17,0,184,33,1,0,0,0,185,198,5,46,0,0,186,187,5,29,0,0,187,192,
        3,24,12,0,188,189,5,36,0,0,189,191,3,24,12,0,190,188,1,0,0,0,191,
        194,1,0,0,0,192,190,1,0,0,0,192,193,1,0,0,0,193,195,1,0,0,0,194,
        192,1,0,0,0,195,196,5,30,0,0,196,198,1,0,0,0,197,185,1,0,0,0,197,
        186,1,0,0,0,198,35,1,0,0,0,199,200,5,37,0,0,200,201,3,38,19,0,201,
        202,5,36,0,0,202,203,3,38,19,0,203,204,5,38,0,0,204,37,1,0,0,0,205,
        207,5,32,0,0,206,205,1,0,0,0,206,207,1,0,0,0,207,208,1,0,0,0,208,
        209,5,41,0,0,209,39,1,0,0,0,210,211,7,4,0,0,211,41,1,0,0,0,212,213,
        7,5,0,0,213,43,1,0,0,0,214,218,5,42,0,0,215,218,5,43,0,0,216,218,
        3,10,5,0,217,214,1,0,0,0,217,215,1,0,0,0,217,216,1,0,0,0,218,45,
        1,0,0,0,219,220,7,6,0,0,220,47,1,0,0,0,20,53,64,81,84,101,109,116,
        119,123,130,144,155,164,169,174,180,192,197,206,217
    ]

class catlParser ( Parser ):

    grammarFileName = "catl.g4"

    atn = ATNDeserializer().deserialize(serializedATN())

    decisionsToDFA = [ DFA(ds, i) for i, ds in enumerate(atn.decisionToState) ]

    sharedContextCache = PredictionContextCache()

    literalNames = [ "<INVALID>", "'T'", "'L'", "'sum'", "'min'", "'max'", 
                     "'known'", "<INVALID>", "<INVALID>", "<INVALID>", "<INVALID>", 
                     "<INVALID>", "'<>'", "'[]'", "'>='", "'<='", "'>'", 
                     "'<'", "<INVALID>", "'!='", "<INVALID>", "<INVALID>", 
                     "'F'", "'G'", "'U'", "'R'", "'X'", "'one'", "'all'", 
                     "'('", "')'", "'+'", "'-'", "'*'", "'/'", "'%'", "','", 
                     "'['", "']'", "'{'", "'}'" ]

    symbolicNames = [ "<INVALID>", "TASK", "LIMIT", "SUM", "MIN", "MAX", 
                      "KNOWN", "AND", "OR", "NOT", "IMPLIES", "IFF", "DIAMOND", 
                      "BOX", "GE", "LE", "GT", "LT", "EQ", "NE", "TRUE", 
                      "FALSE", "EVENTUALLY", "ALWAYS", "UNTIL", "RELEASE", 
                      "NEXT", "ONE", "ALL", "OPEN", "CLOSE", "PLUS", "MINUS", 
                      "STAR", "SLASH", "PERCENT", "COMMA", "LBRACKET", "RBRACKET", 
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
    RULE_known = 10
    RULE_formula = 11
    RULE_level = 12
    RULE_connective = 13
    RULE_unary = 14
    RULE_prefix = 15
    RULE_joined = 16
    RULE_parts = 17
    RULE_interval = 18
    RULE_bound = 19
    RULE_relation = 20
    RULE_constant = 21
    RULE_name = 22
    RULE_word = 23

    ruleNames =  [ "atom", "task", "limit", "pairs", "pair", "reserved", 
                   "comparison", "operand", "number", "count", "known", 
                   "formula", "level", "connective", "unary", "prefix", 
                   "joined", "parts", "interval", "bound", "relation", "constant", 
                   "name", "word" ]

    EOF = Token.EOF
    TASK=1
    LIMIT=2
    SUM=3
    MIN=4
    MAX=5
    KNOWN=6
    AND=7
    OR=8
    NOT=9
    IMPLIES=10
    IFF=11
    DIAMOND=12
    BOX=13
    GE=14
    LE=15
    GT=16
    LT=17
    EQ=18
    NE=19
    TRUE=20
    FALSE=21
    EVENTUALLY=22
    ALWAYS=23
    UNTIL=24
    RELEASE=25
    NEXT=26
    ONE=27
    ALL=28
    OPEN=29
    CLOSE=30
    PLUS=31
    MINUS=32
    STAR=33
    SLASH=34
    PERCENT=35
    COMMA=36
    LBRACKET=37
    RBRACKET=38
    LBRACE=39
    RBRACE=40
    NUMBER=41
    NAME=42
    STRING=43
    SPACE=44
    STRAY=45
    GROUP=46

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


        def known(self):
            return self.getTypedRuleContext(catlParser.KnownContext,0)


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
            self.state = 53
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,0,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 48
                self.count()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 49
                self.known()
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 50
                self.task()
                pass

            elif la_ == 4:
                self.enterOuterAlt(localctx, 4)
                self.state = 51
                self.limit()
                pass

            elif la_ == 5:
                self.enterOuterAlt(localctx, 5)
                self.state = 52
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
            self.state = 55
            self.match(catlParser.TASK)
            self.state = 56
            self.match(catlParser.OPEN)
            self.state = 57
            self.number()
            self.state = 58
            self.match(catlParser.COMMA)
            self.state = 59
            self.name()
            self.state = 60
            self.match(catlParser.COMMA)
            self.state = 61
            self.pairs()
            self.state = 64
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==36:
                self.state = 62
                self.match(catlParser.COMMA)
                self.state = 63
                self.pairs()


            self.state = 66
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
            self.state = 68
            self.match(catlParser.LIMIT)
            self.state = 69
            self.match(catlParser.OPEN)
            self.state = 70
            self.name()
            self.state = 71
            self.match(catlParser.COMMA)
            self.state = 72
            self.pairs()
            self.state = 73
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
            self.state = 75
            self.match(catlParser.LBRACE)
            self.state = 84
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==29:
                self.state = 76
                self.pair()
                self.state = 81
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==36:
                    self.state = 77
                    self.match(catlParser.COMMA)
                    self.state = 78
                    self.pair()
                    self.state = 83
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)



            self.state = 86
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
            self.state = 88
            self.match(catlParser.OPEN)
            self.state = 89
            self.name()
            self.state = 90
            self.match(catlParser.COMMA)
            self.state = 91
            self.number()
            self.state = 92
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

        def KNOWN(self):
            return self.getToken(catlParser.KNOWN, 0)

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
            self.state = 101
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [22, 23, 24, 25, 26, 27, 28]:
                self.enterOuterAlt(localctx, 1)
                self.state = 94
                self.word()
                pass
            elif token in [3]:
                self.enterOuterAlt(localctx, 2)
                self.state = 95
                self.match(catlParser.SUM)
                pass
            elif token in [4]:
                self.enterOuterAlt(localctx, 3)
                self.state = 96
                self.match(catlParser.MIN)
                pass
            elif token in [5]:
                self.enterOuterAlt(localctx, 4)
                self.state = 97
                self.match(catlParser.MAX)
                pass
            elif token in [6]:
                self.enterOuterAlt(localctx, 5)
                self.state = 98
                self.match(catlParser.KNOWN)
                pass
            elif token in [1]:
                self.enterOuterAlt(localctx, 6)
                self.state = 99
                self.match(catlParser.TASK)
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 7)
                self.state = 100
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
            self.state = 103
            self.operand()
            self.state = 109
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 1032192) != 0):
                self.state = 104
                self.relation()
                self.state = 105
                self.operand()
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
            self.state = 116
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [20, 21]:
                self.enterOuterAlt(localctx, 1)
                self.state = 112
                self.constant()
                pass
            elif token in [32, 41]:
                self.enterOuterAlt(localctx, 2)
                self.state = 113
                self.number()
                pass
            elif token in [1, 2, 3, 4, 5, 6, 22, 23, 24, 25, 26, 27, 28, 42, 43]:
                self.enterOuterAlt(localctx, 3)
                self.state = 114
                self.atom()
                pass
            elif token in [29, 46]:
                self.enterOuterAlt(localctx, 4)
                self.state = 115
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
            self.state = 119
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==32:
                self.state = 118
                self.match(catlParser.MINUS)


            self.state = 121
            self.match(catlParser.NUMBER)
            self.state = 123
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==35:
                self.state = 122
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
            self.state = 125
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 56) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 126
            self.match(catlParser.OPEN)
            self.state = 127
            self.name()
            self.state = 130
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==36:
                self.state = 128
                self.match(catlParser.COMMA)
                self.state = 129
                self.name()


            self.state = 132
            self.match(catlParser.CLOSE)
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
            return self.getToken(catlParser.KNOWN, 0)

        def OPEN(self):
            return self.getToken(catlParser.OPEN, 0)

        def number(self):
            return self.getTypedRuleContext(catlParser.NumberContext,0)


        def CLOSE(self):
            return self.getToken(catlParser.CLOSE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_known




    def known(self):

        localctx = catlParser.KnownContext(self, self._ctx, self.state)
        self.enterRule(localctx, 20, self.RULE_known)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 134
            self.match(catlParser.KNOWN)
            self.state = 135
            self.match(catlParser.OPEN)
            self.state = 136
            self.number()
            self.state = 137
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
        self.enterRule(localctx, 22, self.RULE_formula)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 139
            self.level()
            self.state = 144
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==36:
                self.state = 140
                self.match(catlParser.COMMA)
                self.state = 141
                self.level()
                self.state = 146
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 147
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
        self.enterRule(localctx, 24, self.RULE_level)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 149
            self.unary()
            self.state = 155
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 50335104) != 0):
                self.state = 150
                self.connective()
                self.state = 151
                self.unary()
                self.state = 157
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
        self.enterRule(localctx, 26, self.RULE_connective)
        self._la = 0 # Token type
        try:
            self.state = 164
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [7]:
                self.enterOuterAlt(localctx, 1)
                self.state = 158
                self.match(catlParser.AND)
                pass
            elif token in [8]:
                self.enterOuterAlt(localctx, 2)
                self.state = 159
                self.match(catlParser.OR)
                pass
            elif token in [10]:
                self.enterOuterAlt(localctx, 3)
                self.state = 160
                self.match(catlParser.IMPLIES)
                pass
            elif token in [11]:
                self.enterOuterAlt(localctx, 4)
                self.state = 161
                self.match(catlParser.IFF)
                pass
            elif token in [24, 25]:
                self.enterOuterAlt(localctx, 5)
                self.state = 162
                _la = self._input.LA(1)
                if not(_la==24 or _la==25):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 163
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
        self.enterRule(localctx, 28, self.RULE_unary)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 169
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,13,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 166
                    self.prefix() 
                self.state = 171
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,13,self._ctx)

            self.state = 174
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,14,self._ctx)
            if la_ == 1:
                self.state = 172
                self.comparison()
                pass

            elif la_ == 2:
                self.state = 173
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
        self.enterRule(localctx, 30, self.RULE_prefix)
        self._la = 0 # Token type
        try:
            self.state = 180
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [9]:
                self.enterOuterAlt(localctx, 1)
                self.state = 176
                self.match(catlParser.NOT)
                pass
            elif token in [26]:
                self.enterOuterAlt(localctx, 2)
                self.state = 177
                self.match(catlParser.NEXT)
                pass
            elif token in [12, 13, 22, 23, 27, 28]:
                self.enterOuterAlt(localctx, 3)
                self.state = 178
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 415248384) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 179
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
        self.enterRule(localctx, 32, self.RULE_joined)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 182
            _la = self._input.LA(1)
            if not(_la==27 or _la==28):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 183
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
        self.enterRule(localctx, 34, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 197
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [46]:
                self.enterOuterAlt(localctx, 1)
                self.state = 185
                self.match(catlParser.GROUP)
                pass
            elif token in [29]:
                self.enterOuterAlt(localctx, 2)
                self.state = 186
                self.match(catlParser.OPEN)
                self.state = 187
                self.level()
                self.state = 192
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==36:
                    self.state = 188
                    self.match(catlParser.COMMA)
                    self.state = 189
                    self.level()
                    self.state = 194
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 195
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
        self.enterRule(localctx, 36, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 199
            self.match(catlParser.LBRACKET)
            self.state = 200
            self.bound()
            self.state = 201
            self.match(catlParser.COMMA)
            self.state = 202
            self.bound()
            self.state = 203
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
        self.enterRule(localctx, 38, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 206
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==32:
                self.state = 205
                self.match(catlParser.MINUS)


            self.state = 208
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
        self.enterRule(localctx, 40, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 210
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 1032192) != 0)):
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
        self.enterRule(localctx, 42, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 212
            _la = self._input.LA(1)
            if not(_la==20 or _la==21):
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
        self.enterRule(localctx, 44, self.RULE_name)
        try:
            self.state = 217
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [42]:
                self.enterOuterAlt(localctx, 1)
                self.state = 214
                self.match(catlParser.NAME)
                pass
            elif token in [43]:
                self.enterOuterAlt(localctx, 2)
                self.state = 215
                self.match(catlParser.STRING)
                pass
            elif token in [1, 2, 3, 4, 5, 6, 22, 23, 24, 25, 26, 27, 28]:
                self.enterOuterAlt(localctx, 3)
                self.state = 216
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
        self.enterRule(localctx, 46, self.RULE_word)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 219
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 532676608) != 0)):
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





