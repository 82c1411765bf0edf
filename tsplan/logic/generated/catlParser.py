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
        4,1,47,233,2,0,7,0,2,1,7,1,2,2,7,2,2,3,7,3,2,4,7,4,2,5,7,5,2,6,7,
        6,2,7,7,7,2,8,7,8,2,9,7,9,2,10,7,10,2,11,7,11,2,12,7,12,2,13,7,13,
        2,14,7,14,2,15,7,15,2,16,7,16,2,17,7,17,2,18,7,18,2,19,7,19,2,20,
        7,20,2,21,7,21,2,22,7,22,2,23,7,23,2,24,7,24,1,0,1,0,1,0,1,0,1,0,
        1,0,3,0,57,8,0,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,3,1,68,8,1,1,
        1,1,1,1,2,1,2,1,2,1,2,1,2,1,2,1,2,1,3,1,3,1,3,1,3,1,3,1,3,1,3,1,
        4,1,4,1,4,1,4,5,4,90,8,4,10,4,12,4,93,9,4,3,4,95,8,4,1,4,1,4,1,5,
        1,5,1,5,1,5,1,5,1,5,1,6,1,6,1,6,1,6,1,6,1,6,1,6,1,6,3,6,113,8,6,
        1,7,1,7,1,7,1,7,5,7,119,8,7,10,7,12,7,122,9,7,1,8,1,8,1,8,1,8,3,
        8,128,8,8,1,9,3,9,131,8,9,1,9,1,9,3,9,135,8,9,1,10,1,10,1,10,1,10,
        1,10,3,10,142,8,10,1,10,1,10,1,11,1,11,1,11,1,11,1,11,1,12,1,12,
        1,12,5,12,154,8,12,10,12,12,12,157,9,12,1,12,1,12,1,13,1,13,1,13,
        1,13,5,13,165,8,13,10,13,12,13,168,9,13,1,14,1,14,1,14,1,14,1,14,
        1,14,3,14,176,8,14,1,15,5,15,179,8,15,10,15,12,15,182,9,15,1,15,
        1,15,3,15,186,8,15,1,16,1,16,1,16,1,16,3,16,192,8,16,1,17,1,17,1,
        17,1,18,1,18,1,18,1,18,1,18,5,18,202,8,18,10,18,12,18,205,9,18,1,
        18,1,18,3,18,209,8,18,1,19,1,19,1,19,1,19,1,19,1,19,1,20,3,20,218,
        8,20,1,20,1,20,1,21,1,21,1,22,1,22,1,23,1,23,1,23,3,23,229,8,23,
        1,24,1,24,1,24,1,180,0,25,0,2,4,6,8,10,12,14,16,18,20,22,24,26,28,
        30,32,34,36,38,40,42,44,46,48,0,7,1,0,4,6,1,0,25,26,3,0,13,14,23,
        24,28,29,1,0,28,29,1,0,15,20,1,0,21,22,1,0,23,29,244,0,56,1,0,0,
        0,2,58,1,0,0,0,4,71,1,0,0,0,6,78,1,0,0,0,8,85,1,0,0,0,10,98,1,0,
        0,0,12,112,1,0,0,0,14,114,1,0,0,0,16,127,1,0,0,0,18,130,1,0,0,0,
        20,136,1,0,0,0,22,145,1,0,0,0,24,150,1,0,0,0,26,160,1,0,0,0,28,175,
        1,0,0,0,30,180,1,0,0,0,32,191,1,0,0,0,34,193,1,0,0,0,36,208,1,0,
        0,0,38,210,1,0,0,0,40,217,1,0,0,0,42,221,1,0,0,0,44,223,1,0,0,0,
        46,228,1,0,0,0,48,230,1,0,0,0,50,57,3,20,10,0,51,57,3,22,11,0,52,
        57,3,2,1,0,53,57,3,4,2,0,54,57,3,6,3,0,55,57,3,46,23,0,56,50,1,0,
        0,0,56,51,1,0,0,0,56,52,1,0,0,0,56,53,1,0,0,0,56,54,1,0,0,0,56,55,
        1,0,0,0,57,1,1,0,0,0,58,59,5,1,0,0,59,60,5,30,0,0,60,61,3,18,9,0,
        61,62,5,37,0,0,62,63,3,46,23,0,63,64,5,37,0,0,64,67,3,8,4,0,65,66,
        5,37,0,0,66,68,3,8,4,0,67,65,1,0,0,0,67,68,1,0,0,0,68,69,1,0,0,0,
        69,70,5,31,0,0,70,3,1,0,0,0,71,72,5,2,0,0,72,73,5,30,0,0,73,74,3,
        2,1,0,74,75,5,37,0,0,75,76,3,18,9,0,76,77,5,31,0,0,77,5,1,0,0,0,
        78,79,5,3,0,0,79,80,5,30,0,0,80,81,3,46,23,0,81,82,5,37,0,0,82,83,
        3,8,4,0,83,84,5,31,0,0,84,7,1,0,0,0,85,94,5,40,0,0,86,91,3,10,5,
        0,87,88,5,37,0,0,88,90,3,10,5,0,89,87,1,0,0,0,90,93,1,0,0,0,91,89,
        1,0,0,0,91,92,1,0,0,0,92,95,1,0,0,0,93,91,1,0,0,0,94,86,1,0,0,0,
        94,95,1,0,0,0,95,96,1,0,0,0,96,97,5,41,0,0,97,9,1,0,0,0,98,99,5,
        30,0,0,99,100,3,46,23,0,100,101,5,37,0,0,101,102,3,18,9,0,102,103,
        5,31,0,0,103,11,1,0,0,0,104,113,3,48,24,0,105,113,5,4,0,0,106,113,
        5,5,0,0,107,113,5,6,0,0,108,113,5,7,0,0,109,113,5,1,0,0,110,113,
        5,2,0,0,111,113,5,3,0,0,112,104,1,0,0,0,112,105,1,0,0,0,112,106,
        1,0,0,0,112,107,1,0,0,0,112,108,1,0,0,0,112,109,1,0,0,0,112,110,
        1,0,0,0,112,111,1,0,0,0,113,13,1,0,0,0,114,120,3,16,8,0,115,116,
        3,42,21,0,116,117,3,16,8,0,117,119,1,0,0,0,118,115,1,0,0,0,119,122,
        1,0,0,0,120,118,1,0,0,0,120,121,1,0,0,0,121,15,1,0,0,0,122,120,1,
        0,0,0,123,128,3,44,22,0,124,128,3,18,9,0,125,128,3,0,0,0,126,128,
        3,36,18,0,127,123,1,0,0,0,127,124,1,0,0,0,127,125,1,0,0,0,127,126,
        1,0,0,0,128,17,1,0,0,0,129,131,5,33,0,0,130,129,1,0,0,0,130,131,
        1,0,0,0,131,132,1,0,0,0,132,134,5,42,0,0,133,135,5,36,0,0,134,133,
        1,0,0,0,134,135,1,0,0,0,135,19,1,0,0,0,136,137,7,0,0,0,137,138,5,
        30,0,0,138,141,3,46,23,0,139,140,5,37,0,0,140,142,3,46,23,0,141,
        139,1,0,0,0,141,142,1,0,0,0,142,143,1,0,0,0,143,144,5,31,0,0,144,
        21,1,0,0,0,145,146,5,7,0,0,146,147,5,30,0,0,147,148,3,18,9,0,148,
        149,5,31,0,0,149,23,1,0,0,0,150,155,3,26,13,0,151,152,5,37,0,0,152,
        154,3,26,13,0,153,151,1,0,0,0,154,157,1,0,0,0,155,153,1,0,0,0,155,
        156,1,0,0,0,156,158,1,0,0,0,157,155,1,0,0,0,158,159,5,0,0,1,159,
        25,1,0,0,0,160,166,3,30,15,0,161,162,3,28,14,0,162,163,3,30,15,0,
        163,165,1,0,0,0,164,161,1,0,0,0,165,168,1,0,0,0,166,164,1,0,0,0,
        166,167,1,0,0,0,167,27,1,0,0,0,168,166,1,0,0,0,169,176,5,8,0,0,170,
        176,5,9,0,0,171,176,5,11,0,0,172,176,5,12,0,0,173,174,7,1,0,0,174,
        176,3,38,19,0,175,169,1,0,0,0,175,170,1,0,0,0,175,171,1,0,0,0,175,
        172,1,0,0,0,175,173,1,0,0,0,176,29,1,0,0,0,177,179,3,32,16,0,178,
        177,1,0,0,0,179,182,1,0,0,0,180,181,1,0,0,0,180,178,1,0,0,0,181,
        185,1,0,0,0,182,180,1,0,0,0,183,186,3,14,7,0,184,186,3,34,17,0,185,
        183,1,0,0,0,185,184,1,0,0,0,186,31,1,0,0,0,187,192,5,10,0,0,188,
        192,5,27,0,0,189,190,7,2,0,0,190,192,3,38,19,0,191,187,1,0,0,0,191,
        188,1,0,0,0,191,189,1,0,0,0,192,33,1,0,0,0,193,194,7,3,0,0,194,195,
        3,36,18,0,195,35,1,0,0,0,196,209,5,47,0,0,197,198,5,30,0,0,198,203,
        3,26,13,0,199,200,5,37,0,0,200,202,3,26,13,0,201,199,1,0,0,0,202,
        205,1,0,0,0,203,201,1,0,0,0,203,204,1,0,0,0,204,206,1,0,0,0,205,
        203,1,0,0,0,206,207,5,31,0,0,207,209,1,0,0,0,208,196,1,0,0,0,208,
        197,1,0,0,0,209,37,1,0,0,0,210,211,5,38,0,0,211,212,3,40,20,0,212,
        213,5,37,0,0,213,214,3,40,20,0,214,215,5,39,0,0,215,39,1,0,0,0,216,
        218,5,33,0,0,217,216,1,0,0,0,217,218,1,0,0,0,218,219,1,0,0,0,219,
        220,5,42,0,0,220,41,1,0,0,0,221,222,7,4,0,0,222,43,1,0,0,0,223,224,
        7,5,0,0,224,45,1,0,0,0,225,229,5,43,0,0,226,229,5,44,0,0,227,229,
        3,12,6,0,228,225,1,0,0,0,228,226,1,0,0,0,228,227,1,0,0,0,229,47,
        1,0,0,0,230,231,7,6,0,0,231,49,1,0,0,0,20,56,67,91,94,112,120,127,
        130,134,141,155,166,175,180,185,191,203,208,217,228
    ]

