//! Expressions of constants and symbols, with the precedence of the GNU assembler: `*` and shifts
//! before `|`, `&` and `^`, those before `+` and `-`, then comparisons, `&&`, `||`. All arithmetic
//! is on 64 bits, and right shifts insert zeros. A true comparison is -1.
//!
//! Invariant: the depth of an expression is limited, so that no source overflows the stack.

use crate::cursor::Cursor;
use crate::diagnostic::Fault;
use crate::symbols::{Definition, SymbolId, Symbols};

/// The maximum depth of an expression, and the maximum number of operators whose operands are
/// not numbers yet.
const DEPTH: u32 = 100;

/// An expression, which may use symbols that are not defined yet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Expression {
    Leaf(Value),
    Unary(char, Box<Self>),
    Binary(&'static str, Box<Self>, Box<Self>),
}

/// A number, plus the address of one place, minus that of another.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Value {
    pub plus: Option<Base>,
    pub minus: Option<Base>,
    pub number: i64,
}

/// A place whose address is not known yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Base {
    Symbol(SymbolId),
    Section(usize),
}

impl Value {
    pub(crate) const fn number(number: i64) -> Self {
        Self { plus: None, minus: None, number }
    }

    /// The number, if no place is part of it.
    pub(crate) fn constant(self) -> Option<i64> {
        (self.plus.is_none() && self.minus.is_none()).then_some(self.number)
    }
}

/// Binary operators, and how tightly they bind.
const OPERATORS: [(&str, u32); 20] = [
    ("<<", 6),
    (">>", 6),
    ("*", 6),
    ("/", 6),
    ("%", 6),
    ("&&", 2),
    ("||", 1),
    ("|", 5),
    ("&", 5),
    ("^", 5),
    ("==", 3),
    ("!=", 3),
    ("<>", 3),
    ("<=", 3),
    (">=", 3),
    ("!", 5),
    ("<", 3),
    (">", 3),
    ("+", 4),
    ("-", 4),
];

fn operator(cursor: &mut Cursor<'_>) -> Option<(&'static str, u32)> {
    cursor.skip_space();
    OPERATORS.into_iter().find(|(text, _)| cursor.rest().starts_with(text))
}

/// Reads an expression. `here` is the section and the offset that `.` means.
pub(crate) fn parse(
    cursor: &mut Cursor<'_>,
    symbols: &mut Symbols,
    here: (usize, u32),
) -> Result<Expression, Fault> {
    Parser { symbols, here, depth: 0, open: 0 }.binary(cursor, 1)
}

struct Parser<'a> {
    symbols: &'a mut Symbols,
    here: (usize, u32),
    depth: u32,
    open: u32,
}

