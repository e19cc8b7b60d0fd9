//! What was worked out lately, kept in bounded memory.

use foldhash::HashMap;
use std::borrow::Borrow;
use std::hash::Hash;
use std::mem;

mod digest;

pub use digest::Digest;

/// A map that forgets what was not asked for lately.
///
/// It has two halves. When the new one is full it becomes the old one, and what was left in the old one is forgotten; what
/// is found in the old one moves into the new. So what is common stays, whatever comes between.
#[derive(Debug)]
pub struct Recent<K, V> {
    /// What the values of one half may weigh together.
    most: usize,
    weight: usize,
    new: HashMap<K, (V, usize)>,
    old: HashMap<K, (V, usize)>,
}

impl<K: Eq + Hash, V: Clone> Recent<K, V> {
    /// An empty one whose values weigh so much at most.
    pub fn of(most: usize) -> Self {
        Self {
            most: most / 2,
            weight: 0,
            new: HashMap::default(),
            old: HashMap::default(),
        }
    }

    /// The value of a key.
    pub fn get<Q: Eq + Hash + ?Sized>(&mut self, key: &Q) -> Option<V>
    where
        K: Borrow<Q>,
    {
        if let Some((value, _)) = self.new.get(key) {
            return Some(value.clone());
        }
        let (key, (value, weight)) = self.old.remove_entry(key)?;
        self.insert(key, value.clone(), weight);
        Some(value)
    }

    /// Keeps a value of this weight.
    pub fn insert(&mut self, key: K, value: V, weight: usize) {
        if self.weight + weight > self.most {
            self.old = mem::take(&mut self.new);
            self.weight = 0;
        }
        self.weight += weight;
        self.new.insert(key, (value, weight));
    }
}