class catlParser ( Parser ):

    grammarFileName = "catl.g4"

    atn = ATNDeserializer().deserialize(serializedATN())

    decisionsToDFA = [ DFA(ds, i) for i, ds in enumerate(atn.decisionToState) ]

    sharedContextCache = PredictionContextCache()

    literalNames = [ "<INVALID>", "'T'", "'begun'", "'L'", "'sum'", "'min'", 
                     "'max'", "'known'", "<INVALID>", "<INVALID>", "<INVALID>", 
                     "<INVALID>", "<INVALID>", "'<>'", "'[]'", "'>='", "'<='", 
                     "'>'", "'<'", "<INVALID>", "'!='", "<INVALID>", "<INVALID>", 
                     "'F'", "'G'", "'U'", "'R'", "'X'", "'one'", "'all'", 
                     "'('", "')'", "'+'", "'-'", "'*'", "'/'", "'%'", "','", 
                     "'['", "']'", "'{'", "'}'" ]

    symbolicNames = [ "<INVALID>", "TASK", "BEGUN", "LIMIT", "SUM", "MIN", 
                      "MAX", "KNOWN", "AND", "OR", "NOT", "IMPLIES", "IFF", 
                      "DIAMOND", "BOX", "GE", "LE", "GT", "LT", "EQ", "NE", 
                      "TRUE", "FALSE", "EVENTUALLY", "ALWAYS", "UNTIL", 
                      "RELEASE", "NEXT", "ONE", "ALL", "OPEN", "CLOSE", 
                      "PLUS", "MINUS", "STAR", "SLASH", "PERCENT", "COMMA", 
                      "LBRACKET", "RBRACKET", "LBRACE", "RBRACE", "NUMBER", 
                      "NAME", "STRING", "SPACE", "STRAY", "GROUP" ]

    RULE_atom = 0
    RULE_task = 1
    RULE_begun = 2
    RULE_limit = 3
    RULE_pairs = 4
    RULE_pair = 5
    RULE_reserved = 6
    RULE_comparison = 7
    RULE_operand = 8
    RULE_number = 9
    RULE_count = 10
    RULE_known = 11
    RULE_formula = 12
    RULE_level = 13
    RULE_connective = 14
    RULE_unary = 15
    RULE_prefix = 16
    RULE_joined = 17
    RULE_parts = 18
    RULE_interval = 19
    RULE_bound = 20
    RULE_relation = 21
    RULE_constant = 22
    RULE_name = 23
    RULE_word = 24

    ruleNames =  [ "atom", "task", "begun", "limit", "pairs", "pair", "reserved", 
                   "comparison", "operand", "number", "count", "known", 
                   "formula", "level", "connective", "unary", "prefix", 
                   "joined", "parts", "interval", "bound", "relation", "constant", 
                   "name", "word" ]

    EOF = Token.EOF
    TASK=1
    BEGUN=2
    LIMIT=3
    SUM=4
    MIN=5
    MAX=6
    KNOWN=7
    AND=8
    OR=9
    NOT=10
    IMPLIES=11
    IFF=12
    DIAMOND=13
    BOX=14
    GE=15
    LE=16
    GT=17
    LT=18
    EQ=19
    NE=20
    TRUE=21
    FALSE=22
    EVENTUALLY=23
    ALWAYS=24
    UNTIL=25
    RELEASE=26
    NEXT=27
    ONE=28
    ALL=29
    OPEN=30
    CLOSE=31
    PLUS=32
    MINUS=33
    STAR=34
    SLASH=35
    PERCENT=36
    COMMA=37
    LBRACKET=38
    RBRACKET=39
    LBRACE=40
    RBRACE=41
    NUMBER=42
    NAME=43
    STRING=44
    SPACE=45
    STRAY=46
    GROUP=47

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


        def begun(self):
            return self.getTypedRuleContext(catlParser.BegunContext,0)


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
            self.state = 56
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,0,self._ctx)
            if la_ == 1:
                self.enterOuterAlt(localctx, 1)
                self.state = 50
                self.count()
                pass

            elif la_ == 2:
                self.enterOuterAlt(localctx, 2)
                self.state = 51
                self.known()
                pass

            elif la_ == 3:
                self.enterOuterAlt(localctx, 3)
                self.state = 52
                self.task()
                pass

            elif la_ == 4:
                self.enterOuterAlt(localctx, 4)
                self.state = 53
                self.begun()
                pass

            elif la_ == 5:
                self.enterOuterAlt(localctx, 5)
                self.state = 54
                self.limit()
                pass

            elif la_ == 6:
                self.enterOuterAlt(localctx, 6)
                self.state = 55
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
            self.state = 58
            self.match(catlParser.TASK)
            self.state = 59
            self.match(catlParser.OPEN)
            self.state = 60
            self.number()
            self.state = 61
            self.match(catlParser.COMMA)
            self.state = 62
            self.name()
            self.state = 63
            self.match(catlParser.COMMA)
            self.state = 64
            self.pairs()
            self.state = 67
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==37:
                self.state = 65
                self.match(catlParser.COMMA)
                self.state = 66
                self.pairs()


            self.state = 69
            self.match(catlParser.CLOSE)
        except RecognitionException as re:
            localctx.exception = re
            self._errHandler.reportError(self, re)
            self._errHandler.recover(self, re)
        finally:
            self.exitRule()
        return localctx


    class BegunContext(ParserRuleContext):
        __slots__ = 'parser'

        def __init__(self, parser, parent:ParserRuleContext=None, invokingState:int=-1):
            super().__init__(parent, invokingState)
            self.parser = parser

        def BEGUN(self):
            return self.getToken(catlParser.BEGUN, 0)

        def OPEN(self):
            return self.getToken(catlParser.OPEN, 0)

        def task(self):
            return self.getTypedRuleContext(catlParser.TaskContext,0)


        def COMMA(self):
            return self.getToken(catlParser.COMMA, 0)

        def number(self):
            return self.getTypedRuleContext(catlParser.NumberContext,0)


        def CLOSE(self):
            return self.getToken(catlParser.CLOSE, 0)

        def getRuleIndex(self):
            return catlParser.RULE_begun




    def begun(self):

        localctx = catlParser.BegunContext(self, self._ctx, self.state)
        self.enterRule(localctx, 4, self.RULE_begun)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 71
            self.match(catlParser.BEGUN)
            self.state = 72
            self.match(catlParser.OPEN)
            self.state = 73
            self.task()
            self.state = 74
            self.match(catlParser.COMMA)
            self.state = 75
            self.number()
            self.state = 76
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
        self.enterRule(localctx, 6, self.RULE_limit)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 78
            self.match(catlParser.LIMIT)
            self.state = 79
            self.match(catlParser.OPEN)
            self.state = 80
            self.name()
            self.state = 81
            self.match(catlParser.COMMA)
            self.state = 82
            self.pairs()
            self.state = 83
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
        self.enterRule(localctx, 8, self.RULE_pairs)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 85
            self.match(catlParser.LBRACE)
            self.state = 94
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==30:
                self.state = 86
                self.pair()
                self.state = 91
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==37:
                    self.state = 87
                    self.match(catlParser.COMMA)
                    self.state = 88
                    self.pair()
                    self.state = 93
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)



            self.state = 96
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
        self.enterRule(localctx, 10, self.RULE_pair)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 98
            self.match(catlParser.OPEN)
            self.state = 99
            self.name()
            self.state = 100
            self.match(catlParser.COMMA)
            self.state = 101
            self.number()
            self.state = 102
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

        def BEGUN(self):
            return self.getToken(catlParser.BEGUN, 0)

        def LIMIT(self):
            return self.getToken(catlParser.LIMIT, 0)

        def getRuleIndex(self):
            return catlParser.RULE_reserved




    def reserved(self):

        localctx = catlParser.ReservedContext(self, self._ctx, self.state)
        self.enterRule(localctx, 12, self.RULE_reserved)
        try:
            self.state = 112
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [23, 24, 25, 26, 27, 28, 29]:
                self.enterOuterAlt(localctx, 1)
                self.state = 104
                self.word()
                pass
            elif token in [4]:
                self.enterOuterAlt(localctx, 2)
                self.state = 105
                self.match(catlParser.SUM)
                pass
            elif token in [5]:
                self.enterOuterAlt(localctx, 3)
                self.state = 106
                self.match(catlParser.MIN)
                pass
            elif token in [6]:
                self.enterOuterAlt(localctx, 4)
                self.state = 107
                self.match(catlParser.MAX)
                pass
            elif token in [7]:
                self.enterOuterAlt(localctx, 5)
                self.state = 108
                self.match(catlParser.KNOWN)
                pass
            elif token in [1]:
                self.enterOuterAlt(localctx, 6)
                self.state = 109
                self.match(catlParser.TASK)
                pass
            elif token in [2]:
                self.enterOuterAlt(localctx, 7)
                self.state = 110
                self.match(catlParser.BEGUN)
                pass
            elif token in [3]:
                self.enterOuterAlt(localctx, 8)
                self.state = 111
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
        self.enterRule(localctx, 14, self.RULE_comparison)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 114
            self.operand()
            self.state = 120
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 2064384) != 0):
                self.state = 115
                self.relation()
                self.state = 116
                self.operand()
                self.state = 122
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
        self.enterRule(localctx, 16, self.RULE_operand)
        try:
            self.state = 127
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [21, 22]:
                self.enterOuterAlt(localctx, 1)
                self.state = 123
                self.constant()
                pass
            elif token in [33, 42]:
                self.enterOuterAlt(localctx, 2)
                self.state = 124
                self.number()
                pass
            elif token in [1, 2, 3, 4, 5, 6, 7, 23, 24, 25, 26, 27, 28, 29, 43, 44]:
                self.enterOuterAlt(localctx, 3)
                self.state = 125
                self.atom()
                pass
            elif token in [30, 47]:
                self.enterOuterAlt(localctx, 4)
                self.state = 126
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
        self.enterRule(localctx, 18, self.RULE_number)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 130
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==33:
                self.state = 129
                self.match(catlParser.MINUS)


            self.state = 132
            self.match(catlParser.NUMBER)
            self.state = 134
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==36:
                self.state = 133
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
        self.enterRule(localctx, 20, self.RULE_count)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 136
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 112) != 0)):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 137
            self.match(catlParser.OPEN)
            self.state = 138
            self.name()
            self.state = 141
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==37:
                self.state = 139
                self.match(catlParser.COMMA)
                self.state = 140
                self.name()


            self.state = 143
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
        self.enterRule(localctx, 22, self.RULE_known)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 145
            self.match(catlParser.KNOWN)
            self.state = 146
            self.match(catlParser.OPEN)
            self.state = 147
            self.number()
            self.state = 148
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
        self.enterRule(localctx, 24, self.RULE_formula)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 150
            self.level()
            self.state = 155
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while _la==37:
                self.state = 151
                self.match(catlParser.COMMA)
                self.state = 152
                self.level()
                self.state = 157
                self._errHandler.sync(self)
                _la = self._input.LA(1)

            self.state = 158
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
        self.enterRule(localctx, 26, self.RULE_level)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 160
            self.unary()
            self.state = 166
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            while (((_la) & ~0x3f) == 0 and ((1 << _la) & 100670208) != 0):
                self.state = 161
                self.connective()
                self.state = 162
                self.unary()
                self.state = 168
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
        self.enterRule(localctx, 28, self.RULE_connective)
        self._la = 0 # Token type
        try:
            self.state = 175
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [8]:
                self.enterOuterAlt(localctx, 1)
                self.state = 169
                self.match(catlParser.AND)
                pass
            elif token in [9]:
                self.enterOuterAlt(localctx, 2)
                self.state = 170
                self.match(catlParser.OR)
                pass
            elif token in [11]:
                self.enterOuterAlt(localctx, 3)
                self.state = 171
                self.match(catlParser.IMPLIES)
                pass
            elif token in [12]:
                self.enterOuterAlt(localctx, 4)
                self.state = 172
                self.match(catlParser.IFF)
                pass
            elif token in [25, 26]:
                self.enterOuterAlt(localctx, 5)
                self.state = 173
                _la = self._input.LA(1)
                if not(_la==25 or _la==26):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 174
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
        self.enterRule(localctx, 30, self.RULE_unary)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 180
            self._errHandler.sync(self)
            _alt = self._interp.adaptivePredict(self._input,13,self._ctx)
            while _alt!=1 and _alt!=ATN.INVALID_ALT_NUMBER:
                if _alt==1+1:
                    self.state = 177
                    self.prefix() 
                self.state = 182
                self._errHandler.sync(self)
                _alt = self._interp.adaptivePredict(self._input,13,self._ctx)

            self.state = 185
            self._errHandler.sync(self)
            la_ = self._interp.adaptivePredict(self._input,14,self._ctx)
            if la_ == 1:
                self.state = 183
                self.comparison()
                pass

            elif la_ == 2:
                self.state = 184
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
        self.enterRule(localctx, 32, self.RULE_prefix)
        self._la = 0 # Token type
        try:
            self.state = 191
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [10]:
                self.enterOuterAlt(localctx, 1)
                self.state = 187
                self.match(catlParser.NOT)
                pass
            elif token in [27]:
                self.enterOuterAlt(localctx, 2)
                self.state = 188
                self.match(catlParser.NEXT)
                pass
            elif token in [13, 14, 23, 24, 28, 29]:
                self.enterOuterAlt(localctx, 3)
                self.state = 189
                _la = self._input.LA(1)
                if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 830496768) != 0)):
                    self._errHandler.recoverInline(self)
                else:
                    self._errHandler.reportMatch(self)
                    self.consume()
                self.state = 190
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
        self.enterRule(localctx, 34, self.RULE_joined)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 193
            _la = self._input.LA(1)
            if not(_la==28 or _la==29):
                self._errHandler.recoverInline(self)
            else:
                self._errHandler.reportMatch(self)
                self.consume()
            self.state = 194
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
        self.enterRule(localctx, 36, self.RULE_parts)
        self._la = 0 # Token type
        try:
            self.state = 208
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [47]:
                self.enterOuterAlt(localctx, 1)
                self.state = 196
                self.match(catlParser.GROUP)
                pass
            elif token in [30]:
                self.enterOuterAlt(localctx, 2)
                self.state = 197
                self.match(catlParser.OPEN)
                self.state = 198
                self.level()
                self.state = 203
                self._errHandler.sync(self)
                _la = self._input.LA(1)
                while _la==37:
                    self.state = 199
                    self.match(catlParser.COMMA)
                    self.state = 200
                    self.level()
                    self.state = 205
                    self._errHandler.sync(self)
                    _la = self._input.LA(1)

                self.state = 206
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
        self.enterRule(localctx, 38, self.RULE_interval)
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 210
            self.match(catlParser.LBRACKET)
            self.state = 211
            self.bound()
            self.state = 212
            self.match(catlParser.COMMA)
            self.state = 213
            self.bound()
            self.state = 214
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
        self.enterRule(localctx, 40, self.RULE_bound)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 217
            self._errHandler.sync(self)
            _la = self._input.LA(1)
            if _la==33:
                self.state = 216
                self.match(catlParser.MINUS)


            self.state = 219
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
        self.enterRule(localctx, 42, self.RULE_relation)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 221
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 2064384) != 0)):
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
        self.enterRule(localctx, 44, self.RULE_constant)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 223
            _la = self._input.LA(1)
            if not(_la==21 or _la==22):
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
        self.enterRule(localctx, 46, self.RULE_name)
        try:
            self.state = 228
            self._errHandler.sync(self)
            token = self._input.LA(1)
            if token in [43]:
                self.enterOuterAlt(localctx, 1)
                self.state = 225
                self.match(catlParser.NAME)
                pass
            elif token in [44]:
                self.enterOuterAlt(localctx, 2)
                self.state = 226
                self.match(catlParser.STRING)
                pass
            elif token in [1, 2, 3, 4, 5, 6, 7, 23, 24, 25, 26, 27, 28, 29]:
                self.enterOuterAlt(localctx, 3)
                self.state = 227
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
        self.enterRule(localctx, 48, self.RULE_word)
        self._la = 0 # Token type
        try:
            self.enterOuterAlt(localctx, 1)
            self.state = 230
            _la = self._input.LA(1)
            if not((((_la) & ~0x3f) == 0 and ((1 << _la) & 1065353216) != 0)):
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