impl Parser<'_> {
    fn binary(&mut self, cursor: &mut Cursor<'_>, minimum: u32) -> Result<Expression, Fault> {
        let at = cursor.at;
        let mut left = self.unary(cursor)?;
        while let Some((text, rank)) = operator(cursor).filter(|&(_, rank)| rank >= minimum) {
            cursor.take(text);
            let right = self.binary(cursor, rank + 1)?;
            left = Expression::Binary(text, Box::new(left), Box::new(right));
            match fold(&left, at)? {
                Some(folded) => left = folded,
                None => self.open += 1,
            }
            if self.open > DEPTH {
                return Err(Fault::new(at, "this expression is too long"));
            }
        }
        Ok(left)
    }

    fn unary(&mut self, cursor: &mut Cursor<'_>) -> Result<Expression, Fault> {
        let at = cursor.at;
        self.depth += 1;
        if self.depth > DEPTH {
            return Err(Fault::new(at, "this expression is too deep"));
        }
        let found = match cursor.peek() {
            Some(sign @ ('-' | '~' | '!' | '+')) => {
                cursor.at += 1;
                let made = Expression::Unary(sign, Box::new(self.unary(cursor)?));
                fold(&made, at)?.unwrap_or(made)
            }
            Some('(') => {
                cursor.at += 1;
                let inner = self.binary(cursor, 1)?;
                cursor.expect(")")?;
                inner
            }
            Some('\'') => {
                cursor.at += 1;
                Expression::Leaf(Value::number(cursor.character()?.into()))
            }
            Some('$') => return Err(cursor.unexpected("a constant")),
            Some(c) if c.is_ascii_digit() => self.number(cursor)?,
            _ => match cursor.name() {
                Some(".") => {
                    let (section, offset) = self.here;
                    let plus = Some(Base::Section(section));
                    Expression::Leaf(Value { plus, minus: None, number: offset.into() })
                }
                Some(name) => {
                    let id = self.symbols.mention(name, cursor.at - name.len());
                    Expression::Leaf(self.symbols.value(id))
                }
                None => return Err(cursor.unexpected("a constant or a symbol")),
            },
        };
        self.depth -= 1;
        Ok(found)
    }

    /// A number, or a reference to a numbered label.
    fn number(&mut self, cursor: &mut Cursor<'_>) -> Result<Expression, Fault> {
        let at = cursor.at;
        let text = cursor.digits();
        let (digits, direction) = text.split_at(text.len() - 1);
        if digits.bytes().all(|byte| byte.is_ascii_digit())
            && !digits.is_empty()
            && let "b" | "f" = direction
        {
            let id = self.symbols.numbered(digits, direction == "f", at)?;
            return Ok(Expression::Leaf(self.symbols.value(id)));
        }
        let lower = text.to_ascii_lowercase();
        let number = match lower.as_bytes() {
            [b'0', b'x', ..] => u64::from_str_radix(&lower[2..], 16),
            [b'0', b'b', ..] => u64::from_str_radix(&lower[2..], 2),
            [b'0', _, ..] => u64::from_str_radix(&lower[1..], 8),
            _ => lower.parse(),
        };
        match number {
            Ok(number) => Ok(Expression::Leaf(Value::number(number as i64))),
            Err(_) => Err(Fault::new(at, format!("{text} is no number of at most 64 bits"))),
        }
    }
}

/// The value of an operator whose operands are numbers.
fn fold(expression: &Expression, at: usize) -> Result<Option<Expression>, Fault> {
    let constant = |operand: &Expression| match operand {
        Expression::Leaf(value) => value.constant(),
        _ => None,
    };
    let folded = match expression {
        Expression::Unary(sign, a) => constant(a).map(|a| Ok(unary(*sign, a))),
        Expression::Binary(operator, a, b) => {
            constant(a).zip(constant(b)).map(|(a, b)| binary(operator, a, b))
        }
        Expression::Leaf(_) => None,
    };
    let folded = folded.transpose().map_err(|message| Fault::new(at, message))?;
    Ok(folded.map(|number| Expression::Leaf(Value::number(number))))
}

const fn unary(sign: char, a: i64) -> i64 {
    match sign {
        '-' => a.wrapping_neg(),
        '~' => !a,
        '!' => (a == 0) as i64,
        _ => a,
    }
}

fn binary(operator: &str, a: i64, b: i64) -> Result<i64, &'static str> {
    let truth = |holds: bool| -i64::from(holds);
    let shift = u32::try_from(b).unwrap_or(u32::MAX);
    Ok(match operator {
        "<<" => a.checked_shl(shift).unwrap_or(0),
        ">>" => (a as u64).checked_shr(shift).unwrap_or(0) as i64,
        "*" => a.wrapping_mul(b),
        "/" | "%" if b == 0 => return Err("division by 0"),
        "/" => a.wrapping_div(b),
        "%" => a.wrapping_rem(b),
        "|" => a | b,
        "&" => a & b,
        "^" => a ^ b,
        "!" => a | !b,
        "==" => truth(a == b),
        "!=" | "<>" => truth(a != b),
        "<" => truth(a < b),
        "<=" => truth(a <= b),
        ">" => truth(a > b),
        ">=" => truth(a >= b),
        "&&" => i64::from(a != 0 && b != 0),
        "||" => i64::from(a != 0 || b != 0),
        "+" => a.wrapping_add(b),
        _ => a.wrapping_sub(b),
    })
}

