//! The symbols of a source.

use std::collections::{BTreeMap, HashMap};
use std::ops::{Index, IndexMut};

use crate::diagnostic::Fault;
use crate::expression::{Base, Expression, Value};
use crate::program::{Binding, SymbolKind};

/// The longest chain of symbols that are defined by others further below.
const PASSES: u32 = 100;

/// An index into [`Symbols`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct SymbolId(usize);

#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Definition {
    None,
    /// At an offset in a section.
    Label(usize, u32),
    /// By `.set`.
    Set(Expression),
    /// By `.comm`, with this alignment.
    Common(u32),
}

#[derive(Clone, Debug)]
pub(crate) struct SourceSymbol {
    pub name: String,
    pub definition: Definition,
    pub binding: Binding,
    pub kind: SymbolKind,
    pub size: Option<(usize, Expression)>,
    /// Where the source first has it.
    pub at: usize,
    /// It was defined by `.set`, and may be set again.
    pub assigned: bool,
    /// It is a numbered label, or the value that a name had before it got another.
    pub hidden: bool,
}

#[derive(Default)]
pub(crate) struct Symbols {
    all: Vec<SourceSymbol>,
    names: HashMap<String, SymbolId>,
    /// How often the source has defined each numbered label.
    numbered: HashMap<String, u32>,
    /// The numbered labels that it has mentioned.
    labels: BTreeMap<(String, u32), SymbolId>,
}

impl Index<SymbolId> for Symbols {
    type Output = SourceSymbol;

    fn index(&self, id: SymbolId) -> &SourceSymbol {
        &self.all[id.0]
    }
}

impl IndexMut<SymbolId> for Symbols {
    fn index_mut(&mut self, id: SymbolId) -> &mut SourceSymbol {
        &mut self.all[id.0]
    }
}

impl Symbols {
    pub(crate) fn iter(&self) -> impl Iterator<Item = (SymbolId, &SourceSymbol)> {
        self.all.iter().enumerate().map(|(index, symbol)| (SymbolId(index), symbol))
    }

    fn add(&mut self, name: &str, at: usize, hidden: bool) -> SymbolId {
        self.all.push(SourceSymbol {
            name: name.to_owned(),
            definition: Definition::None,
            binding: Binding::Local,
            kind: SymbolKind::None,
            size: None,
            at,
            assigned: false,
            hidden,
        });
        SymbolId(self.all.len() - 1)
    }

    /// The symbol with this name, which need not be defined yet.
    pub(crate) fn mention(&mut self, name: &str, at: usize) -> SymbolId {
        if let Some(&id) = self.names.get(name) {
            return id;
        }
        let id = self.add(name, at, false);
        self.names.insert(name.to_owned(), id);
        id
    }

    /// The value of a symbol as an operand: the number, if it is one already.
    pub(crate) fn value(&self, id: SymbolId) -> Value {
        match &self[id].definition {
            Definition::Set(Expression::Leaf(value)) if value.constant().is_some() => *value,
            _ => Value { plus: Some(Base::Symbol(id)), minus: None, number: 0 },
        }
    }

    /// The number that a name was set to, if it was.
    pub(crate) fn constant(&self, name: &str) -> Option<i64> {
        match &self[*self.names.get(name)?].definition {
            Definition::Set(expression) => self.known(expression),
            _ => None,
        }
    }

    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.names.keys().map(String::as_str)
    }

    /// The numbered label that `1b` or `1f` means here.
    pub(crate) fn numbered(
        &mut self,
        digits: &str,
        forward: bool,
        at: usize,
    ) -> Result<SymbolId, Fault> {
        let defined = self.numbered.get(digits).copied().unwrap_or(0);
        if !forward && defined == 0 {
            return Err(Fault::new(at, format!("there is no label {digits}: before this line")));
        }
        Ok(self.numbered_label(digits, defined + u32::from(forward), at))
    }

    fn numbered_label(&mut self, digits: &str, count: u32, at: usize) -> SymbolId {
        let key = (digits.to_owned(), count);
        if let Some(&id) = self.labels.get(&key) {
            return id;
        }
        let id = self.add(&format!("{digits}f"), at, true);
        self.labels.insert(key, id);
        id
    }

    /// Defines a label.
    pub(crate) fn define(
        &mut self,
        name: &str,
        place: (usize, u32),
        at: usize,
    ) -> Result<(), Fault> {
        let id = if name.starts_with(|c: char| c.is_ascii_digit()) {
            let count = self.numbered.entry(name.to_owned()).or_insert(0);
            *count += 1;
            let count = *count;
            self.numbered_label(name, count, at)
        } else {
            self.mention(name, at)
        };
        if !matches!(self[id].definition, Definition::None) {
            return Err(Fault::new(at, format!("{name} is defined already")));
        }
        self[id].definition = Definition::Label(place.0, place.1);
        Ok(())
    }

    /// Gives a name a value. What was read before keeps the name's former value.
    pub(crate) fn set(&mut self, name: &str, value: Expression, at: usize) -> Result<(), Fault> {
        let mut id = self.mention(name, at);
        if !matches!(self[id].definition, Definition::None) {
            if !self[id].assigned {
                return Err(Fault::new(at, format!("{name} is defined already")));
            }
            self[id].hidden = true;
            let former = self[id].clone();
            id = self.add(name, at, false);
            self[id] = SourceSymbol { hidden: false, ..former };
            self.names.insert(name.to_owned(), id);
        }
        self[id].assigned = true;
        self[id].at = at;
        self[id].definition = self.resolved(value);
        Ok(())
    }

    /// The simplest form of a symbol's value.
    fn resolved(&self, value: Expression) -> Definition {
        // What can't be evaluated may depend on symbols that are defined further below.
        let Ok(found) = self.evaluate(&value) else { return Definition::Set(value) };
        let place = found.plus.filter(|_| found.minus.is_none()).and_then(|base| self.place(base));
        if let Some((section, offset)) = place {
            return Definition::Label(section, offset.wrapping_add(found.number) as u32);
        }
        Definition::Set(if self.has_open(found) { value } else { Expression::Leaf(found) })
    }

    /// The number that an expression is, if it is known already.
    pub(crate) fn known(&self, expression: &Expression) -> Option<i64> {
        self.evaluate(expression).ok()?.constant()
    }

    fn has_open(&self, value: Value) -> bool {
        [value.plus, value.minus].into_iter().flatten().any(|base| self.is_open(base))
    }

    /// Whether a base is a symbol whose `.set` is not evaluated yet.
    pub(crate) fn is_open(&self, base: Base) -> bool {
        matches!(base, Base::Symbol(id) if matches!(self[id].definition, Definition::Set(_)))
    }

    /// Evaluates what was set to symbols that are defined further below. A few passes settle it,
    /// unless a symbol is defined by itself.
    pub(crate) fn settle(&mut self) -> Vec<Fault> {
        for _ in 0..PASSES {
            let mut changed = false;
            for index in 0..self.all.len() {
                if let Definition::Set(value) = &self.all[index].definition {
                    let definition = self.resolved(value.clone());
                    changed |= definition != self.all[index].definition;
                    self.all[index].definition = definition;
                }
            }
            if !changed {
                break;
            }
        }
        let fault = |symbol: &SourceSymbol| {
            let Definition::Set(value) = &symbol.definition else { return None };
            let message = match self.evaluate(value) {
                Err(message) => message,
                Ok(found) if self.has_open(found) => {
                    format!("{} is defined by itself", symbol.name)
                }
                Ok(_) => return None,
            };
            Some(Fault::new(symbol.at, message))
        };
        self.all.iter().filter_map(fault).collect()
    }
}
