//! Macros that reach beyond themselves: what they stand for is not closed.

use super::{Macros, name};
use crate::notation::parse::takes_argument;

impl Macros {
    /// Whether a text ends with a command that asks for what stands behind it, or with a macro that stands for one.
    pub(super) fn ends_asking(&self, text: &str) -> bool {
        let mut text = text.trim_end();
        for _ in 0..20 {
            let command = text.rfind('\\').map_or("", |at| &text[at + 1..]);
            if command.is_empty() || !command.bytes().all(|b| b.is_ascii_alphabetic()) {
                return false;
            }
            match self.defined.get(command) {
                Some(called) => text = called.body.trim_end(),
                None => return takes_argument(command),
            }
        }
        false
    }

    /// Whether a text begins with a fraction, or with a macro that stands for one.
    pub(super) fn begins_fraction(&self, text: &str) -> bool {
        let mut text = text.trim_start();
        for _ in 0..20 {
            match self.defined.get(name(text)) {
                Some(called) => text = called.body.trim_start(),
                None => break,
            }
        }
        text.starts_with("\\frac")
    }
}