impl Symbols {
    /// The value of an expression by the definitions so far. Symbols without one stay in it.
    pub(crate) fn evaluate(&self, expression: &Expression) -> Result<Value, String> {
        match expression {
            Expression::Leaf(leaf) => {
                let value = Value::number(leaf.number);
                let value = leaf.plus.map_or(Ok(value), |base| self.sum(value, self.base(base), 1));
                leaf.minus.map_or(value.clone(), |base| self.sum(value?, self.base(base), -1))
            }
            Expression::Unary(sign, a) => {
                let a = self.evaluate(a)?;
                match (*sign, a.constant()) {
                    (sign, Some(a)) => Ok(Value::number(unary(sign, a))),
                    ('+', None) => Ok(a),
                    ('-', None) => self.sum(Value::default(), a, -1),
                    (sign, None) => Err(format!("the operand of {sign} must be a number")),
                }
            }
            Expression::Binary(operator, a, b) => {
                let (a, b) = (self.evaluate(a)?, self.evaluate(b)?);
                match (*operator, a.constant().zip(b.constant())) {
                    (operator, Some((a, b))) => Ok(Value::number(binary(operator, a, b)?)),
                    ("+", None) => self.sum(a, b, 1),
                    ("-", None) => self.sum(a, b, -1),
                    ("==" | "!=" | "<>" | "<" | "<=" | ">" | ">=", None)
                        if let Some(difference) = self.sum(a, b, -1)?.constant() =>
                    {
                        Ok(Value::number(binary(operator, difference, 0)?))
                    }
                    (operator, None) => Err(format!("the operands of {operator} must be numbers")),
                }
            }
        }
    }

    /// The value of a symbol or section: that of a symbol that is a number is the number.
    fn base(&self, base: Base) -> Value {
        if let Base::Symbol(id) = base
            && let Definition::Set(Expression::Leaf(value)) = self[id].definition
        {
            return value;
        }
        Value { plus: Some(base), minus: None, number: 0 }
    }

    /// The section and the offset of a base, if it has a place in this file.
    pub(crate) fn place(&self, base: Base) -> Option<(usize, i64)> {
        match base {
            Base::Section(section) => Some((section, 0)),
            Base::Symbol(id) => match self[id].definition {
                Definition::Label(section, offset) => Some((section, i64::from(offset))),
                _ => None,
            },
        }
    }

    /// `a + b` or `a - b`. Places in one section cancel each other.
    fn sum(&self, a: Value, b: Value, sign: i64) -> Result<Value, String> {
        let (plus, minus) = if sign > 0 { (b.plus, b.minus) } else { (b.minus, b.plus) };
        let mut number = a.number.wrapping_add(b.number.wrapping_mul(sign));
        let mut pluses: Vec<Base> = a.plus.into_iter().chain(plus).collect();
        let mut minuses: Vec<Base> = a.minus.into_iter().chain(minus).collect();
        pluses.retain(|&plus| {
            let same = |&minus: &Base| match (self.place(plus), self.place(minus)) {
                (Some((p, _)), Some((m, _))) => p == m,
                _ => plus == minus,
            };
            let Some(index) = minuses.iter().position(same) else { return true };
            let offset = |base| self.place(base).map_or(0, |(_, offset)| offset);
            let minus = minuses.remove(index);
            number = number.wrapping_add(offset(plus)).wrapping_sub(offset(minus));
            false
        });
        let (plus, minus) = (pluses.pop(), minuses.pop());
        if pluses.is_empty() && minuses.is_empty() {
            return Ok(Value { plus, minus, number });
        }
        Err("sums of addresses are not possible".to_owned())
    }
}
